// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.Fma.fma;

/**
 * Double-double arithmetic: the rounding errors of operations on doubles. A value of about 106 bits
 * is kept as two doubles, head and tail. The head is the rounded result; the tail is what these
 * functions return.
 *
 * <p>The differences and products of two doubles are represented exactly so, as long as nothing
 * underflows. Sources: T. J. Dekker, A floating-point technique for extending the available
 * precision, Numerische Mathematik 18 (1971); D. E. Knuth, The Art of Computer Programming 2,
 * 4.2.2. In the bounds of this package {@code u = 2^-53} is the largest relative error of one
 * operation.
 */
public final class DoubleDouble {

  private DoubleDouble() {}

  /** a + b - s exactly, for s = fl(a + b). Knuth's two-sum; do not simplify. */
  public static double sumTail(double a, double b, double s) {
    double bb = s - a;
    return (a - (s - bb)) + (b - bb);
  }

  /** a - b - d exactly, for d = fl(a - b). */
  public static double differenceTail(double a, double b, double d) {
    double bb = d - a;
    return (a - (d - bb)) - (b + bb);
  }

  /** a b - p exactly, for p = fl(a b). */
  public static double productTail(double a, double b, double p) {
    return fma(a, b, -p);
  }

  /**
   * The tail of (a + al) (b + bl) for p = fl(a b) and tails |al| <= 2u|a|, |bl| <= 2u|b|. The
   * omitted al bl and the rounding of the result are below 16 u^2 |a b|.
   */
  public static double productTail(double a, double al, double b, double bl, double p) {
    return fma(a, b, -p) + (a * bl + al * b);
  }

  /**
   * The tail of cross(a, b) = ax by - ay bx for c = fl(fl(ax by) - fl(ay bx)) and tails of at most
   * 2u of their heads. It leaves out products of two tails, 4 u^2 each, and rounds ten terms of at
   * most 4u: the error is below 64 u^2 (|ax by| + |ay bx|). Vectors with tails as objects would have
   * to be allocated.
   */
  public static double crossTail(
      double ax, double axl, double ay, double ayl, double bx, double bxl, double by, double byl,
      double c) {
    double p = ax * by;
    double q = ay * bx;
    return differenceTail(p, q, c)
        + ((productTail(ax, by, p) - productTail(ay, bx, q))
            + ((ax * byl + axl * by) - (ay * bxl + ayl * bx)));
  }
}
