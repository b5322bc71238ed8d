// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.Check;

/**
 * The largest coordinate and the least radius that a world ever had. A radius must be at least 2^10
 * ulps of the largest coordinate: below that, rounding of positions could carry a circle through a
 * line. A radius of 0 is exempt, but allowed only where there are no lines.
 */
public final class SizeLimits {

  private static final double LEAST_RADIUS_ULPS = 0x1p10;

  /** The text that says which radius is expected where there are lines. */
  public static final String NO_POINT = "more than 0, as there are lines";

  private double largest;
  private double least = Double.POSITIVE_INFINITY;

  public SizeLimits() {}

  public SizeLimits(double largest, double least) {
    this.largest = largest;
    this.least = least;
  }

  public double largest() {
    return largest;
  }

  public double least() {
    return least;
  }

  public SizeLimits copy() {
    return new SizeLimits(largest, least);
  }

  public void set(SizeLimits other) {
    largest = other.largest;
    least = other.least;
  }

  /** The least radius that is allowed together with a coordinate of this size. */
  public static double leastRadius(double coordinate) {
    return LEAST_RADIUS_ULPS * Math.ulp(coordinate);
  }

  /** Refuses a coordinate that is not finite, or too large for the least radius. */
  public void checkCoordinate(String name, double value) {
    Check.finite(name, value);
    if (leastRadius(value) > least) {
      throw Check.refused(
          name, value, "a smaller one: 2^10 ulps of it must not exceed the least radius, " + least);
    }
  }

  /**
   * Refuses the radius of a circle at (x, y) if it is negative, or too small for the largest
   * coordinate. A radius of 0 is refused only where there are lines.
   */
  public void checkRadius(double radius, double x, double y, boolean lines) {
    Check.notNegative("radius", radius);
    if (radius == 0 && lines) {
      throw Check.refused("radius", radius, NO_POINT);
    }
    double size = Math.max(largest, Math.max(Math.abs(x), Math.abs(y)));
    if (radius != 0 && radius < leastRadius(size)) {
      throw Check.refused(
          "radius",
          radius,
          "at least %s, 2^10 ulps of the largest coordinate, %s"
              .formatted(leastRadius(size), size));
    }
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SizeLimits that && largest == that.largest && least == that.least;
  }

  @Override
  public int hashCode() {
    return Double.hashCode(largest) + Double.hashCode(least);
  }

  public void keepPlace(double x, double y) {
    largest = Math.max(largest, Math.max(Math.abs(x), Math.abs(y)));
  }

  public void keepRadius(double radius) {
    least = radius == 0 ? least : Math.min(least, radius);
  }
}
