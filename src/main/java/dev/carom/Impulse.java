// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.DoubleDouble.productTail;
import static dev.carom.DoubleDouble.sumTail;

/**
 * The impulse j n of an impact, {@code j = f (v.n) / (n.n)}, with j kept as head and tail, so that
 * a velocity is rounded once, to the nearest double of what it should be. Plain doubles would round
 * n.n too, for one line always alike: the energy would drift by that much at each of its impacts,
 * where a single rounding makes it walk at random.
 */
final class Impulse {

  private double j;
  private double tail;

  /** The impulse that takes away f times the part of v along n. */
  void of(double f, double vx, double vy, double nx, double ny) {
    double xx = nx * nx;
    double yy = ny * ny;
    double nn = xx + yy;
    double nnl = sumTail(xx, yy, nn) + (productTail(nx, nx, xx) + productTail(ny, ny, yy));
    double x = vx * nx;
    double y = vy * ny;
    double vn = x + y;
    double vnl = sumTail(x, y, vn) + (productTail(vx, nx, x) + productTail(vy, ny, y));
    double fvn = f * vn;
    j = fvn / nn;
    // What is left of f v.n - j n.n
    double rest = Math.fma(-j, nn, fvn) + productTail(f, vn, fvn);
    tail = (rest + (f * vnl - j * nnl)) / nn;
  }

  /** v + share j n on one axis, rounded once; the share as head and tail. */
  double change(double v, double share, double shareTail, double n) {
    return change(j, tail, v, share, shareTail, n);
  }

  /** The same for an impulse j n with j as head and tail. */
  static double change(double j, double tail, double v, double share, double shareTail, double n) {
    double s = share * j;
    double sl = productTail(share, j, s) + (share * tail + shareTail * j);
    double p = s * n;
    double w = v + p;
    return w + (sumTail(v, p, w) + (productTail(s, n, p) + sl * n));
  }
}
