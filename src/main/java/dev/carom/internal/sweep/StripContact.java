// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.DoubleDoubleNumber;
import dev.carom.internal.exact.Expansion;

/**
 * When a disk with a constant acceleration hits a line that it touches at the start within
 * rounding, or leaves, or on which it slides: the questions in which the gap at the start, or the
 * speed along the normal, is all rounding error. {@link ParabolaSegmentSweep} says what counts.
 *
 * <p>With the side of the line on which it starts, the disk is in the strip while {@code k(t) =
 * side h(t) - r |w|} is not above 0. The coefficients of k are computed from sums without rounding:
 * so are their signs. The first one is the gap beside the line over {@code |h| + r |w|}, in which
 * nothing cancels. In units of {@code u^2 = 2^-106} the gap errs by 64, {@code |w|} by 36, {@code r
 * |w|} by 41, its sum with {@code |h|} by 68, and the quotient by 147; the other two by 64.
 */
final class StripContact {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private StripContact() {}

  /** The time of impact up to T; NaN if double-double does not tell. */
  static double time(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double T) {
    Expansion wx = Expansion.difference(bx, ax);
    Expansion wy = Expansion.difference(by, ay);
    Expansion h0 =
        Expansion.cross(wx, wy, Expansion.difference(px, ax), Expansion.difference(py, ay));
    Expansion h1 =
        Expansion.cross(wx, wy, Expansion.difference(vx, ux), Expansion.difference(vy, uy));
    Expansion h2 = Expansion.cross(wx, wy, Expansion.sum(gx, 0), Expansion.sum(gy, 0));
    Expansion ww = Expansion.dot(wx, wy, wx, wy);
    Expansion radius = Expansion.sum(r, 0);
    Expansion rr = new Expansion().plus(1, radius, radius);
    Expansion gap = new Expansion().plus(1, h0, h0).plus(-1, rr, ww);
    int side = h0.sign();
    if (r == 0 || side == 0 || !(gap.isExact() && h1.isExact() && h2.isExact())) {
      return GapRoot.DOUBT;
    }
    int speed = side * h1.sign();
    int bend = side * h2.sign();
    boolean isOutside = gap.sign() > 0;
    boolean falls = speed < 0 || (speed == 0 && bend < 0);
    boolean leaves = speed >= 0 && bend >= 0; // or moves along the line
    if (leaves && gap.sign() >= 0) {
      return NEVER; // nor does it overlap an end
    }
    if (!isOutside
        && LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, 0) != LineRegion.BESIDE) {
      return GapRoot.DOUBT;
    }
    if (!isOutside && falls) {
      return 0;
    }
    DoubleDoubleNumber length = ww.value().root();
    DoubleDoubleNumber height = h0.value().scaled(side);
    DoubleDoubleNumber sum = length.times(new DoubleDoubleNumber(r, 0)).plus(height);
    DoubleDoubleNumber k0 = gap.value().over(sum);
    DoubleDoubleNumber k1 = h1.value().scaled(side);
    DoubleDoubleNumber k2 = h2.value().scaled(0.5 * side);
    if (!(QuadraticRoot.isSafe(k0) && QuadraticRoot.isSafe(k1) && QuadraticRoot.isSafe(k2))) {
      return GapRoot.DOUBT;
    }
    if (gap.sign() < 0) {
      double until = Math.min(exit(k0.head(), k1.head(), k2.head()), T);
      double sx = vx - ux;
      double sy = vy - uy;
      boolean isFree =
          isBeside(px, py, sx, sy, gx, gy, ax, ay, bx, by, until)
              || (leaves && isOneWay(sx, sy, gx, gy, bx - ax, by - ay, until));
      if (!isFree || leaves) {
        return isFree ? NEVER : GapRoot.DOUBT;
      }
    }
    double fall = QuadraticRoot.fall(k0, k1, k2);
    double time = fall == NEVER ? NEVER : GapRoot.upTo(T, fall);
    return time < NEVER
        ? at(time, isOutside, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, T)
        : time;
  }

  /**
   * The time of impact of a disk that enters the strip at a time.
   *
   * @param isOutside whether it has not been in the strip before
   */
  private static double at(
      double time, boolean isOutside, double px, double py, double r, double vx, double vy,
      double gx, double gy, double ax, double ay, double bx, double by, double ux, double uy,
      double T) {
    int region = LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, time);
    if (region == LineRegion.BESIDE) {
      return time;
    }
    double before = GapRoot.before(time);
    return region == LineRegion.UNKNOWN || !isOutside
        ? GapRoot.DOUBT
        : ParabolaSegmentSweep.beyondAnEnd(
            region, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, before, T);
  }

  /**
   * The time at which a disk in the strip that does not move inwards has left it or turned, but for
   * 10 u; infinite for one that moves along the line.
   *
   * <p>The coefficients err by u. Where the discriminant is not far below k1^2 it errs by 6 u of
   * that, and its root by as much of k1. Elsewhere the disk turns soon after it leaves the strip,
   * or before.
   */
  private static double exit(double k0, double k1, double k2) {
    double discriminant = k1 * k1 - 4 * k0 * k2;
    return discriminant >= 0.25 * (k1 * k1)
        ? -2 * k0 / (k1 + Math.sqrt(discriminant))
        : -0.5 * k1 / k2;
  }

  /**
   * Whether the motion along the line certainly has one direction up to a time: a disk that comes
   * no nearer to the line then leaves the end that it passes.
   */
  private static boolean isOneWay(
      double sx, double sy, double gx, double gy, double wx, double wy, double until) {
    return ParabolaSegmentSweep.turn(sx, sy, gx, gy, wy, -wx, 0, until) < 0;
  }

  /**
   * Whether a centre that starts beside the line is certain to stay there up to a time. The time
   * may err by 10 u. That moves a place by 20 u of its terms, and changes a speed by 10 u of them.
   * Each has 10 u more of its own. The bounds of {@link EndReturn#isBeyond} and of {@link
   * #isOneWay} exceed both sums.
   */
  private static boolean isBeside(
      double px, double py, double sx, double sy, double gx, double gy, double ax, double ay,
      double bx, double by, double until) {
    double wx = bx - ax;
    double wy = by - ay;
    return EndReturn.isBeyond(px, py, sx, sy, gx, gy, ax, ay, wx, wy, 0, until)
        && EndReturn.isBeyond(px, py, sx, sy, gx, gy, bx, by, -wx, -wy, 0, until);
  }
}
