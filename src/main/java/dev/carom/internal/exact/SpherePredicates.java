// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;


/**
 * The decisions of {@code SphereSweep} that plain doubles leave open: {@link Predicates} with a
 * third coordinate, in double-double and then exactly. A third term adds 36 u^2 of itself at most,
 * and a square of a cross product in space, of three, 4 u^2 more: all stays below 400 u^2 of the
 * sum of the terms.
 */
public final class SpherePredicates {

  private SpherePredicates() {}

  /** The sign of u.d, u = v1 - v2, d = c1 - c2. */
  public static int dot(
      double x1, double y1, double z1, double vx1, double vy1, double vz1, double x2, double y2,
      double z2, double vx2, double vy2, double vz2) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double dz = z1 - z2;
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double uz = vz1 - vz2;
    if (ux == 0 && uy == 0 && uz == 0) {
      return 0; // exactly: one moves as the other does
    }
    double px = ux * dx;
    double py = uy * dy;
    double pz = uz * dz;
    double xy = px + py;
    double b = xy + pz;
    double pxl = productTail(ux, differenceTail(vx1, vx2, ux), dx, differenceTail(x1, x2, dx), px);
    double pyl = productTail(uy, differenceTail(vy1, vy2, uy), dy, differenceTail(y1, y2, dy), py);
    double pzl = productTail(uz, differenceTail(vz1, vz2, uz), dz, differenceTail(z1, z2, dz), pz);
    double tail = sumTail(px, py, xy) + sumTail(xy, pz, b) + (pxl + pyl + pzl);
    int sign = Predicates.decided(b + tail, Math.abs(px) + Math.abs(py) + Math.abs(pz), 1);
    return sign != Predicates.UNDECIDED
        ? sign
        : Exact.Disks.of(x1, y1, z1, 0, vx1, vy1, vz1, x2, y2, z2, 0, vx2, vy2, vz2)
            .drift()
            .sign();
  }

  /** The sign of |c1 - c2|^2 - (r1 + r2)^2: whether two spheres are apart. */
  public static int gap(
      double x1, double y1, double z1, double r1, double x2, double y2, double z2, double r2) {
    double x = x1 - x2;
    double y = y1 - y2;
    double z = z1 - z2;
    double r = r1 + r2;
    double rr = r * r;
    double dd = x * x + y * y + z * z;
    double g = dd - rr;
    double ddl =
        squareTail(
            x, differenceTail(x1, x2, x), y, differenceTail(y1, y2, y), z,
            differenceTail(z1, z2, z), dd);
    double rl = sumTail(r1, r2, r);
    double tail = differenceTail(dd, rr, g) + (ddl - productTail(r, rl, r, rl, rr));
    int sign = Predicates.decided(g + tail, dd + rr, 1);
    return sign != Predicates.UNDECIDED
        ? sign
        : Exact.Disks.of(x1, y1, z1, r1, 0, 0, 0, x2, y2, z2, r2, 0, 0, 0).gap().sign();
  }

  /** The sign of |u|^2 (r1 + r2)^2 - |cross(u, d)|^2: whether the path passes within r1 + r2. */
  public static int discriminant(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2) {
    double dx = x1 - x2;
    double dy = y1 - y2;
    double dz = z1 - z2;
    double dxl = differenceTail(x1, x2, dx);
    double dyl = differenceTail(y1, y2, dy);
    double dzl = differenceTail(z1, z2, dz);
    double ux = vx1 - vx2;
    double uy = vy1 - vy2;
    double uz = vz1 - vz2;
    double uxl = differenceTail(vx1, vx2, ux);
    double uyl = differenceTail(vy1, vy2, uy);
    double uzl = differenceTail(vz1, vz2, uz);
    // cross(u, d), each component once more with the tail added to the head
    double x0 = uy * dz - uz * dy;
    double y0 = uz * dx - ux * dz;
    double z0 = ux * dy - uy * dx;
    double x1t = crossTail(uy, uyl, uz, uzl, dy, dyl, dz, dzl, x0);
    double y1t = crossTail(uz, uzl, ux, uxl, dz, dzl, dx, dxl, y0);
    double z1t = crossTail(ux, uxl, uy, uyl, dx, dxl, dy, dyl, z0);
    double kx = x0 + x1t;
    double ky = y0 + y1t;
    double kz = z0 + z1t;
    double kk = kx * kx + ky * ky + kz * kz;
    double kkl =
        squareTail(
            kx, sumTail(x0, x1t, kx), ky, sumTail(y0, y1t, ky), kz, sumTail(z0, z1t, kz), kk);
    double a = ux * ux + uy * uy + uz * uz;
    double al = squareTail(ux, uxl, uy, uyl, uz, uzl, a);
    double r = r1 + r2;
    double rl = sumTail(r1, r2, r);
    double rr = r * r;
    double rrl = productTail(r, rl, r, rl, rr);
    double f = a * rr;
    double value = f - kk;
    double tail = differenceTail(f, kk, value) + (productTail(a, al, rr, rrl, f) - kkl);
    double mx = Math.abs(uy * dz) + Math.abs(uz * dy);
    double my = Math.abs(uz * dx) + Math.abs(ux * dz);
    double mz = Math.abs(ux * dy) + Math.abs(uy * dx);
    int sign =
        Predicates.decided(
            value + tail,
            f + (mx * mx + my * my + mz * mz),
            Math.max(Math.max(a, rr), mx + my + mz));
    return sign != Predicates.UNDECIDED
        ? sign
        : Exact.Disks.of(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2)
            .discriminant()
            .sign();
  }

  /** The tail of |p|^2 for its head h = fl(fl(fl(x x) + fl(y y)) + fl(z z)). */
  private static double squareTail(
      double x, double xl, double y, double yl, double z, double zl, double h) {
    double xx = x * x;
    double yy = y * y;
    double zz = z * z;
    double xy = xx + yy;
    return sumTail(xx, yy, xy)
        + sumTail(xy, zz, h)
        + (productTail(x, xl, x, xl, xx)
            + productTail(y, yl, y, yl, yy)
            + productTail(z, zl, z, zl, zz));
  }
}
