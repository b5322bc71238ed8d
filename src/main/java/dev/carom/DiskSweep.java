// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.DoubleDouble.differenceTail;
import static dev.carom.DoubleDouble.productTail;
import static dev.carom.DoubleDouble.sumTail;

/**
 * A disk that moves against another that may move too; endpoints are disks of radius zero that
 * rest.
 *
 * <p>Seen from the second disk, the first one's centre starts at the offset {@code d = c1 - c2} and
 * moves with {@code u = v1 - v2}; they touch where {@code |d + u t| = r}, {@code r = r1 + r2}:
 *
 * <pre>
 *   a t^2 + 2 b t + g = 0    a = u.u,  b = u.d,  g = d.d - r^2
 *   b^2 - a g = a r^2 - cross(u, d)^2 =: reach
 * </pre>
 *
 * The distance is convex in t, so: moving apart or not at all (b >= 0) is a miss; else overlapping
 * or touching (g <= 0) is an impact now; else reach > 0 is an impact later, at the smaller root,
 * and reach = 0 a graze, which is none, unless r = 0: then the point runs into the other.
 *
 * <p>Decisions are the signs of b, g and reach. Each is taken in plain doubles if the value exceeds
 * a bound of its rounding errors, and goes to {@link Predicates} if not. The bounds count
 * roundings, each a factor {@code 1 + u} with {@code u = 2^-53}: a difference of coordinates has
 * one; and they are relative to the sum of the absolute values of the terms, which is itself
 * computed. The form of reach is the one that does not cancel.
 */
final class DiskSweep {

  /** No impact. */
  static final int MISS = 0;

  /** Overlapping or touching and approaching: an impact at time 0. */
  static final int NOW = 1;

  /** An impact at a time above 0. */
  static final int LATER = 2;

  /** b: differences 1 + 1, product 1, sum 1: 4 u, and one more for second order and the sum. */
  private static final double DOT_BOUND = 5 * 0x1p-53;

  /** g: d.d has 2 + 1 + 1, r^2 has 2 + 1, the difference 1: 5 u, and one more. */
  private static final double GAP_BOUND = 6 * 0x1p-53;

  /**
   * reach: a has 2 + 1 + 1, r^2 has 3, their product 1: 8; cross errs by 4 u of its terms' sum M,
   * its square by 8 + 1 u of M^2; the difference 1: 10 u, and two more.
   */
  private static final double REACH_BOUND = 12 * 0x1p-53;

  /**
   * Underflow: fewer than 16 operations lose at most 2^-1074 each, times the other factor of a
   * product; it is covered by this times the sum of the factors and 1.
   */
  static final double TINY = 0x1p-1000;

  /**
   * Of the window's polynomial: a place d + u T has 1, 1 + 1 and 1 u of its terms' sum X; its
   * square 2 x 3 + 1, the sum 1, r^2 has 3, the difference 1: 9 u of X^2 + Y^2 + r^2, and two more.
   */
  private static final double WINDOW_BOUND = 11 * 0x1p-53;

  /** Newton steps before exact numbers take over; near a graze the plain root is a poor start. */
  private static final int STEPS = 4;

  /** Range of squares within which underflow stays far below the bounds of a step. */
  private static final double LEAST = 0x1p-500;

  private static final double MOST = 0x1p500;

  private DiskSweep() {}

  /** Whether two disks touch while approaching, now or later. */
  static int contact(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    // b = u.d
    double bx = ux * dx;
    double by = uy * dy;
    double b = bx + by;
    double bound = Math.fma(DOT_BOUND, Math.abs(bx) + Math.abs(by), TINY);
    if (b > bound || (!(b < -bound) && Predicates.dot(vx1, vy1, vx2, vy2, x1, y1, x2, y2) >= 0)) {
      return MISS;
    }
    // g = d.d - r^2
    double r = r1 + r2;
    double rr = r * r;
    double dd = dx * dx + dy * dy;
    double g = dd - rr;
    bound = Math.fma(GAP_BOUND, dd + rr, TINY);
    if (g < -bound || (!(g > bound) && Predicates.gap(x1, y1, x2, y2, r1, r2) <= 0)) {
      return NOW;
    }
    // reach = a r^2 - cross(u, d)^2
    double a = ux * ux + uy * uy;
    double kx = ux * dy;
    double ky = uy * dx;
    double k = kx - ky;
    double m = Math.abs(kx) + Math.abs(ky);
    double arr = a * rr;
    double reach = arr - k * k;
    bound = Math.fma(REACH_BOUND, arr + m * m, TINY * (a + rr + m + 1));
    if (reach > bound) {
      return LATER;
    }
    if (reach < -bound) {
      return MISS;
    }
    int sign = Predicates.reach(vx1, vy1, vx2, vy2, x1, y1, x2, y2, r1, r2);
    return sign > 0 || (sign == 0 && r == 0) ? LATER : MISS;
  }

  /** The time of a contact, {@code +infinity} if it is a MISS or later than the window's end T. */
  static double time(
      int contact, double x1, double y1, double r1, double vx1, double vy1, double x2, double y2,
      double r2, double vx2, double vy2, double T) {
    if (contact != LATER) {
      return contact == NOW ? 0 : Double.POSITIVE_INFINITY;
    }
    if (T < Double.POSITIVE_INFINITY) {
      int order = compareTime(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, T);
      if (order == 0) {
        Rungs.exactDecision();
        Exact.Disks disks = Exact.Disks.of(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
        order = disks.compareTime(Dyadic.of(T));
      }
      if (order > 0) {
        return Double.POSITIVE_INFINITY;
      }
    }
    return time(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
  }

  /**
   * The correctly rounded time of an impact that {@link #contact} found to come LATER.
   *
   * <p>The plain root is corrected by Newton's method on {@code f(t) = |d + u t|^2 - r^2} until the
   * correction is known well enough to round; if it never is, exact numbers decide. Two points
   * ({@code r = 0}) meet only by an exact tie and go there at once.
   */
  static double time(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double r = r1 + r2;
    double a = ux * ux + uy * uy;
    double bx = ux * dx;
    double by = uy * dy;
    double far = Math.abs(dx) + Math.abs(dy);
    double fast = Math.abs(ux) + Math.abs(uy);
    double t = estimate(dx, dy, r, ux, uy, a, bx + by);
    if (Rungs.COUNT != null) {
      Rungs.COUNT.roots++;
    }
    for (int i = 0; i < STEPS && t > 0; i++) {
      // Half of -f'(t) = -2 u.(d + u t)
      double slope = -(bx + by + a * t);
      double c = 0.5 * residue(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, t) / slope;
      double terms = Math.abs(bx) + Math.abs(by) + a * t;
      double error = stepError(far + fast * t, r, a, slope, terms, c);
      double low = t + (c - error);
      if (low == t + (c + error) && low > LEAST) {
        return low;
      }
      t += c;
    }
    if (Rungs.COUNT != null) {
      Rungs.COUNT.exactTimes++;
    }
    return Exact.Disks.of(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2).time();
  }

  /** t = g / (-b + sqrt(reach)): nothing cancels but g and, near a graze, reach. */
  private static double estimate(
      double dx, double dy, double r, double ux, double uy, double a, double b) {
    double k = ux * dy - uy * dx;
    double reach = a * (r * r) - k * k;
    double g = (dx * dx + dy * dy) - r * r;
    return g / (Math.sqrt(Math.max(0, reach)) - b);
  }

  /** {@code f(t) = e.e - r^2} at {@code e = d + u t}. What cancels is kept as head and tail. */
  private static double residue(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, double t) {
    double hx = (x1 - x2) + (vx1 - vx2) * t;
    double hy = (y1 - y2) + (vy1 - vy2) * t;
    double lx = terms(x1, x2, vx1, vx2, t);
    double ly = terms(y1, y2, vy1, vy2, t);
    // Where d and u t cancel, what they leave outgrows u of e: it is added first.
    double ex = hx + lx;
    double ey = hy + ly;
    double exl = sumTail(hx, lx, ex);
    double eyl = sumTail(hy, ly, ey);
    double r = r1 + r2;
    double rl = sumTail(r1, r2, r);
    double xx = ex * ex;
    double yy = ey * ey;
    double rr = r * r;
    double ee = xx + yy;
    double f = ee - rr;
    return f
        + ((sumTail(xx, yy, ee) + differenceTail(ee, rr, f))
            + ((productTail(ex, exl, ex, exl, xx) + productTail(ey, eyl, ey, eyl, yy))
                - productTail(r, rl, r, rl, rr)));
  }

  /** What d + u t on one axis leaves behind when it is rounded, below 4 u of its terms. */
  private static double terms(double x1, double x2, double v1, double v2, double t) {
    double d = x1 - x2;
    double u = v1 - v2;
    double m = u * t;
    return sumTail(d, m, d + m)
        + (differenceTail(x1, x2, d) + (productTail(u, t, m) + differenceTail(v1, v2, u) * t));
  }

  /**
   * A bound of the error of a Newton step {@code c = f / 2 s}, s the slope {@code -u.e}; NaN where
   * none is known.
   *
   * <p>With X the sum of the absolute values of d's and u t's components: e loses 8 u^2 X in its
   * tails, so f loses 16 u^2 |e| X, and 48 u^2 |e| X for its squares and sums; |e| is below 3/2 r
   * while {@code a |c| < s / 4}, for then e is within |u| |c| of a place at the distance r and |u|
   * |c| < |e| / 4. That makes 2^-100 (3/2 r) X / 2 s. The slope errs by 6 u of its terms, and may
   * be smaller by that much: the least that it can be divides. The curvature of f leaves {@code a
   * c^2 / 2 s}, at most twice that.
   */
  private static double stepError(
      double x, double r, double a, double slope, double terms, double c) {
    double size = Math.abs(c);
    double lean = 8 * 0x1p-53 * terms;
    double least = slope - lean;
    if (!(4 * a * size < least && a > LEAST && a < MOST && r * r > LEAST && r * r < MOST)) {
      return Double.NaN;
    }
    double lost = 0x1p-103 * x;
    return (8 * lost * (1.5 * r + lost) + size * (2 * lean + a * size)) / least;
  }

  /**
   * The sign of the time of impact less the end T of the window, as far as plain doubles tell: +1
   * later, -1 earlier, 0 in doubt. Later if at T the distance still falls, {@code u.e < 0}, and is
   * above r; earlier if it does not fall, or is below.
   */
  static int compareTime(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, double T) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double mx = ux * T;
    double my = uy * T;
    double ex = dx + mx;
    double ey = dy + my;
    double x = Math.abs(dx) + Math.abs(mx);
    double y = Math.abs(dy) + Math.abs(my);
    double s = ux * ex + uy * ey;
    double lean = Math.fma(WINDOW_BOUND, Math.abs(ux) * x + Math.abs(uy) * y, TINY * (1 + T));
    if (s > lean) {
      return -1;
    }
    double r = r1 + r2;
    double rr = r * r;
    double g = (ex * ex + ey * ey) - rr;
    double bound =
        Math.fma(WINDOW_BOUND, x * x + y * y + rr, TINY * ((1 + x + y) * (1 + T)));
    return g < -bound ? -1 : g > bound && s < -lean ? 1 : 0;
  }

  /**
   * The unit normal at contact, from the second disk to the first, each component within 1e-15.
   *
   * @param t the time of impact, or 0 for an impact {@link #NOW}
   */
  static Vec2 normal(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, double t) {
    if (t == 0) {
      return Directions.unit(x1, y1, x2, y2);
    }
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double r = r1 + r2;
    double a = ux * ux + uy * uy;
    double bx = ux * (x1 - x2);
    double by = uy * (y1 - y2);
    double fast = Math.abs(ux) + Math.abs(uy);
    double x = Math.abs(x1 - x2) + Math.abs(y1 - y2) + fast * t;
    double slope = -(bx + by + a * t);
    double c = 0.5 * residue(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, t) / slope;
    double error = stepError(x, r, a, slope, Math.abs(bx) + Math.abs(by) + a * t, c);
    if (!(error * fast < 0x1p-54 * r)) {
      return Exact.Disks.of(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2).normal();
    }
    return Directions.unit(
        place(x1, x2, vx1, vx2, t, c), place(y1, y2, vy1, vy2, t, c), 0, 0);
  }

  /** d + u (t + c) on one axis. */
  private static double place(double x1, double x2, double v1, double v2, double t, double c) {
    return ((x1 - x2) + (v1 - v2) * t) + (terms(x1, x2, v1, v2, t) + (v1 - v2) * c);
  }
}
