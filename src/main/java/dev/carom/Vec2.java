// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.util.Check;

/**
 * A {@code Vec2} is a point or a vector of the plane: a position, a velocity or a direction.
 *
 * <p>Units are the caller's: lengths in one unit of length, velocities in that unit per unit of
 * time. The x axis points right. Whether y points up or down is the caller's choice: see the
 * conventions of {@linkplain dev.carom this package}.
 *
 * @param x the first component, finite
 * @param y the second component, finite
 */
public record Vec2(double x, double y) {

  /** The origin, which is also the velocity of a circle at rest. */
  public static final Vec2 ZERO = new Vec2(0, 0);

  /**
   * Checks the components.
   *
   * @param x the first component
   * @param y the second component
   * @throws IllegalArgumentException if a component is NaN or infinite
   */
  public Vec2 {
    Check.finite("x", x);
    Check.finite("y", y);
  }

  /**
   * Returns the point (x, y), with coordinates {@linkplain Coordinates#within within} the doubles.
   */
  static Vec2 within(double x, double y) {
    return new Vec2(Coordinates.within(x), Coordinates.within(y));
  }

  /**
   * Returns the length of this vector.
   *
   * @return {@code sqrt(x^2 + y^2)}, without intermediate overflow; infinite if it exceeds the
   *     range of a double
   */
  public double length() {
    return StrictMath.hypot(x, y);
  }
}
