// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.ExactTime;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.PrecisionCounter;

/**
 * A sphere that moves against another that may move too: the {@link TimeOfImpact} of {@link
 * DiskSweep} with a third coordinate. What plain doubles leave open is decided by exact numbers,
 * without a rung in between.
 *
 * <p>The numbers are arguments, not a value, for the reason that {@link SegmentSweep} gives.
 */
public final class SphereSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private SphereSweep() {}

  /** The correctly rounded time of impact, {@code +infinity} for none up to the window's end T. */
  public static double time(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double T) {
    if (drift(x1, y1, z1, vx1, vy1, vz1, x2, y2, z2, vx2, vy2, vz2) >= 0) {
      return NEVER;
    }
    double time = plain(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, T);
    return Double.isNaN(time)
        ? exact(gap(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2), r1 + r2 == 0, T)
        : time;
  }

  /** A number with the sign of u.d, u = v1 - v2, d = c1 - c2: below 0 if the spheres approach. */
  public static double drift(
      double x1, double y1, double z1, double vx1, double vy1, double vz1, double x2, double y2,
      double z2, double vx2, double vy2, double vz2) {
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double uz = vz1 - vz2;
    double bx = ux * (x1 - x2);
    double by = uy * (y1 - y2);
    double bz = uz * (z1 - z2);
    double b = bx + by + bz;
    boolean isAlike = ux == 0 && uy == 0 && uz == 0; // exactly: one moves as the other does
    return isAlike
            || Math.abs(b) > TimeOfImpact.dotBound(Math.abs(bx) + Math.abs(by) + Math.abs(bz))
        ? b
        : gap(x1, y1, z1, 0, vx1, vy1, vz1, x2, y2, z2, 0, vx2, vy2, vz2)
            .derivative()
            .sign(Dyadic.ZERO);
  }

  /** The time of impact of spheres that approach each other; NaN where a bound leaves it open. */
  private static double plain(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double T) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double dz = z1 - z2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double uz = vz1 - vz2;
    // g = d.d - r^2
    double r = r1 + r2;
    double rr = r * r;
    double dd = dx * dx + dy * dy + dz * dz;
    double g = dd - rr;
    if (!(Math.abs(g) > TimeOfImpact.gapBound(dd + rr))) {
      return Double.NaN;
    }
    if (g < 0) {
      return 0;
    }
    // discriminant = a r^2 - |cross(u, d)|^2
    double a = ux * ux + uy * uy + uz * uz;
    double kx = uy * dz - uz * dy;
    double ky = uz * dx - ux * dz;
    double kz = ux * dy - uy * dx;
    double discriminant = a * rr - (kx * kx + ky * ky + kz * kz);
    if (!(Math.abs(discriminant) > TimeOfImpact.discriminantBound(a, dd + rr))) {
      return Double.NaN;
    }
    if (discriminant < 0) {
      return NEVER;
    }
    PrecisionCounter.ROOTS.add();
    double b = ux * dx + uy * dy + uz * dz;
    double t = g / (Math.sqrt(discriminant) - b);
    return refined(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, T, t);
  }

  /**
   * Corrects the time t of an impact by steps, until its rounding is known; NaN if no step tells.
   */
  static double refined(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double T, double start) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double dz = z1 - z2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double uz = vz1 - vz2;
    double r = r1 + r2;
    double w = dx * dx + dy * dy + dz * dz + r * r;
    double a = ux * ux + uy * uy + uz * uz;
    double b = ux * dx + uy * dy + uz * dz;
    double terms = Math.abs(ux * dx) + Math.abs(uy * dy) + Math.abs(uz * dz);
    double t = start;
    for (int i = 0; i < TimeOfImpact.STEPS && t > 0; i++) {
      PrecisionCounter.STEPS.add();
      double half = -0.5 / (b + a * t);
      double c = residue(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, t) * half;
      double lean = TimeOfImpact.lean(half, terms + a * t, t);
      double error = TimeOfImpact.stepError(w, a, half, lean, c);
      double time = TimeOfImpact.rounded(t, c, error);
      if (time < T || t + (c - error) > T) {
        return time < T ? time : NEVER;
      }
      t += c;
    }
    return Double.NaN;
  }

  /** {@code e.e - r^2} at {@code e = d + u t}, in exact numbers. */
  private static Polynomial gap(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2) {
    Polynomial x = Polynomial.EXACT.motion(x1, x2, vx1, vx2, 0);
    Polynomial y = Polynomial.EXACT.motion(y1, y2, vy1, vy2, 0);
    Polynomial z = Polynomial.EXACT.motion(z1, z2, vz1, vz2, 0);
    Polynomial r = Polynomial.EXACT.difference(r1, -r2);
    return x.times(x).plus(y.times(y)).plus(z.times(z)).minus(r.times(r));
  }

  /** The same in exact numbers. */
  private static double exact(Polynomial gap, boolean isPoint, double T) {
    if (gap.sign(Dyadic.ZERO) <= 0) {
      return 0;
    }
    ExactTime time = ExactTime.of(gap);
    int discriminant = time.q().sign();
    return discriminant > 0 || (discriminant == 0 && isPoint) ? time.upTo(T) : NEVER;
  }

  /** Whether the distance of the centres is less than r1 + r2. */
  public static boolean overlaps(
      double x1, double y1, double z1, double r1, double x2, double y2, double z2, double r2) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double dz = z1 - z2;
    double r = r1 + r2;
    double dd = dx * dx + dy * dy + dz * dz;
    double g = dd - r * r;
    return Math.abs(g) > TimeOfImpact.gapBound(dd + r * r)
        ? g < 0
        : gap(x1, y1, z1, r1, 0, 0, 0, x2, y2, z2, r2, 0, 0, 0).sign(Dyadic.ZERO) < 0;
  }

  /** {@code f(t) = e.e - r^2} at {@code e = d + u t}. Cancelling terms have head and tail. */
  private static double residue(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double t) {
    double x = (x1 - x2) + (vx1 - vx2) * t;
    double y = (y1 - y2) + (vy1 - vy2) * t;
    double z = (z1 - z2) + (vz1 - vz2) * t;
    double xl = DiskSweep.terms(x1, x2, vx1, vx2, t);
    double yl = DiskSweep.terms(y1, y2, vy1, vy2, t);
    double zl = DiskSweep.terms(z1, z2, vz1, vz2, t);
    double r = r1 + r2;
    double rl = sumTail(r1, r2, r);
    double xx = x * x;
    double yy = y * y;
    double zz = z * z;
    double rr = r * r;
    double xy = xx + yy;
    double ee = xy + zz;
    double f = ee - rr;
    return f
        + ((sumTail(xx, yy, xy) + sumTail(xy, zz, ee) + differenceTail(ee, rr, f))
            + ((productTail(x, x, xx) + productTail(y, y, yy) + productTail(z, z, zz))
                - productTail(r, r, rr))
            + 2 * (x * xl + y * yl + z * zl - r * rl));
  }
}
