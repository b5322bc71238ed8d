// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.util.DoubleList;

/**
 * The path of one circle among obstacles.
 *
 * @param flights {@link #FLIGHT} numbers for each flight, one flight more than there are impacts;
 *     further ones where the circle slides off a line
 * @param impacts in the order of time
 * @param duration the time covered
 * @param complete false if the path would go on, but its budget of work is spent
 */
public record TracedPath(
    DoubleList flights, ImpactRows impacts, double duration, boolean complete) {

  /** Doubles of one flight: t, x, y, vx, vy, gx, gy. */
  public static final int FLIGHT = 7;
}
