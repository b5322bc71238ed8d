// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

import java.util.function.ToIntFunction;

/**
 * The signs of the five polynomials on which every decision of a sweep rests. Vectors are given as
 * two points, head and tail, whose difference they are.
 *
 * <p>Each sign is first taken in plain doubles, if the value exceeds a bound of its rounding
 * errors. What that leaves open is evaluated in double-double with a bound, and then without
 * rounding ({@link ExactSigns}).
 *
 * <p>The bounds count roundings, each a factor {@code 1 + u} with {@code u = 2^-53}, of the sum of
 * the absolute values of the terms: a difference of coordinates has one. Fewer than 32 operations
 * lose at most 2^-1074 each by underflow, times the other factor of a product: {@link #TINY} times
 * the sum of the factors covers that.
 *
 * <p>The bound in double-double. Let M be the sum of the absolute values of a polynomial's
 * terms. Differences are exact as head and tail. A cross or dot product errs by at most 64 u^2 M
 * ({@link DoubleDouble#crossTail}), a product of two double-doubles by 32 u^2 of itself (tails up
 * to 4u here), a sum of two by 4 u^2 of its terms. So a square of a cross product errs by 2 x 64 +
 * 32 = 160 u^2 M^2, its product with a squared length by 64 + 32 more, and each polynomial by less
 * than 400 u^2 M in all: {@link #CLOSE_BOUND} is 512 u^2.
 *
 * <p>Underflow takes at most 2^-1074 from each of fewer than 64 operations; no factor that
 * multiplies such an error exceeds {@link #LARGE}, so all of it stays below 2^-1074 2^6 2^300 =
 * 2^-768, beneath the bound for {@code M >= LEAST_TERMS}. Overflow makes M infinite or NaN and leaves the
 * sign open.
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

  /** 512 u^2 = 2^9 2^-106. */
  private static final double CLOSE_BOUND = 0x1p-97;

  /** The least sum of terms whose bound exceeds all underflow: 2^-97 2^-600 > 2^-768. */
  private static final double LEAST_TERMS = 0x1p-600;

  /** Largest factor of a term. */
  private static final double LARGE = 0x1p300;

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
    // A difference of doubles rounds to 0 only if it is 0.
    return (px == 0 || qy == 0) && (py == 0 || qx == 0)
        ? 0
        : crossInDoubt(ax, ay, bx, by, cx, cy, dx, dy);
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
    return Math.abs(gap) > fma(GAP_BOUND, square + z * z, TINY)
        ? sign(gap)
        : gapInDoubt(ax, ay, bx, by, r, s);
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
    return Math.abs(discriminant) > bound
        ? sign(discriminant)
        : discriminantInDoubt(ax, ay, bx, by, cx, cy, dx, dy, r, s);
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
    return Math.abs(order) > bound
        ? sign(order)
        : cornerInDoubt(side, px, py, ax, ay, vx, vy, ux, uy, bx, by, cx, cy, r);
  }

  private static int sign(double value) {
    return value > 0 ? 1 : -1;
  }

  // What plain doubles leave open: in double-double with a bound, then without rounding.

  private static int crossInDoubt(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    int sign = crossClosely(ax, ay, bx, by, cx, cy, dx, dy);
    return sign != UNDECIDED ? sign : exactly(of -> of.cross(ax, ay, bx, by, cx, cy, dx, dy));
  }

  private static int gapInDoubt(double ax, double ay, double bx, double by, double r, double s) {
    int sign = gapClosely(ax, ay, bx, by, r, s);
    return sign != UNDECIDED ? sign : exactly(of -> of.gap(ax, ay, bx, by, r, s));
  }

  private static int discriminantInDoubt(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy,
      double r, double s) {
    int sign = discriminantClosely(ax, ay, bx, by, cx, cy, dx, dy, r, s);
    return sign != UNDECIDED ? sign : exactly(of -> of.discriminant(ax, ay, bx, by, cx, cy, dx, dy, r, s));
  }

  private static int cornerInDoubt(
      int side, double px, double py, double ax, double ay, double vx, double vy, double ux,
      double uy, double bx, double by, double cx, double cy, double r) {
    int sign = cornerClosely(side, px, py, ax, ay, vx, vy, ux, uy, bx, by, cx, cy, r);
    return sign != UNDECIDED ? sign : exactly(of -> of.corner(side, px, py, ax, ay, vx, vy, ux, uy, bx, by, cx, cy, r));
  }

  private static int crossClosely(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    double px = ax - bx;
    double py = ay - by;
    double qx = cx - dx;
    double qy = cy - dy;
    double s = px * qy;
    double t = py * qx;
    double c = s - t;
    double value =
        c
            + crossTail(
                px,
                differenceTail(ax, bx, px),
                py,
                differenceTail(ay, by, py),
                qx,
                differenceTail(cx, dx, qx),
                qy,
                differenceTail(cy, dy, qy),
                c);
    return decided(value, Math.abs(s) + Math.abs(t), 1);
  }

  private static int gapClosely(double ax, double ay, double bx, double by, double r, double s) {
    double x = ax - bx;
    double y = ay - by;
    double z = r + s;
    double xx = x * x;
    double yy = y * y;
    double zz = z * z;
    double xl = differenceTail(ax, bx, x);
    double yl = differenceTail(ay, by, y);
    double zl = sumTail(r, s, z);
    double sum = xx + yy;
    double value = sum - zz;
    double tail =
        (sumTail(xx, yy, sum) + differenceTail(sum, zz, value))
            + ((productTail(x, xl, x, xl, xx) + productTail(y, yl, y, yl, yy))
                - productTail(z, zl, z, zl, zz));
    return decided(value + tail, sum + zz, 1);
  }

  private static int discriminantClosely(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy,
      double r, double s) {
    double px = ax - bx;
    double py = ay - by;
    double pxl = differenceTail(ax, bx, px);
    double pyl = differenceTail(ay, by, py);
    double qx = cx - dx;
    double qy = cy - dy;
    double k0 = px * qy - py * qx;
    double k1 =
        crossTail(
            px, pxl, py, pyl, qx, differenceTail(cx, dx, qx), qy, differenceTail(cy, dy, qy), k0);
    double k = k0 + k1;
    double kl = sumTail(k0, k1, k);
    double a0 = px * px + py * py;
    double a1 = dotTail(px, pxl, py, pyl, a0);
    double z = r + s;
    double zl = sumTail(r, s, z);
    double zz = z * z;
    double zzl = productTail(z, zl, z, zl, zz);
    double f = a0 * zz;
    double fl = productTail(a0, a1, zz, zzl, f);
    double g = k * k;
    double gl = productTail(k, kl, k, kl, g);
    double value = f - g;
    double terms = Math.abs(px * qy) + Math.abs(py * qx);
    return decided(
            value + (differenceTail(f, g, value) + (fl - gl)),
            f + terms * terms,
            Math.max(Math.max(a0, zz), terms));
  }

  private static int cornerClosely(
      int side, double px, double py, double ax, double ay, double vx, double vy, double ux,
      double uy, double bx, double by, double cx, double cy, double r) {
    double sx = vx - ux;
    double sy = vy - uy;
    double sxl = differenceTail(vx, ux, sx);
    double syl = differenceTail(vy, uy, sy);
    double dx = px - ax;
    double dy = py - ay;
    double wx = bx - cx;
    double wy = by - cy;
    double wxl = differenceTail(bx, cx, wx);
    double wyl = differenceTail(by, cy, wy);
    // x = -side cross(d, s)
    double x0 = dx * sy - dy * sx;
    double x1 =
        crossTail(
            dx, differenceTail(px, ax, dx), dy, differenceTail(py, ay, dy), sx, sxl, sy, syl, x0);
    double x = x0 + x1;
    double xl = sumTail(x0, x1, x);
    // y = s.w = cross(s, (-wy, wx))
    double y0 = sx * wx - sy * -wy;
    double y1 = crossTail(sx, sxl, sy, syl, -wy, -wyl, wx, wxl, y0);
    double y = y0 + y1;
    double yl = sumTail(y0, y1, y);
    // f = x |x| |w|^2, g = r^2 y |y|
    double ww = wx * wx + wy * wy;
    double wwl = dotTail(wx, wxl, wy, wyl, ww);
    double xx = x * x;
    double xxl = productTail(x, xl, x, xl, xx);
    double f = xx * ww;
    double fl = productTail(xx, xxl, ww, wwl, f);
    double rr = r * r;
    double rrl = productTail(r, r, rr);
    double yy = y * y;
    double yyl = productTail(y, yl, y, yl, yy);
    double g = rr * yy;
    double gl = productTail(rr, rrl, yy, yyl, g);
    double sf = -side * Math.signum(x);
    double sg = -Math.signum(y);
    double value = sf * f + sg * g;
    double mx = Math.abs(dx * sy) + Math.abs(dy * sx);
    double my = Math.abs(sx * wx) + Math.abs(sy * wy);
    return decided(
            value + (sumTail(sf * f, sg * g, value) + (sf * fl + sg * gl)),
            mx * mx * ww + rr * (my * my),
            Math.max(Math.max(mx * mx, ww), Math.max(rr, my * my)));
  }

  /** The tail of |p|^2 for its head h = fl(fl(px px) + fl(py py)). */
  private static double dotTail(double px, double pxl, double py, double pyl, double h) {
    double xx = px * px;
    double yy = py * py;
    return sumTail(xx, yy, h)
        + (productTail(px, pxl, px, pxl, xx) + productTail(py, pyl, py, pyl, yy));
  }

  /** The sign of a value with terms of the given sum; UNDECIDED if the bound does not allow it. */
  private static int decided(double value, double terms, double factor) {
    boolean isCertain =
        terms >= LEAST_TERMS && factor <= LARGE && Math.abs(value) > CLOSE_BOUND * terms;
    PrecisionCounters.doubt();
    return isCertain ? sign(value) : UNDECIDED;
  }

  /** The sign without rounding, by sums of doubles; by numbers if these over- or underflow. */
  private static int exactly(ToIntFunction<ExactSigns<?>> predicate) {
    int sign = predicate.applyAsInt(ExactSigns.SUMS);
    if (sign != UNDECIDED) {
      return sign;
    }
    PrecisionCounters.exactNumbers();
    return predicate.applyAsInt(ExactSigns.NUMBERS);
  }
}
