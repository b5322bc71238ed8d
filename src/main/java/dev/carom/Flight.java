// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The straight motion of one circle between two impacts.
 *
 * @param t0 the time at which it starts
 * @param x0 the x coordinate of the centre then
 * @param y0 the y coordinate of the centre then
 * @param vx the x component of the velocity
 * @param vy the y component of the velocity
 */
record Flight(double t0, double x0, double y0, double vx, double vy) {

  /**
   * Returns the centre at a given time.
   *
   * @param t a time, as a rule at or after {@link #t0()}
   * @return the centre {@code (x0, y0) + (vx, vy) (t - t0)}; a coordinate beyond the range of
   *     doubles is the largest one
   */
  Vec2 at(double t) {
    return Vec2.within(Math.fma(vx, t - t0, x0), Math.fma(vy, t - t0, y0));
  }
}
