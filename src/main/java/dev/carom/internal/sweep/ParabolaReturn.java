// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.PrecisionCounters;

/**
 * When a disk with a constant acceleration comes back to the thing that it has just hit.
 *
 * <p>Its gap at the start is 0 by definition, whatever its rounded place says. So the gap is counted
 * from there, and its root at time 0 is divided out, exactly. A speed along the normal that is
 * negative counts as 0: it is a rounding error of the response. Without that speed the acceleration
 * decides: inward, the answer is 0, for the disk is supported; outward, it leaves.
 */
public final class ParabolaReturn {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * The quotient of two cross products, each of which errs by 64 u^2 of its terms; the remainder and
   * its quotient by a few u of themselves.
   */
  private static final double CROSS_BOUND = 128 * 0x1p-106;

  private static final double STEP_BOUND = 8 * 0x1p-53;

  private static final double LEAST_SAFE = 0x1p-400;

  private static final double MOST_SAFE = 0x1p400;

  private ParabolaReturn() {}

  /**
   * The correctly rounded time of the return to a wall, {@code -2 v / g}; {@code +infinity} for none
   * up to the window's end T.
   *
   * @param inward +1 if the disk is above the wall, -1 if below
   */
  public static double toWall(double v, double g, int inward, double T) {
    if (!(inward * g < 0)) {
      return NEVER;
    }
    if (!(inward * v > 0)) {
      return 0;
    }
    double t = 2 * v / -g;
    // A rounded time of T itself may be that of a later one.
    if (t > LEAST_SAFE && t < MOST_SAFE && t != T) {
      return t < T ? t : NEVER;
    }
    return ExactParabola.returnToWall(v, g, inward).time(T);
  }

  /**
   * The correctly rounded time of the return to the height above the infinite line at which the disk
   * starts, {@code -2 n.v / n.g}; {@code +infinity} for none up to the window's end T. It may then be
   * beyond an end.
   *
   * @param side +1 if the disk is left of the line, -1 if right
   */
  public static double toSide(
      int side, double vx, double vy, double gx, double gy, double ax, double ay, double bx,
      double by, double T) {
    if (side * Predicates.cross(bx, by, ax, ay, gx, gy, 0, 0) >= 0) {
      return NEVER;
    }
    if (side * Predicates.cross(bx, by, ax, ay, vx, vy, 0, 0) <= 0) {
      return 0;
    }
    double wx = bx - ax;
    double wy = by - ay;
    double wxl = differenceTail(bx, ax, wx);
    double wyl = differenceTail(by, ay, wy);
    double n = 2 * (wx * vy - wy * vx);
    double nl = 2 * crossTail(wx, wxl, wy, wyl, vx, 0, vy, 0, 0.5 * n);
    double d = wy * gx - wx * gy;
    double dl = -crossTail(wx, wxl, wy, wyl, gx, 0, gy, 0, -d);
    double t = n / d;
    double step = (Math.fma(-t, d, n) + (nl - t * dl)) / d;
    double terms =
        2 * (Math.abs(wx * vy) + Math.abs(wy * vx))
            + t * (Math.abs(wx * gy) + Math.abs(wy * gx));
    double error = Math.fma(STEP_BOUND, Math.abs(step), CROSS_BOUND * (terms / Math.abs(d)));
    double low = t + (step - error);
    boolean isCertain =
        low == t + (step + error)
            && low != T
            && low > LEAST_SAFE
            && Math.abs(d) > LEAST_SAFE
            && t * terms < MOST_SAFE
            && terms > LEAST_SAFE
            && terms < MOST_SAFE;
    if (isCertain) {
      return low < T ? low : NEVER;
    }
    return ExactParabola.returnToSide(side, vx, vy, gx, gy, ax, ay, bx, by).time(T);
  }

  /**
   * The correctly rounded time of the return to a disk that moves straight on, or an endpoint: the
   * first one at which their distance falls below that at the start. {@code +infinity} for none up to
   * the window's end T.
   *
   * <p>With {@code e = u + g t / 2} the gap over time is {@code e.(2 d + t e)}, a cubic polynomial.
   */
  public static double toDisk(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2, double T) {
    PrecisionCounters.parabola();
    double time = certain(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2, T);
    return !Double.isNaN(time)
        ? time
        : ExactParabola.returnToDisk(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2).time(T);
  }

  private static double certain(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2, double T) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double c1 = 2 * (dx * ux + dy * uy);
    double c2 = (ux * ux + uy * uy) + (dx * gx + dy * gy);
    double c3 = ux * gx + uy * gy;
    double c4 = 0.25 * (gx * gx + gy * gy);
    double d = Math.abs(dx) + Math.abs(dy);
    double u = Math.abs(ux) + Math.abs(uy);
    double g = Math.abs(gx) + Math.abs(gy);
    // (m0 + m1 t + m2 t^2)^2 exceeds the terms 2 d u, u u + d g, u g and g g / 4 one by one.
    double m0 = Math.sqrt(2 * d * u);
    double m1 = (u * u + d * g) / (2 * m0);
    double m2 = u * g / (2 * m0);
    double reach = GapRoot.reach(2 * d, u, 0.5 * Math.max(Math.abs(gx), Math.abs(gy)), T);
    if (GapRoot.sign(c1, m0 * m0) <= 0) {
      return GapRoot.DOUBT;
    }
    double t = GapRoot.first(c1, c2, c3, c4, 0, m0, m1, m2, 0, reach);
    if (!(t < NEVER)) {
      return t;
    }
    double nearest = GapRoot.DOUBT;
    for (int i = 0; i < GapRoot.CORRECTIONS && Double.isNaN(nearest); i++) {
      double f = residue(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2, t);
      double slope = c2 + (2 * c3 + 3 * c4 * t) * t;
      nearest = GapRoot.nearest(t, f, slope, m0 + (m1 + m2 * t) * t);
      t -= f / slope;
    }
    return nearest;
  }

  /** The gap over time at t. What cancels is kept as head and tail. */
  private static double residue(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2, double t) {
    double ex = middle(vx1, vx2, gx, t);
    double ey = middle(vy1, vy2, gy, t);
    double exl = middleTail(vx1, vx2, gx, t);
    double eyl = middleTail(vy1, vy2, gy, t);
    double kx = 2 * (x1 - x2) + t * ex;
    double ky = 2 * (y1 - y2) + t * ey;
    double kxl = sumOfPlacesTail(x1, x2, ex, exl, t);
    double kyl = sumOfPlacesTail(y1, y2, ey, eyl, t);
    double px = ex * kx;
    double py = ey * ky;
    double sum = px + py;
    return sum
        + (sumTail(px, py, sum)
            + (productTail(ex, exl, kx, kxl, px) + productTail(ey, eyl, ky, kyl, py)));
  }

  /** The mean velocity up to t, e = u + g t / 2, on one axis. */
  private static double middle(double v1, double v2, double g, double t) {
    return (v1 - v2) + 0.5 * g * t;
  }

  private static double middleTail(double v1, double v2, double g, double t) {
    double u = v1 - v2;
    double m = 0.5 * g * t;
    return sumTail(u, m, u + m) + (differenceTail(v1, v2, u) + productTail(0.5 * g, t, m));
  }

  /** The tail of 2 d + t e on one axis. */
  private static double sumOfPlacesTail(
      double x1, double x2, double e, double el, double t) {
    double d = x1 - x2;
    double m = t * e;
    return sumTail(2 * d, m, 2 * d + m)
        + (2 * differenceTail(x1, x2, d) + (productTail(t, e, m) + t * el));
  }
}
