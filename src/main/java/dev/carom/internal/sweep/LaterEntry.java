// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

/**
 * When a disk with a constant acceleration comes into contact with a line after a given time, as
 * far as doubles and double-double tell.
 *
 * <p>The disk enters the capsule of {@link ParabolaSegmentSweep} where it enters the strip while
 * its centre is beside the line, or the disk of an end while its centre is beyond that end. So each
 * of the three is asked for its entries, and those elsewhere are passed over. A disk that is
 * outside the strip enters nothing before the strip.
 */
final class LaterEntry {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private LaterEntry() {}

  /** The time of the first entry after s, up to T; NaN if doubles and double-double do not tell. */
  static double certain(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double s, double T) {
    double wx = bx - ax;
    double wy = by - ay;
    if (!ParabolaSegmentSweep.isInRange(r, wx, wy)) {
      return GapRoot.DOUBT;
    }
    double dx = px - ax;
    double dy = py - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    double h0 = wx * dy - wy * dx;
    double h1 = wx * sy - wy * sx;
    double h2 = 0.5 * (wx * gy - wy * gx);
    double c0 = h0 * h0 - r * r * (wx * wx + wy * wy);
    double c1 = 2 * h0 * h1;
    double c2 = h1 * h1 + 2 * h0 * h2;
    double c3 = 2 * h1 * h2;
    double c4 = h2 * h2;
    double m0 = Math.abs(wx * dy) + Math.abs(wy * dx) + r * (Math.abs(wx) + Math.abs(wy));
    double m1 = Math.abs(wx * sy) + Math.abs(wy * sx);
    double m2 = 0.5 * (Math.abs(wx * gy) + Math.abs(wy * gx));
    double limit = ParabolaSegmentSweep.reach(wx, wy, gx, gy, h1, h2, m0, m1, m2, T);
    double after = s;
    double side;
    int region;
    do {
      double from = Math.max(0, after);
      int strip = GapRoot.sign(c0, c1, c2, c3, c4, m0, m1, m2, from);
      if (strip == 0 && after > 0) {
        strip =
            ParabolaSegmentSweep.signAfter(
                px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, after);
      }
      boolean isOutside = strip > 0 && after == s;
      if (strip == 0 && after <= 0) {
        from = GapRoot.leaves(c0, c1, c2, c3, c4, m0, m1, m2, limit);
        strip = 1;
      }
      side =
          from < NEVER
              ? GapRoot.nextFall(strip, c0, c1, c2, c3, c4, m0, m1, m2, from, limit)
              : from;
      if (side < NEVER) {
        double nearest =
            ParabolaSegmentSweep.nearest(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, side);
        side = GapRoot.beside(side, nearest);
      }
      if (!(side > after)) {
        return GapRoot.DOUBT;
      }
      region =
          side < NEVER
              ? LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, side)
              : LineRegion.BESIDE;
      if (region == LineRegion.UNKNOWN || (isOutside && region == LineRegion.BESIDE)) {
        return region == LineRegion.BESIDE ? side : GapRoot.DOUBT;
      }
      after = side;
    } while (region != LineRegion.BESIDE);
    double start = end(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, s, T);
    double end = end(px, py, r, vx, vy, gx, gy, bx, by, ax, ay, ux, uy, s, T);
    return Math.min(side, Math.min(start, end));
  }

  /** The first entry into the disk of the end q, of a centre beyond it; o is the other end. */
  private static double end(
      double px, double py, double r, double vx, double vy, double gx, double gy, double qx,
      double qy, double ox, double oy, double ux, double uy, double s, double T) {
    double t = s;
    int region = LineRegion.BEYOND;
    while (t < NEVER && (region == LineRegion.BESIDE || region == LineRegion.BEYOND)) {
      t = ParabolaDiskSweep.certainAfter(px, py, r, vx, vy, gx, gy, qx, qy, 0, ux, uy, t, T);
      region = LineRegion.at(px, py, vx, vy, gx, gy, qx, qy, ox, oy, ux, uy, t);
    }
    return t == NEVER || region == LineRegion.BEFORE ? t : GapRoot.DOUBT;
  }
}
