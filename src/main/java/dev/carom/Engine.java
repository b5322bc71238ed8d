// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * What moves the circles of a world: one way if they ignore each other, another if they collide.
 * Between steps a world may edit them; what it asks for is checked.
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

  /** What stands still. */
  Surroundings surroundings();

  /** What is used, in words. */
  String model();

  /**
   * Begins a new flight of a circle, whose id may be the next one, with what a mover holds.
   *
   * @param m a mover at the start of a flight, now
   */
  void fly(Mover m);

  /** Takes a circle out. */
  void remove(int i);

  /** Records new flights, or none for null; those of now first. */
  void record(Timeline timeline);

  /** The flights of all circles, those of removed ones included. */
  FlightStates save();

  /** Takes over other flights, of the circles that are in the roster by now. */
  void restore(FlightStates flights, double now);

  /** Forgets a line or a peg that is to be elsewhere, otherwise there, or gone. */
  void forget(int code);

  /**
   * Takes notice that a line or a peg is new, elsewhere, or otherwise there than before: circles
   * whose flight meets it begin a new one now.
   */
  void appeared(int code, double now);
}
