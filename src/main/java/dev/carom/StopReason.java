// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** Why {@link World#advanceToImpact World.advanceToImpact} stopped. */
public enum StopReason {
  /** There was an impact; it is in the log, with all others up to the time of the world. */
  IMPACT,
  /** The given time was reached without any impact. */
  TIME,
  /**
   * The budget of work was spent before; the next call goes on. The log may hold impacts up to the
   * time of the world.
   */
  BUDGET
}
