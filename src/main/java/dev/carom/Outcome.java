// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * An {@code Outcome} says what an impact did to the circles that met. Each row of an {@link
 * ImpactLog} has one.
 */
public enum Outcome {
  /** The motion along the normal was reversed and scaled by the restitution. */
  BOUNCED,

  /**
   * The motion along the normal stopped: one of the two has {@link Response#HALT}. Under gravity
   * such a circle may settle at once; the row then says {@link #SETTLED}. Off what is round it
   * leaves by the <a href="doc-files/rules.html#gravity">least speed</a>.
   */
  HALTED,

  /** Nothing changed: one of the two is a {@link Response#SENSOR}, and the circle flew on. */
  SENSED,

  /** Nothing changed: both have infinite mass, and passed through each other. */
  PASSED,

  /**
   * The circle was stuck, or in contact with a stuck one, and was resolved without bounce.
   *
   * <p>A circle is stuck after too many impacts at one place. See <a
   * href="doc-files/rules.html#stuck">stuck circles</a>.
   */
  JAMMED,

  /** The circle stopped, because doubles cannot hold the speed that it would have had. */
  STOPPED,

  /**
   * The circle stopped bouncing: its bounces had become very low, or this impact left none, by
   * restitution 0 or {@link Response#HALT}.
   *
   * <p>From this impact on it slides along a side or a wall, or rests, or, where it slid upon
   * something round that does not carry it, falls. In a heap, the contacts that hold a circle which
   * comes to rest have this outcome. This happens only in a scene with {@linkplain
   * SceneBuilder#gravity gravity}.
   */
  SETTLED
}
