// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.Fma.fma;

import java.util.function.ToIntFunction;

/**
 * The signs of the five polynomials on which every decision of a sweep rests. Vectors are given as
 * two points, head and tail, whose difference they are. Their coordinates are arguments, up to
 * fourteen, for the reason that {@code SegmentSweep} gives.
 *
 * <p>Each sign is first taken in plain doubles, if the value exceeds a bound of its rounding
 * errors. What that leaves open climbs the {@link ExactSigns}: double-double with a bound, sums
 * without rounding, exact numbers. Nothing is allocated up to double-double.
 *
 * <p>The bounds count roundings, each a factor {@code 1 + u} with {@code u = 2^-53}, of the sum of
 * the absolute values of the terms: a difference of coordinates has one. Fewer than 32 operations
 * lose at most 2^-1074 each by underflow, times the other factor of a product: {@link #TINY} times
 * the sum of the factors covers that.
 */
public final class Predicates {

  /** cross(p, q): differences 1 + 1, product 1, sum 1: 4 u, and two more. */
  private static final double CROSS_BOUND = 6 * 0x1p-53;

  /** p.p - r^2: p.p has 2 + 1 + 1, r^2 has 2 + 1, the difference 1: 5 u, and two more. */
  private static final double GAP_BOUND = 7 * 0x1p-53;

  /**
   * p.p r^2 - cross(p, q)^2: the square has 2 x 4 + 1, the other term (2 + 1 + 1) + (2 + 1) + 1,
   * the difference 1: 10 u, and two more.
   */
  private static final double DISCRIMINANT_BOUND = 12 * 0x1p-53;

  /**
   * x |x| w.w - y |y|, x = cross(d, s), y = r s.w: x has 4, its square 9, times w.w 9 + 4 + 1; y
   * has 4 + 1, its square 11; the difference 1: 15 u, and two more.
   */
  private static final double CORNER_BOUND = 17 * 0x1p-53;

  private static final double TINY = 0x1p-1000;

  static final int UNDECIDED = 2;

  private Predicates() {}

  /**
   * The sign of cross(a - b, c - d), where cross(a, b) = ax by - ay bx: on which side of the first
   * vector the second one points.
   */
  public static int cross(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    double px = ax - bx;
    double py = ay - by;
    double qx = cx - dx;
    double qy = cy - dy;
    double s = px * qy;
    double t = py * qx;
    double c = s - t;
    if (Math.abs(c) > fma(CROSS_BOUND, Math.abs(s) + Math.abs(t), TINY)) {
      return sign(c);
    }
    if ((px == 0 || qy == 0) && (py == 0 || qx == 0)) {
      return 0; // a difference of doubles rounds to 0 only if it is 0
    }
    int sign = bounded().cross(ax, ay, bx, by, cx, cy, dx, dy);
    return sign != UNDECIDED ? sign : exactly(of -> of.cross(ax, ay, bx, by, cx, cy, dx, dy));
  }

  /** The sign of (a - b).(c - d): dot(p, q) = cross(p, (-qy, qx)). */
  public static int dot(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    return cross(ax, ay, bx, by, dy, cx, cy, dx);
  }

  /** The sign of |a - b|^2 - (r + s)^2: whether two disks are apart. */
  public static int gap(double ax, double ay, double bx, double by, double r, double s) {
    double x = ax - bx;
    double y = ay - by;
    double z = r + s;
    double square = x * x + y * y;
    double gap = square - z * z;
    if (Math.abs(gap) > fma(GAP_BOUND, square + z * z, TINY)) {
      return sign(gap);
    }
    int sign = bounded().gap(ax, ay, bx, by, r, s);
    return sign != UNDECIDED ? sign : exactly(of -> of.gap(ax, ay, bx, by, r, s));
  }

  /**
   * The sign of |p|^2 (r + s)^2 - cross(p, q)^2 for p = a - b, q = c - d: positive if the line
   * through q along p passes the origin within r + s.
   */
  public static int discriminant(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy,
      double r, double s) {
    double px = ax - bx;
    double py = ay - by;
    double left = px * (cy - dy);
    double right = py * (cx - dx);
    double k = left - right;
    double m = Math.abs(left) + Math.abs(right);
    double z = r + s;
    double zz = z * z;
    double pp = px * px + py * py;
    double discriminant = pp * zz - k * k;
    double bound = fma(DISCRIMINANT_BOUND, pp * zz + m * m, TINY * (m + zz + pp + 1));
    if (Math.abs(discriminant) > bound) {
      return sign(discriminant);
    }
    int sign = bounded().discriminant(ax, ay, bx, by, cx, cy, dx, dy, r, s);
    return sign != UNDECIDED
        ? sign
        : exactly(of -> of.discriminant(ax, ay, bx, by, cx, cy, dx, dy, r, s));
  }

  /**
   * The sign of -side cross(d, s) |w| - r (s.w) for d = p - a, s = v - u, w = b - c: on which side
   * of the corner {@code a + side r n}, n the unit left normal of w, the path from p along s
   * passes. Both terms are squared with their signs, x |x|, which keeps their order and needs no
   * root.
   */
  public static int corner(
      int side, double px, double py, double ax, double ay, double vx, double vy, double ux,
      double uy, double bx, double by, double cx, double cy, double r) {
    double wx = bx - cx;
    double wy = by - cy;
    double sx = vx - ux;
    double sy = vy - uy;
    double x0 = (px - ax) * sy;
    double x1 = (py - ay) * sx;
    double y0 = sx * wx;
    double y1 = sy * wy;
    double x = -side * (x0 - x1);
    double y = r * (y0 + y1);
    double mx = Math.abs(x0) + Math.abs(x1);
    double my = r * (Math.abs(y0) + Math.abs(y1));
    double ww = wx * wx + wy * wy;
    double order = x * Math.abs(x) * ww - y * Math.abs(y);
    double bound =
        fma(
            CORNER_BOUND,
            mx * mx * ww + my * my,
            TINY * ((1 + mx) * (1 + mx + ww) + (1 + r) * (1 + my)));
    if (Math.abs(order) > bound) {
      return sign(order);
    }
    int sign = bounded().corner(side, px, py, ax, ay, vx, vy, ux, uy, bx, by, cx, cy, r);
    return sign != UNDECIDED
        ? sign
        : exactly(of -> of.corner(side, px, py, ax, ay, vx, vy, ux, uy, bx, by, cx, cy, r));
  }

  private static int sign(double value) {
    return value > 0 ? 1 : -1;
  }

  /** The signs in double-double, for a decision that plain doubles leave open. */
  private static ExactSigns<BoundedNumber> bounded() {
    PrecisionCounter.DOUBTFUL_DECISIONS.add();
    return BoundedNumber.signs();
  }

  /** The sign without rounding, by sums of doubles; by numbers if these over- or underflow. */
  private static int exactly(ToIntFunction<ExactSigns<?>> predicate) {
    int sign = predicate.applyAsInt(ExactSigns.SUMS);
    if (sign != UNDECIDED) {
      return sign;
    }
    PrecisionCounter.EXACT_DECISIONS.add();
    return predicate.applyAsInt(ExactSigns.NUMBERS);
  }
}
