// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Numbers;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.exact.Ring;

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

  /**
   * Whether {@code p - q < r}, exactly: whether a disk at p overlaps a wall below it at q. At
   * infinity there is none.
   */
  public static boolean isNearer(double p, double q, double r) {
    return Double.isFinite(p)
        && Double.isFinite(q)
        && Dyadic.of(p).minus(Dyadic.of(q)).minus(Dyadic.of(r)).sign() < 0;
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
    return settled(p, r, v, wall, Double.POSITIVE_INFINITY);
  }

  /** The same within a window: {@code +infinity} if it is later than the window's end T. */
  public static double time(double p, double r, double v, double wall, double T) {
    double t = time(p, r, v, wall);
    return t == T && t < Double.POSITIVE_INFINITY
        ? settled(p, r, v, wall, T)
        : t > T ? Double.POSITIVE_INFINITY : t;
  }

  private static double settled(double p, double r, double v, double wall, double T) {
    if (Double.isInfinite(wall)) {
      return Double.POSITIVE_INFINITY; // no wall
    }
    double time = FallSweep.settled(gap(GapPolynomial.EXACT, p, r, v, wall), T);
    return Double.isNaN(time) ? FallSweep.settled(exactTime(p, r, v, wall), T) : time;
  }

  /** The exact time of impact of a disk that moves towards a wall. */
  public static RealRoot exactTime(double p, double r, double v, double wall) {
    return RealRoot.ofStraight(gap(Polynomial.EXACT, p, r, v, wall));
  }

  private static <P extends Ring<P>> P gap(
      Numbers<P> of, double p, double r, double v, double wall) {
    return ParabolaWallSweep.gap(of, p, r, v, 0, wall, v < 0 ? 1 : -1);
  }
}
