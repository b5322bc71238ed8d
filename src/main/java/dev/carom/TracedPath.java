// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The way of one circle among things that stand still.
 *
 * @param flights {@link #FLIGHT} numbers of each flight, one more than there are impacts
 * @param impacts in the order of time
 * @param duration the time covered
 * @param complete whether that is all that was asked for
 */
record TracedPath(DoubleList flights, ImpactRows impacts, double duration, boolean complete) {

  /** Doubles of one flight: t, x, y, vx, vy. */
  static final int FLIGHT = 5;
}
