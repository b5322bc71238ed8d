// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.Check;

/**
 * A {@code Circle} is a disk: one that moves, or, as an obstacle, a peg.
 *
 * @param x the x coordinate of the centre, finite
 * @param y the y coordinate of the centre, finite
 * @param radius finite and at least 0; a circle of radius 0 is a point particle
 */
public record Circle(double x, double y, double radius) implements Obstacle {

  /**
   * Checks the components.
   *
   * @param x the x coordinate of the centre
   * @param y the y coordinate of the centre
   * @param radius the radius
   * @throws IllegalArgumentException if a coordinate is NaN or infinite, or the radius NaN,
   *     infinite or negative
   */
  public Circle {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.notNegative("radius", radius);
  }

  /**
   * Makes a circle around a given point.
   *
   * @param center the centre
   * @param radius finite and at least 0
   * @throws IllegalArgumentException if the radius is NaN, infinite or negative
   */
  public Circle(Vec2 center, double radius) {
    this(Check.notNull("center", center).x(), center.y(), radius);
  }

  /**
   * Returns the centre of this circle.
   *
   * @return the point (x, y)
   */
  public Vec2 center() {
    return new Vec2(x, y);
  }
}
