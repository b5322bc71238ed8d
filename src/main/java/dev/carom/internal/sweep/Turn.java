// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

/**
 * The rotation of an obstacle about a pivot, without a sine. A vector w of it, seen from the pivot,
 * is {@code w c^2 / |c|^2} at the time t, with the complex number {@code c = 1 + (q1 + i q2) t}. So
 * the rate is {@code 2 q2 / |c|^2}: of a turn by an angle it is even but for {@code tan^2(angle /
 * 4)}.
 */
public final class Turn {

  /** The largest angle of a turn, in radians. */
  public static final double QUARTER = Math.PI / 2;

  double pivotX;
  double pivotY;
  double q1;
  double q2;

  /** c at a time, its square, and the square of its length: set by {@link #at}. */
  double x;

  double y;
  double re;
  double im;
  double n;

  /** The real part of q for a turn by an angle, at most a quarter turn, in a time. */
  public static double q1(double angle, double time) {
    double sine = StrictMath.sin(0.25 * angle);
    return -2 * sine * sine / time;
  }

  /** The imaginary part of q. */
  public static double q2(double angle, double time) {
    return StrictMath.sin(0.5 * angle) / time;
  }

  void set(double itsPivotX, double itsPivotY, double itsQ1, double itsQ2) {
    pivotX = itsPivotX;
    pivotY = itsPivotY;
    q1 = itsQ1;
    q2 = itsQ2;
  }

  /** Looks at a time. */
  Turn at(double t) {
    x = fma(q1, t, 1);
    y = q2 * t;
    re = x * x - y * y;
    im = 2 * x * y;
    n = x * x + y * y;
    return this;
  }

  /** The angular velocity at a time. */
  double rate(double t) {
    return 2 * q2 / at(t).n;
  }

  /**
   * The place at the time looked at of what was at (px, py) at the start: there to the bit at time
   * 0. It is moved by {@code (c^2 / n - 1) w}, which is {@code 2 y / n} times the vector {@code i c
   * w}.
   */
  double placeX(double px, double py) {
    return px - 2 * y / n * (y * (px - pivotX) + x * (py - pivotY));
  }

  double placeY(double px, double py) {
    return py + 2 * y / n * (x * (px - pivotX) - y * (py - pivotY));
  }

  /** The component of a vector at the time looked at, as the obstacle sees it. */
  double backX(double vx, double vy) {
    return (vx * re + vy * im) / n;
  }

  double backY(double vx, double vy) {
    return (vy * re - vx * im) / n;
  }

  /**
   * The least n in an interval, or less: n is convex, so it is above its tangents at both ends,
   * which meet in the middle.
   */
  double least(double low, double high) {
    double last = at(high).n;
    double first = at(low).n;
    return Math.min(Math.min(first, last), first + (q1 * x + q2 * y) * (high - low));
  }

  /**
   * The factor of {@link dev.carom.internal.exact.GapPolynomial#signAtTurn(double, double,
   * dev.carom.internal.exact.GapPolynomial, double)} for a gap times n^k: the true one changes by
   * the rate over {@code n^(k + 1)}.
   */
  double change(double low, double high, int k) {
    double least = least(low, high);
    double most = Math.max(at(low).n, at(high).n);
    double growth = most / least;
    return least > 0 ? (k == 1 ? growth : growth * growth) / least : Double.POSITIVE_INFINITY;
  }
}
