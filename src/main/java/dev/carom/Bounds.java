// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.Check;

/**
 * {@code Bounds} are an axis-parallel rectangle that keeps circles inside. The four walls are
 * half-planes: the left one is everything with {@code x <= xmin}, also above and below the
 * rectangle. A side at infinity is open: there is no wall.
 *
 * <p>In {@link World#overlapping(Kind, Bounds)} they are the box that is asked about.
 *
 * @param xmin the x coordinate of the left wall, or -infinity
 * @param ymin the y coordinate of the bottom wall, or -infinity
 * @param xmax the x coordinate of the right wall, or +infinity; greater than xmin
 * @param ymax the y coordinate of the top wall, or +infinity; greater than ymin
 */
public record Bounds(double xmin, double ymin, double xmax, double ymax) implements Obstacle {

  /**
   * Checks the components.
   *
   * @param xmin the x coordinate of the left wall
   * @param ymin the y coordinate of the bottom wall
   * @param xmax the x coordinate of the right wall
   * @param ymax the y coordinate of the top wall
   * @throws IllegalArgumentException if a coordinate is NaN, or a maximum is not greater than its
   *     minimum
   */
  public Bounds {
    Check.bounds(xmin, ymin, xmax, ymax);
  }
}
