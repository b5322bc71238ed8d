// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

/**
 * When a disk with a constant acceleration comes into contact with a line after a given time, as
 * far as doubles and double-double tell.
 *
 * <p>The disk enters the capsule of {@link ParabolaSegmentSweep} where it enters the strip while its
 * centre is beside the line, or the disk of an end while its centre is beyond that end. So each of
 * the three is asked for its entries, and those elsewhere are passed over. A disk that is outside
 * the strip enters nothing before the strip.
 */
final class LaterEntry {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private LaterEntry() {}

  /** The time of the first entry after s, up to T; NaN if doubles and double-double do not tell. */
  static double certain(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double s, double T) {
    int strip = strip(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, s);
    double side = side(strip, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, s, T);
    int region = ParabolaSegmentSweep.region(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, side);
    if (strip > 0 && (side == NEVER || region == ParabolaSegmentSweep.BESIDE)) {
      return side;
    }
    while (side < NEVER && region != ParabolaSegmentSweep.BESIDE) {
      if (region == ParabolaSegmentSweep.UNKNOWN) {
        return GapRoot.DOUBT;
      }
      int again = strip(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, side);
      side = side(again, px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, side, T);
      region = ParabolaSegmentSweep.region(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, side);
    }
    double start = end(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, s, T);
    double end = end(px, py, r, vx, vy, gx, gy, bx, by, ax, ay, ux, uy, s, T);
    return Math.min(side, Math.min(start, end));
  }

  /** The first entry into the disk of the end q while the centre is beyond it; o is the other end. */
  private static double end(
      double px, double py, double r, double vx, double vy, double gx, double gy, double qx,
      double qy, double ox, double oy, double ux, double uy, double s, double T) {
    double t = s;
    int region = ParabolaSegmentSweep.BESIDE;
    while (t < NEVER
        && (region == ParabolaSegmentSweep.BESIDE || region == ParabolaSegmentSweep.BEYOND)) {
      t = ParabolaDiskSweep.certainAfter(px, py, r, vx, vy, gx, gy, qx, qy, 0, ux, uy, t, T);
      region = ParabolaSegmentSweep.region(px, py, vx, vy, gx, gy, qx, qy, ox, oy, ux, uy, t);
    }
    return t == NEVER || region == ParabolaSegmentSweep.BEFORE ? t : GapRoot.DOUBT;
  }

  /**
   * The sign of the gap beside the line at the start, or just after the half ulp that follows a
   * later time s; 0 in doubt.
   */
  private static int strip(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double s) {
    double wx = bx - ax;
    double wy = by - ay;
    double dx = px - ax;
    double dy = py - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    double h0 = wx * dy - wy * dx;
    double h1 = wx * sy - wy * sx;
    double h2 = 0.5 * (wx * gy - wy * gx);
    double c0 = h0 * h0 - r * r * (wx * wx + wy * wy);
    double m0 = Math.abs(wx * dy) + Math.abs(wy * dx) + r * (Math.abs(wx) + Math.abs(wy));
    double m1 = Math.abs(wx * sy) + Math.abs(wy * sx);
    double m2 = 0.5 * (Math.abs(wx * gy) + Math.abs(wy * gx));
    double c1 = 2 * h0 * h1;
    double c2 = h1 * h1 + 2 * h0 * h2;
    int sign = GapRoot.sign(c0, c1, c2, 2 * h1 * h2, h2 * h2, m0, m1, m2, Math.max(0, s));
    return sign != 0 || s <= 0
        ? sign
        : ParabolaSegmentSweep.signAfter(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, s);
  }

  /** The first entry into the strip after s. */
  private static double side(
      int strip, double px, double py, double r, double vx, double vy, double gx, double gy,
      double ax, double ay, double bx, double by, double ux, double uy, double s, double T) {
    double wx = bx - ax;
    double wy = by - ay;
    double dx = px - ax;
    double dy = py - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    double h0 = wx * dy - wy * dx;
    double h1 = wx * sy - wy * sx;
    double h2 = 0.5 * (wx * gy - wy * gx);
    double c0 = h0 * h0 - r * r * (wx * wx + wy * wy);
    double m0 = Math.abs(wx * dy) + Math.abs(wy * dx) + r * (Math.abs(wx) + Math.abs(wy));
    double m1 = Math.abs(wx * sy) + Math.abs(wy * sx);
    double m2 = 0.5 * (Math.abs(wx * gy) + Math.abs(wy * gx));
    double c1 = 2 * h0 * h1;
    double c2 = h1 * h1 + 2 * h0 * h2;
    double c3 = 2 * h1 * h2;
    double c4 = h2 * h2;
    double limit = ParabolaSegmentSweep.reach(wx, wy, gx, gy, h1, h2, m0, m1, m2, T);
    double from = Math.max(0, s);
    int sign = strip;
    if (strip == 0 && s <= 0) {
      from = GapRoot.leaves(c0, c1, c2, c3, c4, m0, m1, m2, limit);
      sign = 1;
    }
    double t =
        from < NEVER
            ? GapRoot.nextFall(sign, c0, c1, c2, c3, c4, m0, m1, m2, from, limit)
            : from;
    if (!(t < NEVER)) {
      return t;
    }
    double time =
        ParabolaSegmentSweep.nearest(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
    return time > s ? time : GapRoot.DOUBT;
  }
}
