// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.response.Impulse;
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

  /**
   * Returns this velocity after a bounce off a surface, if it points against the surface's normal.
   *
   * <p>The result is {@code v - (1 + e) (v.n) / (n.n) n}. Exact arithmetic decides whether the
   * velocity points against the normal.
   *
   * @param normal the normal, of any length but zero, pointing away from the obstacle
   * @param restitution finite and at least 0: 1 is elastic, 0 keeps no motion along the normal
   * @return the velocity after; this one if it does not point against the normal
   * @throws IllegalArgumentException if the normal is zero, the restitution NaN, infinite or
   *     negative, or the velocity after beyond the range of doubles
   */
  public Vec2 reflect(Vec2 normal, double restitution) {
    Check.notNull("normal", normal);
    Check.notNegative("restitution", restitution);
    if (normal.x == 0 && normal.y == 0) {
      throw Check.refused("normal", normal, "a vector other than zero");
    }
    if (Predicates.dot(x, y, 0, 0, normal.x, normal.y, 0, 0) >= 0) {
      return this;
    }
    int size = Math.getExponent(Math.max(Math.abs(normal.x), Math.abs(normal.y)));
    double nx = Math.scalb(normal.x, -size);
    double ny = Math.scalb(normal.y, -size);
    Impulse impulse = new Impulse();
    impulse.of(1 + restitution, x, y, nx, ny);
    double vx = impulse.less(x, nx);
    double vy = impulse.less(y, ny);
    if (!(Math.abs(vx) <= Double.MAX_VALUE && Math.abs(vy) <= Double.MAX_VALUE)) {
      throw Check.refused("restitution", restitution, "one with which " + this + " stays finite");
    }
    return new Vec2(vx, vy);
  }
}
