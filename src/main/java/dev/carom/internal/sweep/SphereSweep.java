// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Numbers;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.exact.Ring;

/**
 * A sphere that moves against another that may move too: the {@link TimeOfImpact} of {@link
 * DiskSweep} with a third coordinate. What plain doubles leave open goes to numbers without
 * rounding: {@link GapPolynomial}, then {@link Polynomial}.
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
    if (Double.isNaN(time)) {
      time =
          FallSweep.settled(
              gap(GapPolynomial.EXACT, x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2),
              T);
    }
    return Double.isNaN(time)
        ? exact(
            gap(Polynomial.EXACT, x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2),
            r1 + r2 == 0,
            T)
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
        : gap(Polynomial.EXACT, x1, y1, z1, 0, vx1, vy1, vz1, x2, y2, z2, 0, vx2, vy2, vz2)
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
    double s = Math.sqrt(discriminant);
    double t = g / (s - b);
    double f = residue(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, t);
    double time = TimeOfImpact.corrected(t, f, a, dd + rr, 0.5 / s);
    return time < T ? time : time > T ? NEVER : Double.NaN;
  }

  /** {@code e.e - r^2} at {@code e = d + u t}, in exact numbers. */
  private static <P extends Ring<P>> P gap(
      Numbers<P> of, double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1,
      double x2, double y2, double z2, double r2, double vx2, double vy2, double vz2) {
    P x = of.motion(x1, x2, vx1, vx2, 0);
    P y = of.motion(y1, y2, vy1, vy2, 0);
    P z = of.motion(z1, z2, vz1, vz2, 0);
    P r = of.difference(r1, -r2);
    return x.times(x).plus(y.times(y)).plus(z.times(z)).minus(r.times(r));
  }

  /** The same in exact numbers. A gap without two roots does not fall below 0. */
  private static double exact(Polynomial gap, boolean isPoint, double T) {
    if (gap.sign(Dyadic.ZERO) <= 0) {
      return 0;
    }
    boolean isHit = gap.positiveRoots(null).size() >= (isPoint ? 1 : 2);
    return isHit ? FallSweep.settled(RealRoot.ofStraight(gap), T) : NEVER;
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
        : gap(Polynomial.EXACT, x1, y1, z1, r1, 0, 0, 0, x2, y2, z2, r2, 0, 0, 0).sign(Dyadic.ZERO)
            < 0;
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
