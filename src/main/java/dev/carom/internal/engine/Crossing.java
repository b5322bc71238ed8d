// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

/** When a circle next leaves a cell, and which way; {@link NeighborGrid#nextCrossing} fills it. */
public final class Crossing {

  /** How long after the start of the flight; {@code +infinity} for never. */
  double after;

  /** The nearest double to the time of that. */
  public double time;

  /** The level of the cell, and the edge that is crossed; see {@link NeighborGrid#cross}. */
  public int way;
}
