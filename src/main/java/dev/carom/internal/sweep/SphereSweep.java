// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.Exact;
import dev.carom.internal.exact.PrecisionCounters;
import dev.carom.internal.exact.SpherePredicates;

/**
 * A sphere that moves against another that may move too: the {@link TimeOfImpact} of {@link
 * DiskSweep} with a third coordinate.
 */
public final class SphereSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private SphereSweep() {}

  /** The correctly rounded time of impact, {@code +infinity} for none up to the window's end T. */
  public static double time(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double T) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double dz = z1 - z2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double uz = vz1 - vz2;
    // b = u.d
    double bx = ux * dx;
    double by = uy * dy;
    double bz = uz * dz;
    double b = bx + by + bz;
    if (!(Math.abs(b) > TimeOfImpact.dotBound(Math.abs(bx) + Math.abs(by) + Math.abs(bz)))) {
      b = SpherePredicates.dot(x1, y1, z1, vx1, vy1, vz1, x2, y2, z2, vx2, vy2, vz2);
    }
    if (b >= 0) {
      return NEVER;
    }
    // g = d.d - r^2
    double r = r1 + r2;
    double rr = r * r;
    double dd = dx * dx + dy * dy + dz * dz;
    double g = dd - rr;
    if (!(Math.abs(g) > TimeOfImpact.gapBound(dd + rr))) {
      g = SpherePredicates.gap(x1, y1, z1, r1, x2, y2, z2, r2);
    }
    if (g <= 0) {
      return 0;
    }
    // discriminant = a r^2 - |cross(u, d)|^2
    double a = ux * ux + uy * uy + uz * uz;
    double kx = uy * dz - uz * dy;
    double ky = uz * dx - ux * dz;
    double kz = ux * dy - uy * dx;
    double discriminant = a * rr - (kx * kx + ky * ky + kz * kz);
    double sign = discriminant;
    if (!(Math.abs(discriminant) > TimeOfImpact.discriminantBound(a, dd + rr))) {
      sign = SpherePredicates.discriminant(
          x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2);
    }
    if (!(sign > 0 || (sign == 0 && r == 0))) {
      return NEVER;
    }
    double s = Math.sqrt(discriminant);
    double t = (dd - rr) / (s - (bx + by + bz));
    PrecisionCounters.root();
    if (t > T && isLater(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, T)) {
      return NEVER;
    }
    double half = 0.5 / s;
    double c = residue(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, t) * half;
    double lean = TimeOfImpact.firstLean(a, dd + rr, half);
    double time = TimeOfImpact.rounded(t, c, TimeOfImpact.stepError(dd + rr, a, half, lean, c));
    if (time < T) {
      return time;
    }
    return time > T
        ? NEVER
        : refined(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, T, t + c);
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
    if (!(Math.abs(g) > TimeOfImpact.gapBound(dd + r * r))) {
      g = SpherePredicates.gap(x1, y1, z1, r1, x2, y2, z2, r2);
    }
    return g < 0;
  }

  /** Refines the time t by more steps; exact numbers decide if no step can. */
  private static double refined(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double T,
      double start) {
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
      PrecisionCounters.step();
      double half = -0.5 / (b + a * t);
      double c = residue(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, t) * half;
      double lean = TimeOfImpact.lean(half, terms + a * t, t);
      double time = TimeOfImpact.rounded(t, c, TimeOfImpact.stepError(w, a, half, lean, c));
      if (time < T) {
        return time;
      }
      if (time > T) {
        return NEVER;
      }
      t += c;
    }
    return Exact.Disks.of(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2).time(T);
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

  /** Whether plain doubles are certain that the impact comes after the window's end T. */
  private static boolean isLater(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double T) {
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double uz = vz1 - vz2;
    double ex = (x1 - x2) + ux * T;
    double ey = (y1 - y2) + uy * T;
    double ez = (z1 - z2) + uz * T;
    double x = Math.abs(x1 - x2) + Math.abs(ux * T);
    double y = Math.abs(y1 - y2) + Math.abs(uy * T);
    double z = Math.abs(z1 - z2) + Math.abs(uz * T);
    double r = r1 + r2;
    double rr = r * r;
    return TimeOfImpact.order(
            ux * ex + uy * ey + uz * ez,
            Math.abs(ux) * x + Math.abs(uy) * y + Math.abs(uz) * z,
            (ex * ex + ey * ey + ez * ez) - rr,
            x * x + y * y + z * z + rr,
            x + y + z,
            T)
        > 0;
  }
}
