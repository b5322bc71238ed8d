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

  double pivotX;
  double pivotY;
  double q1;
  double q2;

  /** The square of c at a time, and of its length: set by {@link #at}. */
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
    double x = fma(q1, t, 1);
    double y = q2 * t;
    re = x * x - y * y;
    im = 2 * x * y;
    n = x * x + y * y;
    return this;
  }

  /** The angular velocity at a time. */
  double rate(double t) {
    return 2 * q2 / at(t).n;
  }

  /** The place at the time looked at of what was at (x, y) at the start. */
  double x(double x, double y) {
    return pivotX + ((x - pivotX) * re - (y - pivotY) * im) / n;
  }

  double y(double x, double y) {
    return pivotY + ((x - pivotX) * im + (y - pivotY) * re) / n;
  }

  /** The component of a vector at the time looked at, as the obstacle sees it. */
  double backX(double x, double y) {
    return (x * re + y * im) / n;
  }

  double backY(double x, double y) {
    return (y * re - x * im) / n;
  }
}
