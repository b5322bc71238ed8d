// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.ExactReturn;
import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.PrecisionCounters;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.RealRoot;

/**
 * When a disk with a constant acceleration comes back to the thing that it has just hit.
 *
 * <p>Its gap at the start is 0 by definition, whatever its rounded place says. So the gap is counted
 * from there, and its root at time 0 is divided out, exactly. A speed along the normal that is
 * negative counts as 0: it is a rounding error of the response. Without that speed the acceleration
 * decides: inward, the answer is 0, for the disk is supported; outward, it leaves.
 *
 * <p>A line has three parts, its side and its ends. The disk touches the part in whose region its
 * centre is at the start, and the gap of this part counts from there. Those of the others are what
 * the given numbers say. So the disk comes back
 *
 * <ul>
 *   <li>from the side: when its height above the line is again that at the start, if its centre is
 *       beside the line then; otherwise at the first impact from then on with the end that it has
 *       passed. Until then it is above the line and its ends.
 *   <li>from an end: when its distance from this end is again that at the start while its centre is
 *       beyond it; or at an impact with the side, or with the other end; whichever is first.
 * </ul>
 */
public final class ParabolaReturn {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * The correction of a quotient of cross products, of their terms over the divisor. The products err
   * by 64 u^2 of them. Their tails are below 4 u, so the numerator is below 5 u, and its sums err by
   * 13 u^2. The divisor errs by 2 u, so the quotient does by 15 u^2; its sum with the bound takes 5
   * u^2: 97 u^2 in all.
   *
   * <p>The divisor does so if its terms are at most 2^46 times itself. Where they are more, this
   * bound exceeds half an ulp of the quotient.
   */
  private static final double CROSS_BOUND = 128 * 0x1p-106;

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
    double time = Fall.linear(v, 0.5 * g, inward, T);
    return Double.isNaN(time) ? ExactReturn.toWall(v, g, inward).time(T) : time;
  }

  /**
   * The correctly rounded time of the return to the height above the infinite line at which the disk
   * starts, {@code -2 n.(v - u) / n.g}, where u is the velocity of the line; {@code +infinity} for
   * none up to the window's end T. The centre may then be beyond an end.
   *
   * @param side +1 if the disk is left of the line, -1 if right
   */
  public static double toSide(
      int side, double vx, double vy, double gx, double gy, double ax, double ay, double bx,
      double by, double ux, double uy, double T) {
    if (side * Predicates.cross(bx, by, ax, ay, gx, gy, 0, 0) >= 0) {
      return NEVER;
    }
    if (side * Predicates.cross(bx, by, ax, ay, vx, vy, ux, uy) <= 0) {
      return 0;
    }
    double sx = vx - ux;
    double sy = vy - uy;
    double wx = bx - ax;
    double wy = by - ay;
    double wxl = differenceTail(bx, ax, wx);
    double wyl = differenceTail(by, ay, wy);
    double sxl = differenceTail(vx, ux, sx);
    double syl = differenceTail(vy, uy, sy);
    double n = 2 * (wx * sy - wy * sx);
    double nl = 2 * crossTail(wx, wxl, wy, wyl, sx, sxl, sy, syl, 0.5 * n);
    double d = wy * gx - wx * gy;
    double dl = -crossTail(wx, wxl, wy, wyl, gx, 0, gy, 0, -d);
    double t = n / d;
    double divisor = d + dl;
    double step = (fma(-t, d, n) + (nl - t * dl)) / divisor;
    double terms =
        2 * (Math.abs(wx * sy) + Math.abs(wy * sx))
            + t * (Math.abs(wx * gy) + Math.abs(wy * gx));
    double error = CROSS_BOUND * (terms / Math.abs(divisor));
    double low = t + (step - error);
    boolean isCertain =
        low == t + (step + error)
            && low != T
            && low > LEAST_SAFE
            && Math.abs(divisor) > LEAST_SAFE
            && t * terms < MOST_SAFE
            && terms > LEAST_SAFE
            && terms < MOST_SAFE;
    if (isCertain) {
      return low < T ? low : NEVER;
    }
    double time = Fall.of(0, 0, 0, vx, vy, gx, gy, ax, ay, bx, by, ux, uy).toSide(side, T);
    return Double.isNaN(time)
        ? ExactReturn.toSide(side, vx, vy, gx, gy, ax, ay, bx, by, ux, uy).time(T)
        : time;
  }

  /**
   * The correctly rounded time of the return to a disk that moves straight on, or an endpoint: the
   * first one at which their distance falls below that at the start. {@code +infinity} for none up to
   * the window's end T.
   *
   * <p>With {@code e = u + g t / 2} the gap over time is {@code e.(2 d + t e)}, a cubic polynomial.
   * The acceleration along the normal has a part by the curvature: its sign is that of {@code u.u +
   * d.g}.
   */
  public static double toDisk(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2, double T) {
    if (gx == 0 && gy == 0) {
      return NEVER;
    }
    PrecisionCounters.parabola();
    Fall fall = Fall.ofDisks(x1, y1, 0, vx1, vy1, gx, gy, x2, y2, 0, vx2, vy2);
    double time = fall.next(Gaps.BEFORE, T);
    return Double.isNaN(time)
        ? ExactReturn.toDisk(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2).time(T)
        : time;
  }

  /**
   * The correctly rounded time of the next hit on a line that is from a to b at the start and moves
   * with the velocity u, by a disk that touches it at the start; {@code +infinity} for none up to
   * the window's end T. A line of no length is a disk of radius 0.
   */
  public static double toLine(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double T) {
    if (gx == 0 && gy == 0) {
      return NEVER;
    }
    if (ax == bx && ay == by) {
      return toDisk(px, py, vx, vy, gx, gy, ax, ay, ux, uy, T);
    }
    PrecisionCounters.parabola();
    double time = certain(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, T);
    return !Double.isNaN(time)
        ? time
        : ExactReturn.toLine(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy).time(T);
  }

  private static double certain(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double T) {
    int part = part(px, py, ax, ay, bx, by);
    if (part != Contact.LEFT) {
      return Fall.of(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy)
          .next(part == Contact.START ? Gaps.BEFORE : Gaps.BEYOND, T);
    }
    int side = side(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    double back = toSide(side, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, T);
    if (back == 0 || back == NEVER) {
      return back;
    }
    int region =
        LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, back);
    if (region == LineRegion.BESIDE || region == LineRegion.UNKNOWN) {
      boolean isBeside =
          region == LineRegion.BESIDE
              || Fall.of(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy)
                  .returnsAtEnd(side, back);
      return isBeside ? back : GapRoot.DOUBT;
    }
    double qx = region == LineRegion.BEFORE ? ax : bx;
    double qy = region == LineRegion.BEFORE ? ay : by;
    double time =
        Fall.ofDisks(px, py, r, vx, vy, gx, gy, qx, qy, 0, ux, uy)
            .firstAfter(back * (1 - GapRoot.MARGIN), T);
    return time > back ? time : GapRoot.DOUBT;
  }

  /** The part of a line in whose region a point is: START, END, or LEFT for the side. */
  private static int part(double px, double py, double ax, double ay, double bx, double by) {
    if (SegmentSweep.along(px, py, ax, ay, ax, ay, bx, by) <= 0) {
      return Contact.START;
    }
    return SegmentSweep.along(px, py, bx, by, ax, ay, bx, by) >= 0 ? Contact.END : Contact.LEFT;
  }

  private static int region(int part) {
    return part == Contact.START
        ? LineRegion.BEFORE
        : part == Contact.END ? LineRegion.BEYOND : LineRegion.BESIDE;
  }

  /**
   * The side of the line that a disk touches at the start: by its place. That of a point, or of a
   * centre on the line, is the one to which it leaves; without a speed the acceleration pulls it off.
   */
  private static int side(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy) {
    int place = Predicates.cross(bx, by, ax, ay, px, py, ax, ay);
    if (r > 0 && place != 0) {
      return place;
    }
    int speed = Predicates.cross(bx, by, ax, ay, vx, vy, ux, uy);
    if (speed != 0 || place != 0) {
      return speed != 0 ? speed : place;
    }
    return Predicates.cross(bx, by, ax, ay, gx, gy, 0, 0);
  }

  /**
   * The {@link Contact} of the next hit on a line that the disk touches at the start.
   *
   * @param t its time, from {@link #toLine}
   */
  public static int contactOfReturn(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double t) {
    int now = t == 0 ? Contact.NOW : 0;
    if (ax == bx && ay == by) {
      return Contact.START | now;
    }
    int part = part(px, py, ax, ay, bx, by);
    int side =
        part == Contact.LEFT
            ? side(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy)
            : LineRegion.side(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
    int region = LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
    if (region == LineRegion.UNKNOWN) {
      region =
          Fall.of(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy)
              .regionAtReturn(region(part), side, t);
    }
    int contact = LineRegion.contact(region, side);
    return contact == Contact.DOUBT
        ? exactContact(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy) | now
        : contact | now;
  }

  private static int exactContact(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy) {
    ExactReturn exact = ExactReturn.toLine(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    RealRoot root = exact.first(NEVER);
    return LineRegion.contact(exact.region(root), exact.side(root));
  }

  /**
   * The double nearest to the return to a disk or an endpoint, from a time near it; NaN in doubt.
   * The gap over time is {@code e.(2 d + t e)} with {@code e = u + g t / 2}.
   */
  static double nearest(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2, double start) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
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
    double t = start;
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
    double ex = Offset.mean(vx1, vx2, gx, t);
    double ey = Offset.mean(vy1, vy2, gy, t);
    double exl = Offset.meanTail(vx1, vx2, gx, t);
    double eyl = Offset.meanTail(vy1, vy2, gy, t);
    double kx = 2 * (x1 - x2) + t * ex;
    double ky = 2 * (y1 - y2) + t * ey;
    double kxl = Offset.scaledTail(2, x1, x2, t, ex, exl);
    double kyl = Offset.scaledTail(2, y1, y2, t, ey, eyl);
    double px = ex * kx;
    double py = ey * ky;
    double sum = px + py;
    return sum
        + (sumTail(px, py, sum)
            + (productTail(ex, exl, kx, kxl, px) + productTail(ey, eyl, ky, kyl, py)));
  }
}
