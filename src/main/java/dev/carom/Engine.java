// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * What moves the circles of a world: one way if they ignore each other, another if they collide.
 */
interface Engine {

  /**
   * Advances all circles to the given time, or, if the budget of work is spent first, to an earlier
   * one.
   *
   * @return the time reached
   */
  double advance(double end);

  /** Whether the budget was spent in the last {@link #advance}. */
  boolean unfinished();

  /** The flights of the circles. */
  Circles circles();

  /** What is used, in words. */
  String model();
}
