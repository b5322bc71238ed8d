// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Numbers;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.exact.Ring;

/**
 * A disk with a constant acceleration against a wall, on one axis. The gap is {@code s + v t + g
 * t^2 / 2} with {@code s = p - wall - r}, all with the other sign for a wall above.
 */
public final class ParabolaWallSweep {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The relative error of the discriminant: s has 2 u, of its terms; products and sum 4 u. */
  private static final double DISCRIMINANT_BOUND = 8 * 0x1p-53;

  /** Below this, products may have lost all to underflow. */
  private static final double LEAST_SAFE = 0x1p-900;

  private ParabolaWallSweep() {}

  /** +1 if a disk is to stay above the wall with this id, -1 if below. */
  public static int inward(int id) {
    return id == WallSweep.LEFT || id == WallSweep.BOTTOM ? 1 : -1;
  }

  /**
   * The correctly rounded time of impact, {@code +infinity} for none up to the window's end T.
   *
   * @param inward +1 if the disk is to stay above the wall, -1 if below
   */
  public static double time(
      double p, double r, double v, double g, double wall, int inward, double T) {
    if (g == 0) {
      return v * inward < 0 ? WallSweep.time(p, r, v, wall, T) : NEVER;
    }
    PrecisionCounter.PARABOLAS.add();
    double time = certain(p, r, v, g, wall, inward);
    // A rounded time of T itself may be that of a later one.
    if (time < T || time == 0) {
      return time;
    }
    if (time > T || Double.isInfinite(wall)) { // at infinity there is none
      return NEVER;
    }
    GapPolynomial gap = gap(GapPolynomial.EXACT, p, r, v, g, wall, inward);
    double reach =
        FallSweep.reach(Fall.ofThread().flight(p, 0, r, v, 0, g, 0).disk(wall, 0, 0, 0, 0));
    time = new GapSearch(gap).time(GapSearch.FIRST, 0, 0, reach, T);
    return Double.isNaN(time) ? exact(p, r, v, g, wall, inward).time(T) : time;
  }

  /** The question in algebraic numbers. */
  public static ExactParabola exact(
      double p, double r, double v, double g, double wall, int inward) {
    return ExactParabola.ofGap(gap(Polynomial.EXACT, p, r, v, g, wall, inward));
  }

  static <P extends Ring<P>> P gap(
      Numbers<P> of, double p, double r, double v, double g, double wall, int inward) {
    return of.motion(inward * p, inward * wall, inward * v, 0, inward * g)
        .minus(of.difference(r, 0));
  }

  /** The time, if doubles and double-double tell. */
  private static double certain(double p, double r, double v, double g, double wall, int inward) {
    double away = inward * v;
    double lift = inward * g;
    double h = inward * (p - wall);
    double s = h - r;
    double terms = Math.abs(h) + r;
    if (!(terms <= Double.MAX_VALUE)) {
      return GapRoot.DOUBT;
    }
    if (away >= 0 && lift > 0) {
      return NEVER;
    }
    // h is the nearest double, so the sign of h - r is the true one, unless it is 0.
    double gap = s == 0 ? inward * differenceTail(p, wall, p - wall) : s;
    if (gap <= 0 && away <= 0) {
      return away < 0 || lift < 0 ? 0 : NEVER;
    }
    double square = away * away;
    double product = 2 * lift * s;
    double discriminant = square - product;
    double bound = DISCRIMINANT_BOUND * (square + 2 * Math.abs(lift) * terms);
    if (!(Math.abs(discriminant) > bound
        && bound > LEAST_SAFE
        && (away > 0 || Math.abs(s) > LEAST_SAFE))) {
      return GapRoot.DOUBT;
    }
    if (discriminant < 0) {
      double top = away / -lift; // turned back while still beyond the wall
      return s > 0 ? NEVER : top > LEAST_SAFE ? top : GapRoot.DOUBT;
    }
    double root = Math.sqrt(discriminant);
    double t = away <= 0 ? 2 * s / (root - away) : (away + root) / -lift;
    double nearest = GapRoot.DOUBT;
    for (int i = 0; i < GapRoot.CORRECTIONS && Double.isNaN(nearest); i++) {
      double residue = residue(p, r, v, g, wall, inward, t);
      double slope = inward * (v + g * t);
      double size = terms + (Math.abs(v) + Math.abs(0.5 * g) * t) * t;
      nearest = GapRoot.nearest(t, residue, slope, Math.sqrt(size));
      t -= residue / slope;
    }
    return nearest;
  }

  /** The gap at t. What cancels is kept as head and tail. */
  private static double residue(
      double p, double r, double v, double g, double wall, int inward, double t) {
    double front = inward * Offset.head(p, wall, v, 0, g, t);
    double tail = inward * Offset.tail(p, wall, v, 0, g, t);
    double gap = front - r;
    return gap + (differenceTail(front, r, gap) + tail);
  }
}
