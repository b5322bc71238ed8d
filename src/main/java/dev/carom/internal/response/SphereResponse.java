// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

/**
 * The velocities of two spheres, or of two circles, after an impact without a world. With {@code n
 * = c1 - c2}, {@code u = v1 - v2} and {@code J = f (u.n) / (n.n)}: {@code v1 -= m2 / (m1 + m2) J n}
 * and {@code v2 += m1 / (m1 + m2) J n}.
 */
public final class SphereResponse {

  /** Speeds whose exponent is below this in size are multiplied without overflow or underflow. */
  private static final int ORDINARY = 300;

  private SphereResponse() {}

  /**
   * Removes f times the part of the relative velocity along n. Powers of two keep all products in
   * the range of doubles: n is scaled to about 1, and u and f if need be.
   *
   * @param v the velocity of the first and of the second: three components each, or two in the
   *     plane
   */
  public static void respond(
      double x1,
      double y1,
      double z1,
      double m1,
      double x2,
      double y2,
      double z2,
      double m2,
      double f,
      double[] v) {
    int size = Math.max(exponent(x1, x2), Math.max(exponent(y1, y2), exponent(z1, z2)));
    double nx = difference(x1, x2, size);
    double ny = difference(y1, y2, size);
    double nz = difference(z1, z2, size);
    int second = v.length / 2;
    double vz1 = second == 3 ? v[2] : 0;
    double vz2 = second == 3 ? v[5] : 0;
    int speed =
        Math.max(
            Math.max(exponent(v[0], v[second]), exponent(v[1], v[second + 1])), exponent(vz1, vz2));
    int ofU = Math.abs(speed) < ORDINARY ? 0 : speed;
    int ofF = f < 0x1p100 ? 0 : Math.getExponent(f);
    double ux = difference(v[0], v[second], ofU);
    double uy = difference(v[1], v[second + 1], ofU);
    double uz = difference(vz1, vz2, ofU);
    double g = Math.scalb(f, -ofF);
    // j = g u.n / n.n as head and tail, as in Impulse
    double nn = dot(nx, ny, nz, nx, ny, nz);
    double un = dot(ux, uy, uz, nx, ny, nz);
    double gun = g * un;
    double j = gun / nn;
    double rest = fma(-j, nn, gun) + productTail(g, un, gun);
    double nnl = dotTail(nx, ny, nz, nx, ny, nz);
    double tail = (rest + (g * dotTail(ux, uy, uz, nx, ny, nz) - j * nnl)) / nn;
    push(v, 0, -1, m2, m1, j, tail, ofU + ofF, nx, ny, nz);
    push(v, second, 1, m1, m2, j, tail, ofU + ofF, nx, ny, nz);
  }

  /** The exponent of a difference; if it overflows, one more than the largest. */
  private static int exponent(double p, double q) {
    return Math.getExponent(p - q);
  }

  /** (p - q) / 2^exponent. */
  private static double difference(double p, double q, int exponent) {
    double d = p - q;
    return Math.abs(d) <= Double.MAX_VALUE
        ? Math.scalb(d, -exponent)
        : Math.scalb(p, -exponent) - Math.scalb(q, -exponent);
  }

  /** Gives a sphere its share of the impulse: the other's mass over the sum of both. */
  private static void push(
      double[] v,
      int at,
      int sign,
      double other,
      double own,
      double j,
      double tail,
      int exponent,
      double nx,
      double ny,
      double nz) {
    if (own == Double.POSITIVE_INFINITY) {
      return;
    }
    boolean all = other == Double.POSITIVE_INFINITY;
    double sum = other + own;
    double share = all ? 1 : other / sum;
    double rest = fma(-share, sum, other) - share * sumTail(other, own, sum);
    double shareTail = all ? 0 : rest / sum;
    double s = sign * share;
    double sl = sign * shareTail;
    v[at] = Impulse.change(j, tail, exponent, v[at], s, sl, nx);
    v[at + 1] = Impulse.change(j, tail, exponent, v[at + 1], s, sl, ny);
    if (v.length == 6) {
      v[at + 2] = Impulse.change(j, tail, exponent, v[at + 2], s, sl, nz);
    }
  }

  private static double dot(double ax, double ay, double az, double bx, double by, double bz) {
    return ax * bx + ay * by + az * bz;
  }

  /** The rounding error of {@link #dot}, to first order. */
  private static double dotTail(double ax, double ay, double az, double bx, double by, double bz) {
    double x = ax * bx;
    double y = ay * by;
    double z = az * bz;
    double xy = x + y;
    return sumTail(x, y, xy)
        + sumTail(xy, z, xy + z)
        + (productTail(ax, bx, x) + productTail(ay, by, y) + productTail(az, bz, z));
  }
}
