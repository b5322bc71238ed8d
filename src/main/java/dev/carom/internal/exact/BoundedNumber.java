// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

import java.util.Arrays;

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
 * the corner {@code 2 x (9 + 5) + 5 + 9 + 5 + 4 = 51}. In {@link TurningGaps} an offset has 18 and
 * c^2 27, the line W 36, the height 67, the gap of a side 143 and that of an end 95.
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

  /** At least those of one equation of {@link TurningGaps}. */
  private static final int MOST_AT_A_TIME = 192;

  private static final ThreadLocal<Signs> OF_THREAD = ThreadLocal.withInitial(Signs::new);

  /** The numbers that are used again; null for a number that is allocated, as are its results. */
  private final Pool pool;

  private double head;
  private double tail;
  private double terms;

  private BoundedNumber(Pool pool) {
    this.pool = pool;
  }

  private static final class Pool {
    private final BoundedNumber[] numbers;
    private int used;

    Pool(int most) {
      numbers = new BoundedNumber[most];
      Arrays.setAll(numbers, i -> new BoundedNumber(this));
    }

    BoundedNumber next() {
      return numbers[used++];
    }

    BoundedNumber difference(double a, double b) {
      double d = a - b;
      return next().set(d, differenceTail(a, b, d), Math.abs(d));
    }
  }

  /** The values of {@link Gaps} at a time, instead of polynomials. */
  public static final class AtTime implements Numbers<BoundedNumber> {
    private final Pool pool = new Pool(MOST_AT_A_TIME);
    private BoundedNumber t;

    /** Sets the time, a sum. The values at the time before are used again. */
    public AtTime at(double head, double tail) {
      pool.used = 0;
      t = pool.next().set(head, tail, Math.abs(head));
      return this;
    }

    @Override
    public BoundedNumber motion(double p, double q, double v, double u, double g) {
      BoundedNumber mean = pool.difference(0.5, 0).times(pool.difference(g, 0)).times(t);
      return difference(p, q).plus(difference(v, u).plus(mean).times(t));
    }

    @Override
    public BoundedNumber line(double p, double q, double v) {
      return difference(p, q).plus(difference(v, 0).times(t));
    }

    @Override
    public BoundedNumber difference(double p, double q) {
      return pool.difference(p, q);
    }
  }

  /** The sum of a double and a much smaller one. */
  static BoundedNumber of(double head, double tail) {
    return new BoundedNumber(null).set(head, tail, Math.abs(head));
  }

  public double head() {
    return head;
  }

  public double tail() {
    return tail;
  }

  /** The sum of the absolute values of the terms; NaN if something may have underflowed. */
  public double terms() {
    return terms;
  }

  /** The signs in these numbers, for the next question of this thread. */
  static ExactSigns<BoundedNumber> signs() {
    Signs signs = OF_THREAD.get();
    signs.numbers.used = 0;
    return signs;
  }

  private static final class Signs extends ExactSigns<BoundedNumber> {
    private final Pool numbers = new Pool(MOST);

    @Override
    BoundedNumber difference(double a, double b) {
      return numbers.difference(a, b);
    }

    @Override
    int sign(BoundedNumber value) {
      return value.sign();
    }
  }

  private BoundedNumber next() {
    return pool == null ? new BoundedNumber(null) : pool.next();
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
