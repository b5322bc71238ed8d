// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.Check;

/**
 * An {@code Endpoint} is an end of a line: a static circle of radius zero.
 *
 * @param x the x coordinate, finite
 * @param y the y coordinate, finite
 */
public record Endpoint(double x, double y) implements Obstacle {

  /**
   * Checks the components.
   *
   * @param x the x coordinate
   * @param y the y coordinate
   * @throws IllegalArgumentException if a coordinate is NaN or infinite
   */
  public Endpoint {
    Check.finite("x", x);
    Check.finite("y", y);
  }
}
