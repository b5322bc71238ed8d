// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

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

  private double x(double t) {
    return t == from ? px : t == to ? qx : Math.fma(vx, t - from, px);
  }

  private double y(double t) {
    return t == from ? py : t == to ? qy : Math.fma(vy, t - from, py);
  }
}
