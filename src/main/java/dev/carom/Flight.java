// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.MovingCircle;

/**
 * The motion of one circle between two impacts: a straight line, or an arc of a parabola.
 *
 * @param t0 the time at which it starts
 * @param x0 the x coordinate of the centre then
 * @param y0 the y coordinate of the centre then
 * @param vx the x component of the velocity then
 * @param vy the y component of the velocity then
 * @param gx the x component of the acceleration
 * @param gy the y component of the acceleration
 */
record Flight(double t0, double x0, double y0, double vx, double vy, double gx, double gy) {

  /**
   * Returns the centre at a given time.
   *
   * @param t a time, as a rule at or after {@link #t0()}
   * @return the centre {@code (x0, y0) + (vx, vy) (t - t0) + (gx, gy) (t - t0)^2 / 2}; a coordinate
   *     beyond the range of doubles is the largest one
   */
  Vec2 at(double t) {
    return Vec2.within(
        MovingCircle.place(x0, vx, gx, t - t0), MovingCircle.place(y0, vy, gy, t - t0));
  }

  /** Returns the velocity at a given time. */
  Vec2 velocity(double t) {
    return Vec2.within(
        MovingCircle.velocity(vx, gx, t - t0), MovingCircle.velocity(vy, gy, t - t0));
  }
}
