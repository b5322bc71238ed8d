// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.sweep.Coordinates;

/**
 * Differences and products of vectors, also where they would leave the range of doubles. There a
 * difference is divided by a power of two; for ordinary sizes that power is 1.
 */
public final class ScaledVectors {

  /** The range of a normal's size, and of a speed, within which their products are safe. */
  private static final double LEAST_SAFE = 0x1p-300;

  private static final double MOST_SAFE = 0x1p300;

  /** A normal for slow motion is scaled to 2^60: products with a tiny speed keep their bits. */
  private static final int SLOW = 60;

  private ScaledVectors() {}

  /** Whether products of numbers of this size are within the range of doubles. */
  static boolean isSafe(double size) {
    return size > LEAST_SAFE && size < MOST_SAFE;
  }

  /**
   * The exponent of the power of two by which a normal p - q is divided, so that its products with
   * velocities stay within the range of doubles; 0 for ordinary sizes.
   */
  static int exponent(double px, double py, double qx, double qy, double speed) {
    double x = px - qx;
    double y = py - qy;
    double size = Math.max(Math.abs(x), Math.abs(y));
    return isSafe(size) && isSafe(speed)
        ? 0
        : Math.getExponent(size) + (speed < 1 ? -SLOW : 3); // n below 1/4: |v.n| < 2 |v| / 4
  }

  /** (p - q) / 2^exponent; a p or q beyond the range of doubles counts as the largest double. */
  static double difference(double p, double q, int exponent) {
    if (exponent == 0) {
      return p - q;
    }
    double a = Coordinates.within(p);
    double b = Coordinates.within(q);
    double d = a - b;
    return Math.abs(d) <= Double.MAX_VALUE
        ? Math.scalb(d, -exponent)
        : Math.scalb(a, -exponent) - Math.scalb(b, -exponent);
  }

  /** a.b to within two ulps, even under cancellation (W. Kahan's difference of products). */
  public static double dot(double ax, double ay, double bx, double by) {
    double p = ay * by;
    return fma(ax, bx, p) + fma(ay, by, -p);
  }
}
