// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

/**
 * A number of about 106 bits, in double-double: the head is the double nearest to it, the tail the
 * rest. It has a bound of its error: the sum of the absolute values of the terms that made it,
 * before anything cancels.
 *
 * <p>A difference of two doubles has no error. In units of u^2 of the terms, with {@code u =
 * 2^-53}, a sum errs by 4 more than its summands, a product by 5 more than both factors together:
 * M. Joldes, J.-M. Muller and V. Popescu, Tight and rigorous error bounds for basic building blocks
 * of double-word arithmetic, ACM Transactions on Mathematical Software 44 (2017). So {@link
 * ExactSigns#cross} has 9, the gap 9 + 4, the discriminant 9 + 5 + 5 and 9 + 9 + 5 + 4 = 27, and
 * the corner {@code 2 x (9 + 5) + 5 + 9 + 5 + 4 = 51}.
 *
 * <p>For signs each thread has some numbers, which the next sign uses again: nothing is allocated.
 */
public final class BoundedNumber implements Ring<BoundedNumber> {

  /** 51 u^2, and more for the rounding of the terms themselves. */
  private static final double BOUND = 64 * 0x1p-106;

  /** What underflows, 2^-1074 a product, is far below the bound of a term of at least this. */
  private static final double LEAST_TERM = 0x1p-900;

  /** At least the numbers of one sign. */
  private static final int MOST = 32;

  private static final ThreadLocal<Signs> OF_THREAD = ThreadLocal.withInitial(Signs::new);

  /** The numbers that are used again; null for a number that is allocated, as are its results. */
  private final Signs signs;

  private double head;
  private double tail;
  private double terms;

  private BoundedNumber(Signs signs) {
    this.signs = signs;
  }

  /** The sum of a double and a much smaller one. */
  static BoundedNumber of(double head, double tail) {
    return new BoundedNumber(null).set(head, tail, Math.abs(head));
  }

  double head() {
    return head;
  }

  double tail() {
    return tail;
  }

  /** The sum of the absolute values of the terms; NaN if something may have underflowed. */
  double terms() {
    return terms;
  }

  /** The signs in these numbers, for the next question of this thread. */
  static ExactSigns<BoundedNumber> signs() {
    Signs signs = OF_THREAD.get();
    signs.used = 0;
    return signs;
  }

  private static final class Signs extends ExactSigns<BoundedNumber> {
    private final BoundedNumber[] numbers = new BoundedNumber[MOST];
    private int used;

    Signs() {
      for (int i = 0; i < MOST; i++) {
        numbers[i] = new BoundedNumber(this);
      }
    }

    @Override
    BoundedNumber difference(double a, double b) {
      double d = a - b;
      return numbers[used++].set(d, differenceTail(a, b, d), Math.abs(d));
    }

    @Override
    int sign(BoundedNumber value) {
      return value.sign();
    }
  }

  private BoundedNumber next() {
    return signs == null ? new BoundedNumber(null) : signs.numbers[signs.used++];
  }

  private BoundedNumber set(double newHead, double newTail, double newTerms) {
    head = newHead + newTail;
    tail = newTail - (head - newHead);
    terms = newTerms;
    return this;
  }

  private int sign() {
    boolean isCertain = Math.abs(head) > BOUND * terms;
    return terms == 0 ? 0 : !isCertain ? Predicates.UNDECIDED : head > 0 ? 1 : -1;
  }

  @Override
  public BoundedNumber plus(BoundedNumber that) {
    return plus(1, that);
  }

  @Override
  public BoundedNumber minus(BoundedNumber that) {
    return plus(-1, that);
  }

  private BoundedNumber plus(int sign, BoundedNumber that) {
    double other = sign * that.head;
    double otherTail = sign * that.tail;
    double sum = head + other;
    double tails = tail + otherTail;
    double rest = sumTail(head, other, sum) + tails;
    double near = sum + rest;
    rest = (rest - (near - sum)) + sumTail(tail, otherTail, tails);
    return next().set(near, rest, terms + that.terms);
  }

  @Override
  public BoundedNumber times(BoundedNumber that) {
    double product = head * that.head;
    double crossed = fma(head, that.tail, tail * that.head);
    double size = terms * that.terms;
    boolean isSafe = size >= LEAST_TERM || terms == 0 || that.terms == 0;
    double rest = productTail(head, that.head, product) + crossed;
    return next().set(product, rest, isSafe ? size : Double.NaN);
  }
}
