// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Predicates;

/**
 * When does a moving point first come to the distance r from a resting one? The sweeps of disks
 * and of spheres share this question. With the offset d and the velocity u, in two dimensions or
 * three, the answer is the smaller root t of
 *
 * <pre>
 *   |d + u t|^2 - r^2 = a t^2 + 2 b t + g = 0    a = u.u,  b = u.d,  g = d.d - r^2
 *   b^2 - a g = a r^2 - |cross(u, d)|^2 =: discriminant
 * </pre>
 *
 * The distance is convex in t, so: moving apart or not at all (b >= 0) is a miss; else overlapping
 * or touching (g <= 0) is an impact now; else discriminant > 0 is an impact later, at the smaller
 * root, and discriminant = 0 a graze, which is none, unless r = 0: then the point runs into the
 * other.
 *
 * <p>Decisions are the signs of b, g and discriminant. Each is taken in plain doubles if the value
 * exceeds a bound of its rounding errors, and is asked of {@link Predicates} if not. The bounds
 * count roundings, each a factor {@code 1 + u} with {@code u = 2^-53}, for three dimensions: a
 * difference of coordinates has one, a sum of three terms two; and they are relative to the sum of
 * the absolute values of the terms, or to what that cannot exceed, which is itself computed. The
 * form of discriminant is the one that does not cancel.
 *
 * <p>The time is the plain root, corrected by steps {@code c = f / 2 s}: f is the polynomial's
 * value there, kept as head and tail, and s half its slope, with the sign changed. The first step
 * takes {@code s = sqrt(discriminant)}, the slope at the root itself; others, {@code s = -(b + a
 * t)}. What the first step leaves open goes to numbers without rounding, {@link GapPolynomial}.
 */
public final class TimeOfImpact {

  /** b: differences 1 + 1, product 1, sums 2: 5 u, and one more for second order and the sum. */
  private static final double DOT_BOUND = 6 * 0x1p-53;

  /** g: d.d has 2 + 1 + 2, r^2 has 2 + 1, the difference 1: 6 u, and one more. */
  private static final double GAP_BOUND = 7 * 0x1p-53;

  /**
   * discriminant, of {@code a (d.d + r^2)}: a has 2 + 1 + 2, r^2 has 3, their product 1: 9 u of a
   * r^2. A component of the cross product errs by 4 u of its terms' sum M, its square by 8 + 1 u of
   * M^2; the M^2 add up to 4/3 a d.d at most (to a d.d in the plane, by Cauchy); the sums take 2,
   * of a d.d: 14 u. The difference 1: 15 u, and two more.
   */
  private static final double DISCRIMINANT_BOUND = 17 * 0x1p-53;

  /**
   * Underflow: fewer than 32 operations lose at most 2^-1074 each, times the other factor of a
   * product; it is covered by this times the sum of the factors and 1.
   */
  public static final double TINY = 0x1p-1000;

  /** f, of d.d + r^2: see {@link #stepError}. */
  private static final double PLACE_BOUND = 512 * 0x1p-106;

  private TimeOfImpact() {}

  /** x^2 + y^2 - r^2 of numbers with tails. */
  static double gap(double x, double xl, double y, double yl, double r, double rl) {
    double xx = x * x;
    double yy = y * y;
    double rr = r * r;
    double ee = xx + yy;
    double f = ee - rr;
    return f
        + ((sumTail(xx, yy, ee) + differenceTail(ee, rr, f))
            + ((productTail(x, x, xx) + productTail(y, y, yy)) - productTail(r, r, rr))
            + 2 * (x * xl + y * yl - r * rl));
  }

  static double dotBound(double terms) {
    return fma(DOT_BOUND, terms, TINY);
  }

  /** The error bound of g, from w = d.d + r^2. */
  static double gapBound(double w) {
    return fma(GAP_BOUND, w, TINY);
  }

  static double discriminantBound(double a, double w) {
    return fma(DISCRIMINANT_BOUND, a * w, TINY * (a + w + 1));
  }

  /**
   * The relative error of {@code s = sqrt(discriminant)}, and of the step: at most 0.54 times that
   * of discriminant, while that is below 1/4. Taken whole, it leaves 17 u x 0.46 and more for f's
   * own rounding, the root, the division and the product, 4 u.
   *
   * @param half 1 / 2 s
   */
  private static double firstLean(double a, double w, double half) {
    return 4 * discriminantBound(a, w) * half * half;
  }

  /**
   * The relative error of {@code s = -(b + a t)}, and of the step; NaN if s may be 0. The terms of
   * b err by 5 u, a t by 6 u, the sum 1; f's own rounding, the division and the product take 3 u:
   * in all 10 u of the terms, over s, and at most 14 u by the quarter of {@link #stepError}. Four
   * times the bound of b covers that.
   *
   * @param half 1 / 2 s
   * @param terms the sum of the absolute values of the terms of b and of a t
   */
  static double lean(double half, double terms, double t) {
    return half > 0 ? 8 * (dotBound(terms) + TINY * t) * half : Double.NaN;
  }

  /**
   * A bound of the error of a step {@code c = f / 2 s} from t to the root; NaN where none is known.
   *
   * <p>Let S be the sum of r^2 and of all X^2, {@code X = |d| + |u t|} on an axis. The tail of a
   * place d + u t is below 3 u X and loses 7 u^2 X; so the squares lose 23 u^2 X^2 by what is left
   * out, and the sums of tails, each below 6 u S, 46 u^2 S: f loses 69 u^2 S. While t is before the
   * polynomial's vertex, {@code a t^2 <= d.d}; therefore {@code S <= 4 (d.d + r^2) = 4 w}.
   *
   * <p>The root is {@code c* = f / (2 s* + a c*)} away, s* the slope there (with -a c* if s is the
   * slope at t). So c errs by what s does, the lean, and by {@code a |c| / 2 s}, the bend, each in
   * proportion; these must be below 1/4 in all, and then divide by 0.7 at least: f's share is below
   * 69 x 4 / 0.7 u^2 w / 2 s, less than 512 u^2, and twice the bend is enough.
   *
   * <p>A first t is before the vertex, which is s* / a after the root, for {@code lean < 1/4}: then
   * {@code 17 u a w < s^2 / 4}, and the errors of g, 7 u w, and of s, below 0.14 s, over {@code
   * |b| >= s}, move it by less than s / 4 a; the others are far below.
   *
   * @param half 1 / 2 s
   * @param lean the error of s, in proportion
   */
  static double stepError(double w, double a, double half, double lean, double c) {
    double size = Math.abs(c);
    double turn = lean + 2 * a * half * size;
    if (!(turn < 0.25)) {
      return Double.NaN;
    }
    return fma(size, turn, fma(fma(PLACE_BOUND, w, TINY), half, TINY));
  }

  /**
   * The root near t, by the first step, to the nearest double; NaN if the error of the step leaves
   * that open.
   *
   * @param f the polynomial's value at t
   * @param half 1 / 2 s, s the root of the discriminant
   */
  static double corrected(double t, double f, double a, double w, double half) {
    double c = f * half;
    double error = stepError(w, a, half, firstLean(a, w, half), c);
    double low = t + (c - error);
    // All values in between round alike, and this one is available earlier.
    return low == t + (c + error) ? t + c : Double.NaN;
  }
}
