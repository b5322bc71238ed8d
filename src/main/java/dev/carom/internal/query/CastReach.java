// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.search.BoxTree;
import dev.carom.internal.state.MovingCircle;

/**
 * When a cast can first touch circles of which only ranges are known: of their places now, their
 * velocities and their accelerations.
 *
 * <p>They are touched at a time t only if on each axis the two ranges of places overlap at that
 * time. The gap between two sides, g now, is closed while {@code g <= u t + a t^2 / 2}, where u is
 * the fastest closing speed and a the largest closing acceleration.
 */
final class CastReach {

  /** In units of the terms of a position: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** Squares above this do not suffer from underflow. */
  private static final double TINY = 0x1p-900;

  private static final double NEVER = Double.POSITIVE_INFINITY;

  // The boxes of the nodes.
  private double[] places;
  private double[] velocities;
  private double[] accelerations;

  // The sides of the cast now, its velocity and its acceleration.
  private double left;
  private double bottom;
  private double right;
  private double top;
  private double vx;
  private double vy;
  private double gx;
  private double gy;

  /** The time from which, and the time until which, each gap looked at is closed. */
  private double from;

  private double until;

  /** Begins a cast among the circles of an index. */
  void start(MovingCircle m, CircleIndex index) {
    places = index.tree().nodes();
    velocities = index.velocities();
    accelerations = index.accelerations();
    double terms = Math.abs(m.x) + Math.abs(m.y) + index.tree().extent;
    // This takes 2^-40 of each gap, so also 2^-41 of each time; all rounding is far less.
    double reach = m.radius + ROUNDING * (m.radius + terms) + Double.MIN_NORMAL;
    left = m.x - reach;
    bottom = m.y - reach;
    right = m.x + reach;
    top = m.y + reach;
    vx = m.vx;
    vy = m.vy;
    gx = m.gx;
    gy = m.gy;
  }

  /** A time before which the cast touches no circle of a node; infinite if it never does. */
  double entry(int node) {
    int k = node * BoxTree.BOX;
    double[] p = places;
    double[] v = velocities;
    from = 0;
    until = Double.MAX_VALUE;
    close(p[k + BoxTree.LEFT] - right, vx - v[k + BoxTree.LEFT], gx - a(k + BoxTree.LEFT));
    close(left - p[k + BoxTree.RIGHT], v[k + BoxTree.RIGHT] - vx, a(k + BoxTree.RIGHT) - gx);
    close(p[k + BoxTree.BOTTOM] - top, vy - v[k + BoxTree.BOTTOM], gy - a(k + BoxTree.BOTTOM));
    close(bottom - p[k + BoxTree.TOP], v[k + BoxTree.TOP] - vy, a(k + BoxTree.TOP) - gy);
    return from > until ? NEVER : from;
  }

  /** A side of the box of accelerations. */
  private double a(int k) {
    return accelerations == null ? 0 : accelerations[k];
  }

  /** The same for one circle. */
  double entry(CastTarget c) {
    from = 0;
    until = Double.MAX_VALUE;
    close(c.x - c.r - right, vx - c.vx, gx - c.gx);
    close(left - (c.x + c.r), c.vx - vx, c.gx - gx);
    close(c.y - c.r - top, vy - c.vy, gy - c.gy);
    close(bottom - (c.y + c.r), c.vy - vy, c.gy - gy);
    return from > until ? NEVER : from;
  }

  /**
   * Takes one gap into account that closes at a constant speed. If the speed is negative, the gap
   * is closed until the quotient, not from then on. Maxima need no branch, which would be
   * unpredictable; NaN, which proves nothing, is passed on.
   */
  private void close(double gap, double u) {
    if (u >= 0) {
      from = Math.max(from, gap / Math.abs(u)); // for -0
    } else {
      until = Math.min(until, gap / u);
    }
  }

  /**
   * Takes one gap into account: with {@code root^2 = u^2 + 2 a gap} it is closed from or until
   * {@code 2 gap / (u +- root)}. Where that overflows, underflows or cancels, it proves nothing.
   */
  private void close(double gap, double u, double a) {
    if (a == 0) {
      close(gap, u);
      return;
    }
    double square = u * u + 2 * a * gap;
    if (gap > 0 && u <= 0 && a <= 0) {
      until = -1; // never
    } else if (!(Math.abs(square) > TINY && Math.abs(square) <= Double.MAX_VALUE)) {
      return;
    } else if (gap > 0 && square < 0) {
      until = -1; // it stops closing before
    } else if (gap > 0) {
      double root = Math.sqrt(square);
      double t = u < 0 ? (root - u) / a : 2 * gap / (u + root);
      from = Math.max(from, t);
    } else if (u < 0 && a <= 0) {
      until = Math.min(until, 2 * gap / (u - Math.sqrt(square)));
    }
  }
}
