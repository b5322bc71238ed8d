// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Vec2;
import dev.carom.oracle.Passage;

/**
 * A piece of a circle's motion in one step, between two of its impacts or ends of the step: a
 * straight one, or with gravity a parabola.
 *
 * @param vx its velocity at the start
 * @param ax its acceleration
 * @param fastest the greatest of the speeds in it and after it
 * @param begins whether an impact began it, or it was never nearer to anything behind it than it is
 *     at its start
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
    double ax,
    double ay,
    double fastest,
    boolean begins) {

  boolean isFinite() {
    return Double.isFinite(px + py)
        && Double.isFinite(qx + qy)
        && Double.isFinite(vx + vy)
        && Double.isFinite(ax + ay);
  }

  /** Whether the circle stays where it is. */
  boolean isStanding() {
    return vx == 0 && vy == 0 && ax == 0 && ay == 0;
  }

  /** The way along its chord. */
  Passage passage() {
    return Passage.of(px, py, qx, qy);
  }

  /** The piece of it within a shorter time. */
  Flight within(double begin, double end) {
    double v = velocity(vx, ax, begin);
    double w = velocity(vy, ay, begin);
    boolean first = begins && begin == from;
    return new Flight(
        circle, radius, begin, end, x(begin), y(begin), x(end), y(end), v, w, ax, ay, fastest,
        first);
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
        ax,
        ay,
        fast,
        begins);
  }

  /** The way of this circle to another one in the same time: where they meet is at (0, 0). */
  Flight seenFrom(Flight other) {
    return new Flight(
        circle,
        radius + other.radius,
        from,
        to,
        px - other.px,
        py - other.py,
        qx - other.qx,
        qy - other.qy,
        vx - other.vx,
        vy - other.vy,
        ax - other.ax,
        ay - other.ay,
        fastest + other.fastest,
        begins || other.begins);
  }

  double x(double t) {
    return t == from ? px : t == to ? qx : place(px, vx, ax, t - from);
  }

  double y(double t) {
    return t == from ? py : t == to ? qy : place(py, vy, ay, t - from);
  }

  static double place(double p, double v, double a, double dt) {
    return Math.fma(Math.fma(a / 2, dt, v), dt, p);
  }

  private double velocity(double v, double a, double t) {
    return Math.fma(a, t - from, v);
  }
}
