// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** A {@code StopReason} tells why {@link World#advanceToImpact World.advanceToImpact} stopped. */
public enum StopReason {
  /** There was an impact. The log holds it, with all others up to the time of the world. */
  IMPACT,
  /** The given time was reached without any impact. */
  TIME,
  /**
   * The budget of work was spent first, and the next call goes on. The log may hold impacts up to
   * the time of the world.
   */
  BUDGET
}
