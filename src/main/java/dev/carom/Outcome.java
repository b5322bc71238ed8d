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
   * such a circle may settle at once; the row then says {@link #SETTLED}.
   */
  HALTED,

  /** Nothing changed: one of the two is a {@link Response#SENSOR}, and the circle flew on. */
  SENSED,

  /** Nothing changed: both have infinite mass, and passed through each other. */
  PASSED,

  /**
   * The circle was stuck, or in contact with a stuck one, and was resolved without bounce. Or
   * something that moves squeezed it, and passes over it.
   *
   * <p>Without gravity a circle is stuck after too many impacts at one place. See <a
   * href="doc-files/rules.html#stuck">stuck circles</a>. Under <a
   * href="doc-files/rules.html#gravity">gravity</a> it falls again as soon as nothing overlaps it.
   */
  JAMMED,

  /** The circle stopped, because doubles cannot hold the speed that it would have had. */
  STOPPED,

  /**
   * The first slow impact of a circle after a fast one, under {@linkplain SceneBuilder#gravity
   * gravity}: it makes low bounces from now on, slides, or is in contact.
   *
   * <p>Further slow impacts have no row, nor have rest and the motion of circles in contact. See <a
   * href="doc-files/rules.html#gravity">Gravity</a>.
   */
  SETTLED
}
