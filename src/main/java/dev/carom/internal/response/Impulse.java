// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

/**
 * The impulse j n of an impact, {@code j = f (v.n) / (n.n)}. As j is kept as head and tail, the new
 * velocity is rounded once, to the nearest double.
 *
 * <p>Plain doubles would also round n.n, always alike for the same line. The energy would then
 * drift the same way at each impact with it; a single rounding lets it walk at random.
 */
public final class Impulse {

  /** With v and n in the range of these sizes, no product leaves the range of doubles. */
  private static final double LEAST_SAFE = 0x1p-300;

  private static final double MOST_SAFE = 0x1p300;

  /** The largest f for which that holds. */
  private static final double MOST_F = 0x1p100;

  private double j;
  private double tail;

  /** The impulse is (j + tail) n 2^exponent; the exponent is 0 for ordinary sizes. */
  private int exponent;

  /** Sets the impulse that removes f times the part of v along n, n of 2^-300 to 2^300. */
  public void of(double f, double vx, double vy, double nx, double ny) {
    double size = Math.max(Math.abs(vx), Math.abs(vy));
    if (size > LEAST_SAFE && size < MOST_SAFE && f < MOST_F) {
      exponent = 0;
      ofOrdinary(f, vx, vy, nx, ny);
    } else {
      int ofV = Math.getExponent(size);
      int ofF = f < MOST_F ? 0 : Math.getExponent(f);
      exponent = ofV + ofF;
      ofOrdinary(Math.scalb(f, -ofF), Math.scalb(vx, -ofV), Math.scalb(vy, -ofV), nx, ny);
    }
  }

  /** Makes the impulse 2^n times as large. */
  void scale(int n) {
    exponent += n;
  }

  private void ofOrdinary(double f, double vx, double vy, double nx, double ny) {
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
    // rest = f v.n - j n.n
    double rest = fma(-j, nn, fvn) + productTail(f, vn, fvn);
    // A multiplication by 1 / n.n would be faster, but leave 2^-107 of a velocity that should halt.
    tail = (rest + (f * vnl - j * nnl)) / nn;
  }

  /** v - j n on one axis: the whole impulse, from a partner that stays at rest. */
  public double less(double v, double n) {
    if (exponent != 0) {
      return change(v, -1, 0, n);
    }
    double p = -j * n;
    double w = v + p;
    return w + (sumTail(v, p, w) + (productTail(-j, n, p) - tail * n));
  }

  /** v + share j n on one axis, with the share as head and tail. */
  public double change(double v, double share, double shareTail, double n) {
    return change(j, tail, exponent, v, share, shareTail, n);
  }

  /**
   * The same for an impulse j n 2^exponent, j as head and tail. It is rounded once if the exponent
   * is 0.
   */
  public static double change(
      double j, double tail, int exponent, double v, double share, double shareTail, double n) {
    if (exponent == 0) {
      return change(j, tail, v, share, shareTail, n);
    }
    double change = change(j, tail, 0, share, shareTail, n);
    double after = v + Math.scalb(change, exponent);
    return Math.abs(after) <= Double.MAX_VALUE
        ? after
        : Math.scalb(Math.scalb(v, -exponent) + change, exponent);
  }

  private static double change(
      double j, double tail, double v, double share, double shareTail, double n) {
    double s = share * j;
    double sl = productTail(share, j, s) + (share * tail + shareTail * j);
    double p = s * n;
    double w = v + p;
    return w + (sumTail(v, p, w) + (productTail(s, n, p) + sl * n));
  }
}
