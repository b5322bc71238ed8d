// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** What an impact did to the circles that met: one for each row of an {@link ImpactLog}. */
public enum Outcome {
  /** The motion along the normal turned round, scaled by the restitution. */
  BOUNCED,

  /** The motion along the normal stopped: one of the two has {@link Response#HALT}. */
  HALTED,

  /** Nothing: one of the two is a {@link Response#SENSOR}, and the circle flew on. */
  SENSED,

  /** Nothing: both have infinite mass, and passed through each other. */
  PASSED,

  /**
   * A circle made too many impacts at one place and lost what led to more of them, or all things
   * that it touches there acted at once; see {@link World} on circles that are stuck.
   */
  JAMMED,

  /** The circle stopped, since doubles cannot tell the speed that it would have had. */
  STOPPED
}
