// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.UnitVector;

/** Signs, bounds of lengths, and unit vectors, each component within 1e-15 of the true one. */
public final class UnitVectors {

  /** Range of components whose squares neither underflow nor overflow. */
  private static final double LEAST_SAFE = 0x1p-400;

  private static final double MOST_SAFE = 0x1p400;

  private UnitVectors() {}

  /** +1 or -1 by the sign bit, which 0 has, too. Branch-free, as the sign is unpredictable. */
  public static int sign(double value) {
    return (int) (Double.doubleToRawLongBits(value) >> 63) | 1;
  }

  /** A length of at least |(x, y)|, and at most 9 % more, from |x| and |y|. */
  public static double lengthBound(double absX, double absY) {
    // |v| <= large + (sqrt(2) - 1) small: a chord above a convex curve.
    return 0.5857 * Math.max(absX, absY) + 0.4143 * (absX + absY);
  }

  /** (a - b) / |a - b| for two different points. */
  public static UnitVector unit(double ax, double ay, double bx, double by) {
    return unit(new UnitVector(), ax, ay, bx, by);
  }

  /** The same, put into a given vector. */
  static UnitVector unit(UnitVector out, double ax, double ay, double bx, double by) {
    double x = ax - bx;
    double y = ay - by;
    double size = Math.max(Math.abs(x), Math.abs(y));
    if (!(size > LEAST_SAFE && size < MOST_SAFE)) {
      return out.set(UnitVector.of(Dyadic.difference(ax, bx), Dyadic.difference(ay, by)));
    }
    double length = Math.sqrt(x * x + y * y);
    return out.set(x / length + 0.0, y / length + 0.0);
  }

  /** The unit normal of the line from a to b: the left one for side +1, the right one for -1. */
  public static UnitVector normal(int side, double ax, double ay, double bx, double by) {
    return normal(new UnitVector(), side, ax, ay, bx, by);
  }

  /** The same, put into a given vector. */
  static UnitVector normal(UnitVector out, int side, double ax, double ay, double bx, double by) {
    UnitVector w = unit(out, bx, by, ax, ay);
    // + 0 turns -0 into 0.
    return w.set(-side * w.y() + 0.0, side * w.x() + 0.0);
  }
}
