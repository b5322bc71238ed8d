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

  /** The first contact. */
  private static final int FIRST = 0;

  /** The first contact of a disk that does not overlap the other at the start. */
  private static final int FROM_OUTSIDE = 1;

  /** The first entry after a time. */
  private static final int LATER = 2;

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
    double time = certainFirst(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, T);
    return !Double.isNaN(time)
        ? time
        : ExactParabola.disk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2).time(T);
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
    double time = certainAfter(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, s, T);
    return !Double.isNaN(time)
        ? time
        : ExactParabola.disk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2).timeAfter(s, T);
  }

  /**
   * The {@link #time} of a disk that does not overlap the other at the start, if doubles and
   * double-double tell: NaN also for one that overlaps it by more than rounding, and leaves.
   *
   * @param from a time before which there is no contact, or 0
   */
  static double certain(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double from, double T) {
    return certain(FROM_OUTSIDE, x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, from, T);
  }

  /** The {@link #timeAfter}, if doubles and double-double tell. */
  static double certainAfter(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double s, double T) {
    double time = certain(LATER, x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, s, T);
    return time > s ? time : GapRoot.DOUBT;
  }

  /** The {@link #time}, if doubles and double-double tell. */
  static double certainFirst(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double T) {
    return certain(FIRST, x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, 0, T);
  }

  private static double certain(
      int contact, double x1, double y1, double r1, double vx1, double vy1, double gx, double gy,
      double x2, double y2, double r2, double vx2, double vy2, double s, double T) {
    double time = inDoubles(contact, x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, s, T);
    return Double.isNaN(time)
            && new DiskGap(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2).staysOutside(r1, r2)
        ? NEVER
        : time;
  }

  private static double inDoubles(
      int contact, double x1, double y1, double r1, double vx1, double vy1, double gx, double gy,
      double x2, double y2, double r2, double vx2, double vy2, double s, double T) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double r = r1 + r2;
    double c0 = (dx * dx + dy * dy) - r * r;
    double c1 = 2 * (dx * ux + dy * uy);
    double c2 = (ux * ux + uy * uy) + (dx * gx + dy * gy);
    double c3 = ux * gx + uy * gy;
    double c4 = 0.25 * (gx * gx + gy * gy);
    double m0 = Math.abs(dx) + Math.abs(dy) + r;
    double m1 = Math.abs(ux) + Math.abs(uy);
    double m2 = 0.5 * (Math.abs(gx) + Math.abs(gy));
    double end = GapRoot.reach(m0, m1, 0.5 * Math.max(Math.abs(gx), Math.abs(gy)), T);
    double start = Math.max(0, s);
    int side = GapRoot.sign(c0, c1, c2, c3, c4, m0, m1, m2, start);
    if (side == 0 && s > 0) {
      double f = residue(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, s);
      double slope = slope(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2, s);
      side = GapRoot.signAfter(s, f, slope, m0 + (m1 + m2 * s) * s);
    }
    if (side < 0 && contact == LATER) {
      start = GapRoot.comesOut(c0, c1, c2, c3, c4, m0, m1, m2, start, end);
    } else if (side <= 0 && s > 0) {
      return GapRoot.DOUBT;
    } else if (side <= 0) {
      if (contact != LATER && GapRoot.sign(c1, 2 * m0 * m1) < 0) {
        if (side < 0 || Predicates.gap(x1, y1, x2, y2, r1, r2) <= 0) {
          return 0;
        }
        double late = late(c0, c1, c2, m0, m1, m2);
        double time = timeNear(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, 0);
        return time <= late ? GapRoot.upTo(T, time) : GapRoot.DOUBT;
      }
      if (side < 0 && contact == FROM_OUTSIDE) {
        return GapRoot.DOUBT;
      }
      start = GapRoot.leaves(c0, c1, c2, c3, c4, m0, m1, m2, end);
      if (side == 0 && Double.isNaN(start)) {
        double t = GapRoot.rise(c1, c2, c3, c4, m0, m1, m2, end);
        double f = residue(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, t);
        start = GapRoot.isAbove(t, f, m0 + (m1 + m2 * t) * t) ? t : GapRoot.DOUBT;
      }
    }
    if (!(start < NEVER)) {
      return start;
    }
    double t = GapRoot.first(c0, c1, c2, c3, c4, m0, m1, m2, start, end);
    if (!(t < NEVER)) {
      return t;
    }
    double nearest =
        GapRoot.beside(t, nearest(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, t));
    if (Double.isNaN(nearest)) {
      double late = s <= 0 && side > 0 ? late(c0, c1, c2, m0, m1, m2) : 0;
      double time = timeNear(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, t < late ? 0 : t);
      nearest = time <= late ? GapRoot.upTo(T, time) : GapRoot.beside(t, time);
    }
    return nearest;
  }

  /**
   * A time by which the gap, above 0 at the start, has fallen below 0 without a turn; -1 if that is
   * not certain.
   */
  private static double late(double c0, double c1, double c2, double m0, double m1, double m2) {
    double late = 2 * (Math.abs(c0) + GapRoot.error(m0 * m0)) / -c1;
    return late > 0 && GapRoot.falls(c1, c2, m0, m1, m2, late) ? late : -1;
  }

  private static double timeNear(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double t) {
    return new DiskGap(x1, y1, vx1, vy1, gx, gy, x2, y2, vx2, vy2).nearest(r1, r2, t);
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
