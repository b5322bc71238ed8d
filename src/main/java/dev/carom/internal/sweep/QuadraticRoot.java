// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.DoubleDoubleNumber;

/**
 * The time at which a quadratic polynomial {@code k0 + k1 t + k2 t^2} falls to 0, in double-double.
 *
 * <p>In units of {@code u^2 = 2^-106}: if k0 errs by 147 of itself, the others by 64, the
 * discriminant errs by 219 of its terms {@code k1^2 + 4 |k0 k2|}: the square by 133, the product by
 * 216, their sum by 3 more. With the ratio of these terms to it, 1 or more, its root errs by 114 of
 * them, the sum with k1 by 118, and the quotient with k0 or k2 by 280 at most.
 */
final class QuadraticRoot {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The time, of itself and of the ratio: 280 u^2, and the rounding of this bound. */
  private static final double BOUND = 512 * 0x1p-106;

  /** Between these, no product of two coefficients and no tail of it underflows or overflows. */
  private static final double LEAST = 0x1p-200;

  private static final double MOST = 0x1p200;

  private QuadraticRoot() {}

  /**
   * The correctly rounded first time after the start from which on a polynomial falls and is not
   * above 0. It is above 0 at the start, or rises then. {@code +infinity} for none, NaN if
   * double-double does not tell.
   */
  static double fall(DoubleDoubleNumber k0, DoubleDoubleNumber k1, DoubleDoubleNumber k2) {
    if (k1.head() >= 0 && k2.head() >= 0) {
      return NEVER;
    }
    DoubleDoubleNumber square = k1.times(k1);
    DoubleDoubleNumber product = k0.times(k2).scaled(-4);
    DoubleDoubleNumber discriminant = square.plus(product);
    double terms = square.head() + Math.abs(product.head());
    double ratio = terms / discriminant.head();
    if (!(BOUND * Math.abs(ratio) < 1)) {
      return GapRoot.DOUBT; // the sign of the discriminant is not certain
    }
    if (ratio < 0) {
      return k0.head() < 0 ? rounded(k1.over(k2.scaled(-2)), BOUND) : NEVER;
    }
    DoubleDoubleNumber root = discriminant.root();
    DoubleDoubleNumber time =
        k1.head() < 0
            ? k0.scaled(2).over(root.plus(k1.scaled(-1)))
            : root.plus(k1).over(k2.scaled(-2));
    return rounded(time, BOUND * ratio);
  }

  /** A time, rounded, if that is certain with a relative error; NaN if not. */
  private static double rounded(DoubleDoubleNumber time, double bound) {
    double error = bound * time.head();
    double low = time.head() + (time.tail() - error);
    return low == time.head() + (time.tail() + error) ? low : GapRoot.DOUBT;
  }

  /** Whether a coefficient is within the range in which {@link #fall} holds. */
  static boolean isSafe(DoubleDoubleNumber k) {
    double size = Math.abs(k.head());
    return size == 0 || (size > LEAST && size < MOST);
  }
}
