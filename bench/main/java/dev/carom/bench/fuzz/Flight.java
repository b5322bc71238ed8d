// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Vec2;
import dev.carom.oracle.Passage;

/**
 * A piece of a circle's motion in one step, between two of its impacts or ends of the step.
 *
 * @param fastest the greater of the speeds in it and after it
 */
record Flight(
    int circle,
    double radius,
    double from,
    double to,
    double px,
    double py,
    double qx,
    double qy,
    double vx,
    double vy,
    double fastest) {

  boolean isFinite() {
    return Double.isFinite(px + py) && Double.isFinite(qx + qy) && Double.isFinite(vx + vy);
  }

  Passage passage() {
    return Passage.of(px, py, qx, qy);
  }

  /** The piece of it within a shorter time. */
  Flight within(double begin, double end) {
    return new Flight(
        circle, radius, begin, end, x(begin), y(begin), x(end), y(end), vx, vy, fastest);
  }

  /** The same as it is seen from something that moves, whose place at the start stays. */
  Flight seenFrom(Vec2 u) {
    if (u.equals(Vec2.ZERO)) {
      return this;
    }
    double dt = to - from;
    double fast = fastest + u.length();
    return new Flight(
        circle,
        radius,
        from,
        to,
        px,
        py,
        Math.fma(-u.x(), dt, qx),
        Math.fma(-u.y(), dt, qy),
        vx - u.x(),
        vy - u.y(),
        fast);
  }

  private double x(double t) {
    return t == from ? px : t == to ? qx : Math.fma(vx, t - from, px);
  }

  private double y(double t) {
    return t == from ? py : t == to ? qy : Math.fma(vy, t - from, py);
  }
}
