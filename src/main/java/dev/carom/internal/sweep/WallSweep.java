// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.ExactTime;
import dev.carom.internal.exact.Polynomial;

/**
 * A disk that moves against a wall, on one axis: from above ({@code v < 0}) against everything at
 * or below the wall, from below ({@code v > 0}) against everything at or above it. A disk at rest
 * on that axis hits neither.
 *
 * <p>With the signed distance s of the centre in front of the wall, {@code s = p - wall} or {@code
 * wall - p}, the contact is at {@code t = (s - r) / |v|}, or at 0 if {@code s <= r} already.
 */
public final class WallSweep {

  /** The ids of the walls. On each axis, the upper wall's id is one more than the lower wall's. */
  public static final int LEFT = 0;

  public static final int RIGHT = 1;
  public static final int BOTTOM = 2;
  public static final int TOP = 3;

  private static final double LEAST_SAFE = 0x1p-500;

  private static final double MOST_SAFE = 0x1p500;

  private WallSweep() {}

  /** Whether a disk has a part beyond one of the two walls across an axis. */
  public static boolean overlaps(double p, double r, double low, double high) {
    return isNearer(p, low, r) || isNearer(high, p, r);
  }

  /** Whether {@code p - q < r}, exactly: whether a disk at p overlaps a wall below it at q. */
  public static boolean isNearer(double p, double q, double r) {
    return Dyadic.of(p).minus(Dyadic.of(q)).minus(Dyadic.of(r)).sign() < 0;
  }

  /**
   * The correctly rounded time of impact, {@code +infinity} for a disk at rest.
   *
   * @param wall the wall that the disk moves towards
   */
  public static double time(double p, double r, double v, double wall) {
    if (v == 0) {
      return Double.POSITIVE_INFINITY;
    }
    // s = h + l, exactly; h is the nearest double, so the sign of h - r is that of s - r. Signs by
    // multiplication: a branch on which of two walls is ahead would be unpredictable.
    double sign = Math.copySign(1, v);
    double ahead = wall - p;
    double h = sign * ahead;
    double l = sign * differenceTail(wall, p, ahead);
    if (h < r || (h == r && l <= 0)) {
      return 0;
    }
    double speed = Math.abs(v);
    double g = h - r;
    double gl = differenceTail(h, r, g) + l;
    double gap = g + gl;
    double t = gap / speed;
    // The quotient's remainder is exact; gl is rounded, by u^2 of h at most. Multiplying by the
    // reciprocal shortens the latency: a division would have to wait for the remainder.
    double rest = (fma(-t, speed, g) + gl) * (1 / speed);
    double error = 0x1p-50 * Math.abs(rest) + 0x1p-104 * (h / speed);
    double low = t + (rest - error);
    if (low == t + (rest + error)
        && low > LEAST_SAFE
        && low < MOST_SAFE
        && g > LEAST_SAFE
        && h < MOST_SAFE) {
      return low;
    }
    return exactTime(p, r, v, wall).nearest();
  }

  /** The same within a window: {@code +infinity} if it is later than the window's end T. */
  public static double time(double p, double r, double v, double wall, double T) {
    double t = time(p, r, v, wall);
    return t == T && t < Double.POSITIVE_INFINITY
        ? exactTime(p, r, v, wall).upTo(t, T)
        : t > T ? Double.POSITIVE_INFINITY : t;
  }

  /** The exact time of impact of a disk that moves towards a wall. */
  public static ExactTime exactTime(double p, double r, double v, double wall) {
    int inward = v < 0 ? 1 : -1;
    return ExactTime.of(ParabolaWallSweep.gap(Polynomial.EXACT, p, r, v, 0, wall, inward));
  }
}
