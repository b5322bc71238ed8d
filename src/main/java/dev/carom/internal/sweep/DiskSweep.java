// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.exact.UnitVector;

/**
 * A disk that moves against another that may move too; endpoints are disks of radius zero that
 * rest.
 *
 * <p>Seen from the second disk, the first one's centre starts at the offset {@code d = c1 - c2} and
 * moves with {@code u = v1 - v2}; they touch where it comes to the distance {@code r = r1 + r2}: a
 * {@link TimeOfImpact}, with cross(u, d) a single number.
 *
 * <p>The numbers are arguments, not a value, for the reason that {@link SegmentSweep} gives.
 */
public final class DiskSweep {

  private DiskSweep() {}

  /** The contact of two disks that touch while approaching: NOW, LATER or MISS. */
  public static int contact(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2) {
    // u.d, then d.d - r^2, then u.u r^2 - cross(u, d)^2
    if (Predicates.dot(vx1, vy1, vx2, vy2, x1, y1, x2, y2) >= 0) {
      return Contact.MISS;
    }
    if (Predicates.gap(x1, y1, x2, y2, r1, r2) <= 0) {
      return Contact.NOW;
    }
    int sign = Predicates.discriminant(vx1, vy1, vx2, vy2, x1, y1, x2, y2, r1, r2);
    return sign > 0 || (sign == 0 && r1 + r2 == 0) ? Contact.LATER : Contact.MISS;
  }

  /** Whether the distance of the centres is less than r1 + r2. */
  public static boolean overlaps(double x1, double y1, double r1, double x2, double y2, double r2) {
    return Predicates.gap(x1, y1, x2, y2, r1, r2) < 0;
  }

  /**
   * The correctly rounded time of a contact, {@code +infinity} if it is a MISS or later than the
   * window's end T.
   *
   * <p>It is the plain root {@code t = g / (-b + sqrt(discriminant))}, in which nothing cancels but
   * g and, near a graze, discriminant, corrected by a step. Where that leaves the rounding open, or
   * the end of the window is the answer, numbers without rounding decide.
   */
  public static double time(
      int contact, double x1, double y1, double r1, double vx1, double vy1, double x2, double y2,
      double r2, double vx2, double vy2, double T) {
    if (contact != Contact.LATER) {
      return contact == Contact.NOW ? 0 : Double.POSITIVE_INFINITY;
    }
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double r = r1 + r2;
    double rr = r * r;
    double dd = dx * dx + dy * dy;
    double w = dd + rr;
    double b = ux * dx + uy * dy;
    double a = ux * ux + uy * uy;
    double k = ux * dy - uy * dx;
    double s = Math.sqrt(a * rr - k * k);
    double t = (dd - rr) / (s - b);
    double f = residue(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, t);
    double time = TimeOfImpact.corrected(t, f, a, w, 0.5 / s);
    PrecisionCounter.ROOTS.add();
    if (time < T) {
      return time;
    }
    return time > T
        ? Double.POSITIVE_INFINITY
        : FallSweep.settled(
            fall(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2), Contact.LATER, T);
  }

  /** The question for exact numbers. */
  private static Fall fall(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2) {
    return new Fall().flight(x1, y1, r1, vx1, vy1, 0, 0).disk(x2, y2, r2, vx2, vy2);
  }

  /** {@code f(t) = e.e - r^2} at {@code e = d + u t}. Cancelling terms have head and tail. */
  private static double residue(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, double t) {
    double x = (x1 - x2) + (vx1 - vx2) * t;
    double y = (y1 - y2) + (vy1 - vy2) * t;
    double r = r1 + r2;
    return TimeOfImpact.gap(
        x, terms(x1, x2, vx1, vx2, t), y, terms(y1, y2, vy1, vy2, t), r, sumTail(r1, r2, r));
  }

  /** The rounding error of d + u t on one axis, below 4 u of its terms. */
  static double terms(double x1, double x2, double v1, double v2, double t) {
    double d = x1 - x2;
    double u = v1 - v2;
    double m = u * t;
    double ml = fma(differenceTail(v1, v2, u), t, productTail(u, t, m));
    return sumTail(d, m, d + m) + (differenceTail(x1, x2, d) + ml);
  }

  /**
   * The unit normal at contact, from the second disk to the first, each component within 1e-15.
   *
   * @param out receives the normal
   * @param t the time of impact; 0 also for one that is rounded to 0
   */
  public static UnitVector normal(
      UnitVector out, double x1, double y1, double r1, double vx1, double vy1, double x2,
      double y2, double r2, double vx2, double vy2, double t) {
    if (t == 0 && isNow(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2)) {
      return UnitVectors.unit(out, x1, y1, x2, y2);
    }
    double c = t == 0 ? Double.NaN : correction(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, t);
    if (Double.isNaN(c)) {
      PrecisionCounter.EXACT_NORMALS.add();
      Fall fall = fall(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
      return out.set(FallSweep.exact(fall).normal(FallSweep.exactTime(fall, Contact.LATER)));
    }
    return UnitVectors.unit(
        out, offset(x1, x2, vx1, vx2, t, c), offset(y1, y2, vy1, vy2, t, c), 0, 0);
  }

  /**
   * Whether the normal at time 0 is that of the start. It may be another one only if the true time
   * is rounded to 0, and the disks are so fast that they move by a part of their radii until then.
   */
  static boolean isNow(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2) {
    double way = Double.MIN_VALUE * (Math.abs(vx1 - vx2) + Math.abs(vy1 - vy2));
    return way < 0x1p-60 * (r1 + r2) || Predicates.gap(x1, y1, x2, y2, r1, r2) <= 0;
  }

  /**
   * What the rounded time t of an impact lacks, to within 2^-54 of what the sum of the radii takes;
   * NaN if that is not known so well.
   */
  public static double correction(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, double t) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double r = r1 + r2;
    double w = dx * dx + dy * dy + r * r;
    double a = ux * ux + uy * uy;
    double bx = ux * dx;
    double by = uy * dy;
    double half = -0.5 / (bx + by + a * t);
    double c = residue(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, t) * half;
    double lean = TimeOfImpact.lean(half, Math.abs(bx) + Math.abs(by) + a * t, t);
    double error = TimeOfImpact.stepError(w, a, half, lean, c);
    return error * (Math.abs(ux) + Math.abs(uy)) < 0x1p-54 * r ? c : Double.NaN;
  }

  /** The offset at contact on one axis: d + u (t + c), c from {@link #correction}. */
  public static double offset(
      double x1, double x2, double v1, double v2, double t, double c) {
    return ((x1 - x2) + (v1 - v2) * t) + (terms(x1, x2, v1, v2, t) + (v1 - v2) * c);
  }
}
