// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

/**
 * A filter in plain doubles for a disk that moves against a resting line. It finds most contacts of
 * a {@link SegmentSweep}, and approximately when they come. Its answers are certain; whatever is
 * near a limit is left in DOUBT, for the detector to decide.
 *
 * <p>The bounds of {@link SegmentSweep} and {@link TimeOfImpact} are 17 u of the sums of terms at
 * most, u = 2^-53. So a value above {@link #CLEAR} of them has its sign, and an error in proportion
 * below 2^-28.8; that of a root, or of what cancels less, is half of it.
 *
 * <p>The numbers are arguments, not a value, for the reason that {@link SegmentSweep} gives.
 */
public final class SegmentFilter {

  /** The relative error of a time is less than a quarter of this. */
  public static final double TIME_ERROR = 0x1p-26;

  /** A value above this fraction of the sum of its terms has a certain sign. */
  private static final double CLEAR = 0x1p-20;

  /** Covers underflow, for numbers from {@link #LEAST_SAFE} to {@link #MOST_SAFE}. */
  private static final double TINY = 0x1p-400;

  private static final double LEAST_SAFE = 0x1p-150;
  private static final double MOST_SAFE = 0x1p150;

  private SegmentFilter() {}

  /**
   * The margin of doubt for all lines during one flight; NaN if the filter cannot decide anything.
   *
   * @param speed at least |v|, at most twice that
   * @param size at least the sum of the largest coordinate of the lines, |px|, |py| and r
   */
  public static double margin(double speed, double size) {
    // x |x| w.w - y |y| with x = cross(p - q, v) and y = r v.w errs by less than 45 u of |v|^2 w.w
    // times the square of that sum.
    double scale = speed * size;
    return speed > LEAST_SAFE && speed < MOST_SAFE && size < MOST_SAFE
        ? 0x1p-47 * (scale * scale)
        : Double.NaN;
  }

  /**
   * The contact that is hit first, as in {@link SegmentSweep#contact} but never NOW; or DOUBT.
   *
   * @param margin from {@link #margin}; with an infinite one no line is reported as hit
   */
  public static int contact(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by,
      double margin) {
    double wx = bx - ax;
    double wy = by - ay;
    double dx = px - ax;
    double dy = py - ay;
    double c0 = wx * dy;
    double c1 = wy * dx;
    double c = c0 - c1;
    double m = Math.abs(c0) + Math.abs(c1);
    double ww = wx * wx + wy * wy;
    double scaledSquare = r * r * ww;
    double s0 = wx * vy;
    double s1 = wy * vx;
    double side = Math.copySign(1, c);
    double drift = side * (s0 - s1);
    boolean outside = c * c - scaledSquare > CLEAR * (m * m + scaledSquare) + TINY;
    boolean inRange = margin >= 0;
    if (!(inRange && outside && Math.abs(drift) > CLEAR * (Math.abs(s0) + Math.abs(s1)) + TINY)) {
      return Contact.DOUBT;
    }
    if (drift > 0) {
      return Contact.MISS;
    }
    return part(side, px, py, r, vx, vy, ax, ay, bx, by, margin * ww + TINY);
  }

  /** The contact of a centre that starts outside the strip, on the given side, and approaches. */
  private static int part(
      double side,
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by,
      double doubt) {
    double wx = bx - ax;
    double wy = by - ay;
    double ww = wx * wx + wy * wy;
    double y = r * (vx * wx + vy * wy);
    double yy = y * Math.abs(y);
    double a = (px - ax) * vy - (py - ay) * vx;
    double b = (px - bx) * vy - (py - by) * vx;
    // The side is known late, so it is multiplied in last.
    double scale = side * ww;
    double beyondStart = fma(a * Math.abs(a), scale, yy);
    double beyondEnd = fma(b * Math.abs(b), scale, yy);
    if (!(Math.abs(beyondStart) > doubt && Math.abs(beyondEnd) > doubt)) {
      return Contact.DOUBT;
    }
    if (beyondStart > 0) {
      return endpoint(Contact.START, px, py, r, vx, vy, ax, ay);
    }
    if (beyondEnd < 0) {
      return endpoint(Contact.END, px, py, r, vx, vy, bx, by);
    }
    return side > 0 ? Contact.LEFT : Contact.RIGHT;
  }

  /**
   * The contact with an endpoint, of a centre outside the strip. The centre is further from the
   * endpoint than r by at least 2^-21 of the distance.
   */
  private static int endpoint(
      int end, double px, double py, double r, double vx, double vy, double x, double y) {
    double dx = px - x;
    double dy = py - y;
    double k = dx * vy - dy * vx;
    double dd = dx * dx + dy * dy;
    double vv = vx * vx + vy * vy;
    double rr = r * r;
    double discriminant = vv * rr - k * k;
    double doubt = CLEAR * vv * (dd + rr) + TINY;
    if (discriminant < -doubt) {
      return Contact.MISS;
    }
    if (!(discriminant > doubt)) {
      return Contact.DOUBT;
    }
    // (v.d)^2 = discriminant + v.v (d.d - r^2), so its sign is certain.
    return vx * dx + vy * dy < 0 ? end : Contact.MISS;
  }

  /** The approximate time of a contact that this filter found; its error is {@link #TIME_ERROR}. */
  public static double time(
      int contact,
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by) {
    if (contact == Contact.START) {
      return timeOfEnd(px, py, r, vx, vy, ax, ay);
    }
    if (contact == Contact.END) {
      return timeOfEnd(px, py, r, vx, vy, bx, by);
    }
    double wx = bx - ax;
    double wy = by - ay;
    double c = wx * (py - ay) - wy * (px - ax);
    double ww = wx * wx + wy * wy;
    double gap = c * c - r * r * ww;
    return gap / ((Math.abs(c) + r * Math.sqrt(ww)) * Math.abs(wx * vy - wy * vx));
  }

  /**
   * The plain root of {@link TimeOfImpact}: the time at which the centre enters the disk of radius
   * r around (x, y).
   */
  static double timeOfEnd(
      double px, double py, double r, double vx, double vy, double x, double y) {
    double dx = px - x;
    double dy = py - y;
    double k = dx * vy - dy * vx;
    double dd = dx * dx + dy * dy;
    double vv = vx * vx + vy * vy;
    double rr = r * r;
    return (dd - rr) / (Math.sqrt(vv * rr - k * k) - (vx * dx + vy * dy));
  }
}
