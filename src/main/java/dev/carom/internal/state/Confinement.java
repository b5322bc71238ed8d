// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * Keeps circles within the bounds where the clock is too coarse. A circle that flies far between
 * two adjacent doubles of time would otherwise appear beyond the wall that it hits between them.
 *
 * <p>A position that is beyond a wall by more than rounding, in a flight that began inside that
 * wall, is replaced by the position of contact. All other positions stay as they are, to the bit.
 */
final class Confinement {

  /** The rounding error of a position, in ulps of the largest coordinate. */
  private static final int ULPS = 4;

  private Confinement() {}

  /**
   * The confined x coordinate of a centre.
   *
   * @param walls as {@link ObstacleTable#walls}, may be null
   * @param start x at the start of the flight
   * @param x the computed coordinate
   * @param r the radius
   */
  static double x(double[] walls, double start, double x, double r) {
    return walls == null ? x : between(walls[Codes.LEFT], walls[Codes.RIGHT], start, x, r);
  }

  /** The confined y coordinate of a centre. */
  static double y(double[] walls, double start, double y, double r) {
    return walls == null ? y : between(walls[Codes.BOTTOM], walls[Codes.TOP], start, y, r);
  }

  /** Whether a circle is inside all walls, as most are: then its coordinates stay as they are. */
  static boolean isInside(double[] walls, double x, double y, double r) {
    return walls == null
        || (isBetween(walls[Codes.LEFT], walls[Codes.RIGHT], x, r)
            && isBetween(walls[Codes.BOTTOM], walls[Codes.TOP], y, r));
  }

  private static boolean isBetween(double low, double high, double p, double r) {
    return p - r >= low && p + r <= high;
  }

  /** The size of a coordinate; 0 of an open side. */
  private static double size(double wall) {
    return Double.isInfinite(wall) ? 0 : Math.abs(wall);
  }

  private static double between(double low, double high, double start, double p, double r) {
    if (isBetween(low, high, p, r)) {
      return p;
    }
    double rounding = ULPS * Math.ulp(Math.max(Math.max(size(low), size(high)), r));
    if (p + r > high + rounding && start + r <= high + rounding) {
      return high - r;
    }
    if (p - r < low - rounding && start - r >= low - rounding) {
      return low + r;
    }
    return p;
  }
}
