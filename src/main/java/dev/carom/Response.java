// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * A {@code Response} says what happens when a circle meets something.
 *
 * <p>At a line, a peg or a wall the response of that obstacle counts. Between two circles it is
 * {@link #SENSOR} if either has it, else {@link #HALT} if either has it, else {@link #BOUNCE}.
 *
 * <p><img src="doc-files/restitution.svg" alt="A circle bounces off a line: at restitution 1 as
 * steeply as it came, at 0.5 less so, at 0 it slides along" style="max-width:100%">
 */
public enum Response {
  /**
   * The motion along the normal is reversed and scaled by the restitution: elastic at 1, inelastic
   * below.
   */
  BOUNCE,

  /**
   * The motion along the normal stops, for both circles of a pair. The motion across it stays: the
   * circle slides along.
   *
   * <p>At a line or a peg that moves, and at a circle of infinite mass, a circle takes over its
   * motion along the normal. Two circles of finite mass both lose theirs: momentum is not kept.
   */
  HALT,

  /**
   * The contact is reported in the log, and the circle flies on unchanged.
   *
   * <p>A contact is reported when a circle comes to touch the sensor, and again only after it was
   * clear of it. A flight that starts touching a sensor, or inside of it, counts as reported
   * already: the circle must leave before the next report. Leaving is not reported; {@link
   * World#overlapping(Kind, Circle) World.overlapping} tells what overlaps a disk now. Circles
   * sense each other only where circles collide. The bounds cannot be a sensor, because they keep
   * circles inside.
   *
   * <p>One case is left to rounding: an edit at the very time of a report puts the circle where
   * rounding puts it. If that is outside by an ulp, the sensor is reported once more.
   */
  SENSOR;

  private static final Response[] ALL = values();

  /** Returns the response with a given number, {@link #ordinal()}. */
  static Response of(int number) {
    return ALL[number];
  }
}
