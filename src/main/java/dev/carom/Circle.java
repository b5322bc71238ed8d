// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.query.OutlineSeparation;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.sweep.Separation;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.internal.util.Check;

/**
 * A {@code Circle} is a disk: the place of a circle that moves, a peg, or, of radius 0, a point.
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

  /**
   * Tells whether this disk overlaps an obstacle: whether its distance is less than the radius, or
   * than the sum of both radii, exactly. Touching is not overlapping. It overlaps bounds if a part
   * of it is beyond one of their walls, and a solid outline, too, if it is inside.
   *
   * @param other the obstacle
   * @return true if they overlap
   */
  public boolean overlaps(Obstacle other) {
    if (Check.notNull("other", other) instanceof Line l) {
      return SegmentSweep.overlaps(x, y, radius, l.ax(), l.ay(), l.bx(), l.by());
    }
    if (other instanceof Outline outline) {
      return outline.values().overlaps(x, y, radius);
    }
    if (other instanceof Bounds b) {
      return WallSweep.overlaps(x, radius, b.xmin(), b.xmax())
          || WallSweep.overlaps(y, radius, b.ymin(), b.ymax());
    }
    Circle c = (Circle) other;
    return DiskSweep.overlaps(x, y, radius, c.x, c.y, c.radius);
  }

  /**
   * Returns the least translation that moves this circle out of an obstacle, so that they touch.
   *
   * <p>It points away from the nearest point of the obstacle, and from the walls of bounds inwards;
   * of an outline it leads to the nearest place where no side is overlapped, of a solid one
   * outside. If the centre is exactly on a line, it points along the line's left normal. If two
   * circles are concentric, or the line is a point at the centre, it points along +x.
   *
   * <p>If x and y are added to the circle's centre in doubles, the two do not {@linkplain #overlaps
   * overlap}. To make sure of that it may exceed the least translation, by at most 8 ulps of the
   * sum of the largest coordinate and the radii.
   *
   * @param other the obstacle, which stays
   * @return the translation, {@link Vec2#ZERO} if they do not overlap
   * @throws IllegalArgumentException if they overlap, and the largest coordinate and the radii
   *     together exceed 2^1023 (of an outline 2^500), or this circle does not fit between the walls
   *     of bounds
   */
  public Vec2 separation(Obstacle other) {
    Separation out;
    if (Check.notNull("other", other) instanceof Line l) {
      out = Separation.ofLine(x, y, radius, l.ax(), l.ay(), l.bx(), l.by());
    } else if (other instanceof Outline outline) {
      out = OutlineSeparation.of(x, y, radius, outline.values());
    } else if (other instanceof Bounds b) {
      out = Separation.ofWalls(x, y, radius, b.xmin(), b.ymin(), b.xmax(), b.ymax());
    } else {
      Circle c = (Circle) other;
      out = Separation.ofDisk(x, y, radius, c.x, c.y, c.radius);
    }
    return new Vec2(out.x(), out.y());
  }
}
