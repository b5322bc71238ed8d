// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;

/**
 * A number in double-double with a bound of its error: the sum of the absolute values of the terms
 * that made it, before anything cancels.
 *
 * <p>A difference of two doubles has no error. In units of u^2 of the terms, with {@code u =
 * 2^-53}, a sum errs by 4 more than its summands, a product by 5 more than both factors together.
 * So {@link ExactSigns#cross} has 9, the gap 9 + 4, the discriminant 9 + 5 + 5 and 9 + 9 + 5 + 4 =
 * 27, and the corner {@code 2 x (9 + 5) + 5 + 9 + 5 + 4 = 51}.
 */
public record BoundedNumber(DoubleDoubleNumber value, double terms) implements Ring<BoundedNumber> {

  /** 51 u^2, and more for the rounding of the terms themselves. */
  private static final double BOUND = 64 * 0x1p-106;

  /** What underflows, 2^-1074 a product, is far below the bound of a term of at least this. */
  private static final double LEAST_TERM = 0x1p-900;

  /** a - b. */
  static BoundedNumber difference(double a, double b) {
    double d = a - b;
    return new BoundedNumber(new DoubleDoubleNumber(d, differenceTail(a, b, d)), Math.abs(d));
  }

  @Override
  public BoundedNumber plus(BoundedNumber that) {
    return new BoundedNumber(value.plus(that.value), terms + that.terms);
  }

  @Override
  public BoundedNumber minus(BoundedNumber that) {
    return new BoundedNumber(value.plus(that.value.negate()), terms + that.terms);
  }

  @Override
  public BoundedNumber times(BoundedNumber that) {
    double product = terms * that.terms;
    boolean isSafe = product >= LEAST_TERM || terms == 0 || that.terms == 0;
    return new BoundedNumber(value.times(that.value), isSafe ? product : Double.NaN);
  }

  /** The sign; {@link Predicates#UNDECIDED} if the bound leaves it open. */
  int sign() {
    boolean isCertain = Math.abs(value.head()) > BOUND * terms;
    return terms == 0 ? 0 : !isCertain ? Predicates.UNDECIDED : value.head() > 0 ? 1 : -1;
  }
}
