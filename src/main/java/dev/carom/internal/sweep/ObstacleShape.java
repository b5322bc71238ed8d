// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.util.Check;
import java.util.List;

/**
 * The geometry of one kind of obstacle. Each obstacle is a row of doubles in an array: the
 * coordinates of its spine, a segment or a point; a radius, if the kind has one; and the
 * restitution. It is solid up to its radius from the spine.
 *
 * <p>The methods take an array and the place where the row begins. A disk is given by its centre
 * (px, py), radius r and velocity (vx, vy). An obstacle may move, too: with the velocity (ux, uy)
 * from the place that its row gives.
 */
public abstract class ObstacleShape {

  /** The columns of the start of the spine. */
  public static final int X = 0;

  public static final int Y = 1;

  /** The name of the kind in messages and scene files. */
  public final String name;

  /** The names of the numbers before the restitution: coordinates, then, if any, the radius. */
  public final List<String> numbers;

  /** The number of coordinates among them. */
  public final int coordinates;

  /** From a coordinate of the start of the spine to that of its end; 0 if it is a point. */
  public final int toEnd;

  /** The column of the restitution. */
  public final int restitution;

  /** The number of doubles in a row. */
  public final int row;

  /** Whether the kind has a radius. */
  public final boolean hasRadius;

  ObstacleShape(String name, int coordinates, String... numbers) {
    this.name = name;
    this.coordinates = coordinates;
    this.numbers = List.of(numbers);
    toEnd = coordinates - 2;
    restitution = numbers.length;
    row = numbers.length + 1;
    hasRadius = coordinates < numbers.length;
  }

  /** The radius of an obstacle around its spine; 0 if the kind has none. */
  public final double radius(double[] rows, int k) {
    return hasRadius ? rows[k + coordinates] : 0;
  }

  /** Refuses numbers that are not finite, or a radius below 0. */
  public final void check(double... row) {
    for (int i = 0; i < coordinates; i++) {
      Check.finite(numbers.get(i), row[i]);
    }
    checkRadius(row);
  }

  /** Refuses a radius below 0. */
  public final void checkRadius(double... row) {
    for (int i = coordinates; i < numbers.size(); i++) {
      Check.notNegative(numbers.get(i), row[i]);
    }
  }

  // Distance and overlap.

  /** The distance of a point from the spine. */
  public abstract double distanceFromSpine(double[] rows, int k, double x, double y);

  /** The distance of a point; 0 inside. */
  public final double distance(double[] rows, int k, double x, double y) {
    return Math.max(0, distanceFromSpine(rows, k, x, y) - radius(rows, k));
  }

  /** Whether a disk at rest overlaps an obstacle, exactly; to touch is not to overlap. */
  public abstract boolean overlaps(double[] rows, int k, double x, double y, double r);

  /**
   * Whether a box overlaps an obstacle, exactly.
   *
   * @param box the coordinates of its sides, by the ids of walls
   */
  public abstract boolean overlaps(double[] rows, int k, double[] box);
}
