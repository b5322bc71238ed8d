// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.Check;

/**
 * The answer of {@link Resolver#nearest}: the thing that is nearest to a point.
 *
 * @param kind the kind of the thing
 * @param id its id; of a wall 0 left, 1 right, 2 bottom, 3 top
 * @param distance the distance of the point from it, 0 inside of a peg or a circle
 * @param x the x coordinate of its nearest point: the point itself, inside of a peg or a circle
 * @param y the y coordinate of its nearest point
 */
public record Nearest(Kind kind, int id, double distance, double x, double y) {

  /**
   * Makes an answer.
   *
   * @param kind the kind of thing
   * @param id its id
   * @param distance its distance
   * @param x the x coordinate of its nearest point
   * @param y the y coordinate of its nearest point
   * @throws NullPointerException if the kind is null
   */
  public Nearest {
    Check.notNull("kind", kind);
  }
}
