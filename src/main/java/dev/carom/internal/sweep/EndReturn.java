// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

/**
 * When a disk with a constant acceleration that touches an end of a line, q, hits the line next, as
 * far as doubles and double-double tell. The other end is o. {@link ParabolaReturn} says what
 * counts.
 *
 * <p>While the centre stays beyond q, only the return to q counts. Otherwise the disk must have
 * left the strip of {@link ParabolaSegmentSweep} when its centre comes beside the line. Until it is
 * in the strip again it hits nothing. If it then is beside the line, it hits the side; if it is
 * beyond an end and stays there, it can hit this end alone. All else is left open.
 */
final class EndReturn {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private EndReturn() {}

  /** The time of the next hit up to T; NaN if doubles and double-double do not tell. */
  static double certain(
      double px, double py, double r, double vx, double vy, double gx, double gy, double qx,
      double qy, double ox, double oy, double ux, double uy, double T) {
    double back = ParabolaReturn.certain(px, py, vx, vy, gx, gy, qx, qy, ux, uy, T);
    if (back == 0 || Double.isNaN(back)) {
      return back;
    }
    double wx = ox - qx;
    double wy = oy - qy;
    double sx = vx - ux;
    double sy = vy - uy;
    double until = Math.min(back, T);
    if (isBeyond(px, py, sx, sy, gx, gy, qx, qy, -wx, -wy, 0, until)) {
      return back;
    }
    double dx = px - qx;
    double dy = py - qy;
    double h0 = wx * dy - wy * dx;
    double h1 = wx * sy - wy * sx;
    double h2 = 0.5 * (wx * gy - wy * gx);
    if (!ParabolaSegmentSweep.isInRange(r, wx, wy)) {
      return GapRoot.DOUBT;
    }
    double c0 = h0 * h0 - r * r * (wx * wx + wy * wy);
    double c1 = 2 * h0 * h1;
    double c2 = h1 * h1 + 2 * h0 * h2;
    double c3 = 2 * h1 * h2;
    double c4 = h2 * h2;
    double m0 = Math.abs(wx * dy) + Math.abs(wy * dx) + r * (Math.abs(wx) + Math.abs(wy));
    double m1 = Math.abs(wx * sy) + Math.abs(wy * sx);
    double m2 = 0.5 * (Math.abs(wx * gy) + Math.abs(wy * gx));
    double limit = ParabolaSegmentSweep.reach(wx, wy, gx, gy, h1, h2, m0, m1, m2, T);
    int strip = GapRoot.sign(c0, m0 * m0);
    double out =
        strip > 0
            ? 0
            : strip < 0
                ? GapRoot.exit(c0, c1, c2, c3, c4, m0, m1, m2, limit)
                : GapRoot.leaves(c0, c1, c2, c3, c4, m0, m1, m2, limit);
    // Nothing is hit up to then: beside the line the height rises, if it does.
    boolean isFree =
        out < back
            && (isBeyond(px, py, sx, sy, gx, gy, qx, qy, -wx, -wy, 0, out)
                || (GapRoot.rises(c1, c2, c3, c4, m0, m1, m2, out)
                    && isBeyond(px, py, sx, sy, gx, gy, ox, oy, -wx, -wy, 0, out)));
    if (!isFree) {
      return GapRoot.DOUBT;
    }
    double in = GapRoot.first(c0, c1, c2, c3, c4, m0, m1, m2, out, limit);
    if (!(in < NEVER)) {
      return in == back ? in : GapRoot.DOUBT;
    }
    double nearest =
        ParabolaSegmentSweep.nearest(px, py, r, vx, vy, gx, gy, qx, qy, ox, oy, ux, uy, in);
    double t = GapRoot.beside(in, nearest);
    double below = below(h0, h1, h2, r * Math.sqrt(wx * wx + wy * wy));
    boolean isBelow =
        strip <= 0 && below > t && GapRoot.sign(c0, c1, c2, c3, c4, m0, m1, m2, below) > 0;
    return t < back
        ? inStrip(
            px, py, r, vx, vy, gx, gy, qx, qy, ox, oy, ux, uy, t, back, isBelow ? below : T, T)
        : GapRoot.DOUBT;
  }

  /**
   * A time just after the height h0 + h1 t + h2 t^2 turned and passed a distance behind the line. A
   * disk that left the strip and entered it again is behind it then, and does not come back. The
   * time need not be exact: the caller asks whether the disk is out of the strip then.
   */
  private static double below(double h0, double h1, double h2, double distance) {
    double vertex = -0.5 * h1 / h2;
    double height = h0 + 0.5 * h1 * vertex;
    return (vertex + Math.sqrt((Math.abs(height) + distance) / Math.abs(h2))) * (1 + 0x1p-20);
  }

  /**
   * The next hit of a disk that enters the strip at a time t, before it could be back at q.
   *
   * @param last the time from which it hits nothing
   */
  private static double inStrip(
      double px, double py, double r, double vx, double vy, double gx, double gy, double qx,
      double qy, double ox, double oy, double ux, double uy, double t, double back, double last,
      double T) {
    int region =
        LineRegion.at(px, py, vx, vy, gx, gy, qx, qy, ox, oy, ux, uy, t);
    if (region == LineRegion.BESIDE || region == LineRegion.UNKNOWN) {
      return region == LineRegion.BESIDE ? t : GapRoot.DOUBT;
    }
    double wx = ox - qx;
    double wy = oy - qy;
    double sx = vx - ux;
    double sy = vy - uy;
    if (region == LineRegion.BEFORE) {
      double until = Math.min(back, Math.min(last, T));
      boolean stays = isBeyond(px, py, sx, sy, gx, gy, qx, qy, -wx, -wy, t, until);
      return stays && (back <= until || back == NEVER) ? back : GapRoot.DOUBT;
    }
    double hit = ParabolaDiskSweep.certain(px, py, r, vx, vy, gx, gy, ox, oy, 0, ux, uy, 0, T);
    double until = Math.min(hit, Math.min(last, T));
    boolean stays = hit > t && isBeyond(px, py, sx, sy, gx, gy, ox, oy, wx, wy, t, until);
    return stays && (hit <= until || hit == NEVER) ? hit : GapRoot.DOUBT;
  }

  /**
   * Whether the projection of {@code p - q} on a vector e is certain to be above 0 from one time to
   * another, by its Bernstein coefficients there. At time 0 it is known not to be below 0.
   *
   * @param sx the velocity of the disk less that of the line
   */
  static boolean isBeyond(
      double px, double py, double sx, double sy, double gx, double gy, double qx, double qy,
      double ex, double ey, double from, double to) {
    double dx = px - qx;
    double dy = py - qy;
    double a0 = ex * dx + ey * dy;
    double a1 = ex * sx + ey * sy;
    double a2 = 0.5 * (ex * gx + ey * gy);
    double m0 = Math.abs(ex * dx) + Math.abs(ey * dy);
    double m1 = Math.abs(ex * sx) + Math.abs(ey * sy);
    double m2 = 0.5 * (Math.abs(ex * gx) + Math.abs(ey * gy));
    boolean begins = from == 0 || isAbove(a0, a1, a2, m0, m1, m2, from, from);
    boolean rises =
        (GapRoot.sign(a1, m1) > 0 || ParabolaSegmentSweep.isAlong(-ey, ex, sx, sy))
            && (GapRoot.sign(a2, m2) > 0 || ParabolaSegmentSweep.isAlong(-ey, ex, gx, gy));
    return begins
        && (rises
            || (to < GapRoot.LATEST
                && isAbove(a0, a1, a2, m0, m1, m2, from, to)
                && isAbove(a0, a1, a2, m0, m1, m2, to, to)));
  }

  /** Whether {@code a0 + a1 (s + t) / 2 + a2 s t} is certain to be above 0. */
  private static boolean isAbove(
      double a0, double a1, double a2, double m0, double m1, double m2, double s, double t) {
    double middle = 0.5 * (s + t);
    double value = a0 + a1 * middle + a2 * s * t;
    return GapRoot.sign(value, m0 + m1 * middle + m2 * s * t) > 0;
  }
}
