// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * What happens when a circle meets something.
 *
 * <p>With a line, a peg or the bounds it is their response that counts; between two circles {@link
 * #SENSOR} if either has it, else {@link #HALT} if either has it, else {@link #BOUNCE}.
 *
 * <p><img src="doc-files/restitution.svg" alt="A circle bounces off a line: at restitution 1 as
 * steeply as it came, at 0.5 less so, at 0 it slides along" style="max-width:100%">
 */
public enum Response {
  /**
   * The motion along the normal turns round, scaled by the restitution: elastic at 1, inelastic
   * below.
   */
  BOUNCE,

  /**
   * The motion along the normal stops, for both circles of a pair; what is left of it slides along.
   * Where the other circle has an infinite mass, which nothing deflects, the circle takes over that
   * one's motion along the normal instead.
   */
  HALT,

  /**
   * The meeting is reported in the log, and nothing else happens: the circle flies on. It is
   * reported when the distance falls to the radius, and again only after it exceeded the radius; a
   * flight that starts in touch with a sensor, or inside, has met it before. (A circle that an edit
   * sets on a new flight at the very time of the report starts where rounding puts it: if that is
   * outside by an ulp, it meets the sensor again.) The bounds cannot have it: they keep circles
   * inside.
   */
  SENSOR;

  private static final Response[] ALL = values();

  /** The response with a given number, {@link #ordinal()}. */
  static Response of(int number) {
    return ALL[number];
  }
}
