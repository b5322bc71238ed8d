// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.PrecisionCounters;
import dev.carom.internal.exact.UnitVector;

/**
 * A disk with a constant acceleration g against a disk that moves straight on or rests. Endpoints
 * are disks of radius zero.
 *
 * <p>With the offset {@code d = c1 - c2}, the velocity {@code u = v1 - v2} and {@code r = r1 + r2},
 * the gap is {@code |d + u t + g t^2 / 2|^2 - r^2}. Its coefficients are {@code d.d - r^2, 2 d.u,
 * u.u + d.g, u.g, g.g / 4}.
 */
public final class ParabolaDiskSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private ParabolaDiskSweep() {}

  /** The correctly rounded time of impact, {@code +infinity} for none up to the window's end T. */
  public static double time(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double T) {
    if (gx == 0 && gy == 0) {
      int contact = DiskSweep.contact(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
      return DiskSweep.time(contact, x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, T);
    }
    PrecisionCounters.parabola();
    double time = DirectHit.ofDisk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, T);
    if (!Double.isNaN(time)) {
      return time;
    }
    Fall fall = Fall.ofDisks(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2);
    time = fall.first(T);
    return Double.isNaN(time) ? fall.exactly().time(T) : time;
  }

  /**
   * The correctly rounded time of the first entry that is above s: the gap comes from above 0 and
   * falls below 0. Contact at the start is no entry. It is {@code +infinity} for none up to the
   * window's end T.
   *
   * @param s a time from 0 on, or -1 for the first entry of all
   */
  public static double timeAfter(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double s, double T) {
    if (!(s < T)) {
      return NEVER;
    }
    if (gx == 0 && gy == 0) {
      int contact = DiskSweep.contact(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
      double t =
          contact == Contact.NOW
              ? NEVER
              : DiskSweep.time(contact, x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, T);
      return t > s ? t : NEVER;
    }
    PrecisionCounters.parabola();
    double time = DirectHit.ofDisk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, T);
    if (time > s) {
      return time;
    }
    Fall fall = Fall.ofDisks(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2);
    time = fall.entryAfter(s, T);
    return Double.isNaN(time) ? fall.exactly().timeAfter(s, T) : time;
  }

  /** The double nearest to the root, DOUBT if some corrections of t do not tell. */
  static double nearest(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double start) {
    double t = start;
    double nearest = GapRoot.DOUBT;
    for (int i = 0; i < GapRoot.CORRECTIONS && Double.isNaN(nearest); i++) {
      double f = residue(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, t);
      double slope = slope(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2, t);
      double sizeX = Offset.size(x1 - x2, vx1 - vx2, gx, t);
      double sizeY = Offset.size(y1 - y2, vy1 - vy2, gy, t);
      double size = r1 + r2 + sizeX + sizeY;
      nearest = GapRoot.nearest(t, f, slope, size);
      t -= f / slope;
    }
    return nearest;
  }

  /**
   * The unit normal at an impact, from the second disk to the first, each component within 1e-15;
   * null if doubles and double-double do not tell.
   *
   * @param t the time of impact
   */
  public static UnitVector normal(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double t) {
    if (t == 0) {
      boolean haveOneCentre = x1 == x2 && y1 == y2; // the normal is where they come from
      boolean isNow = DiskSweep.isNow(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
      return haveOneCentre || !isNow ? null : UnitVectors.unit(x1, y1, x2, y2);
    }
    double x = Offset.head(x1, x2, vx1, vx2, gx, t);
    double y = Offset.head(y1, y2, vy1, vy2, gy, t);
    double ux = Offset.speed(vx1, vx2, gx, t);
    double uy = Offset.speed(vy1, vy2, gy, t);
    double slope = 2 * (x * ux + y * uy);
    double c = -residue(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, t) / slope;
    double sizeX = Offset.size(x1 - x2, vx1 - vx2, gx, t);
    double sizeY = Offset.size(y1 - y2, vy1 - vy2, gy, t);
    // t is within an ulp of the impact: so is the place, but for this much and the bend's u^2.
    double error = GapRoot.stepError(t, c, slope, r1 + r2 + sizeX + sizeY);
    if (!(error * 2 * (sizeX + sizeY) < 0x1p-55 * (r1 + r2) * t)) {
      return null;
    }
    double xl = Offset.tail(x1, x2, vx1, vx2, gx, t);
    double yl = Offset.tail(y1, y2, vy1, vy2, gy, t);
    return UnitVectors.unit(x + (xl + ux * c), y + (yl + uy * c), 0, 0);
  }

  /** The slope of the gap at t. */
  private static double slope(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2, double t) {
    double x = Offset.head(x1, x2, vx1, vx2, gx, t);
    double y = Offset.head(y1, y2, vy1, vy2, gy, t);
    return 2 * (x * Offset.speed(vx1, vx2, gx, t) + y * Offset.speed(vy1, vy2, gy, t));
  }

  /** The gap at t. What cancels is kept as head and tail. */
  private static double residue(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double t) {
    double x = Offset.head(x1, x2, vx1, vx2, gx, t);
    double y = Offset.head(y1, y2, vy1, vy2, gy, t);
    double xl = Offset.tail(x1, x2, vx1, vx2, gx, t);
    double yl = Offset.tail(y1, y2, vy1, vy2, gy, t);
    double r = r1 + r2;
    double rl = sumTail(r1, r2, r);
    double xx = x * x;
    double yy = y * y;
    double rr = r * r;
    double ee = xx + yy;
    double f = ee - rr;
    return f
        + ((sumTail(xx, yy, ee) + differenceTail(ee, rr, f))
            + ((productTail(x, x, xx) + productTail(y, y, yy)) - productTail(r, r, rr))
            + 2 * (x * xl + y * yl - r * rl));
  }
}
