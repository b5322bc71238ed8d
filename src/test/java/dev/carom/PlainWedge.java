// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * A weight on a ball that lies on two equal balls, which slide apart on level ground. With d the
 * distance of centres that touch, theta the angle of their line from the vertical, m the weight and
 * M the mass of each ball below:
 *
 * <pre>x = d sin(theta),   y = d cos(theta),   I = d^2 (2 M cos^2 + m sin^2),
 * I theta'' = m g d sin(theta) - I'/2 theta'^2</pre>
 *
 * <p>They lose touch when nothing accelerates the balls below any more.
 */
final class PlainWedge {

  private static final int STEPS = 200_000;

  private PlainWedge() {}

  /**
   * How far each ball below has come to the side, and how fast it is, after a time from rest.
   *
   * @return x and its rate
   */
  static double[] after(double d, double theta, double weight, double mass, double g, double time) {
    double h = time / STEPS;
    double th = theta;
    double om = 0;
    for (int k = 0; k < STEPS; k++) {
      double sin = Math.sin(th);
      double cos = Math.cos(th);
      double inertia = d * d * (2 * mass * cos * cos + weight * sin * sin);
      double rate = d * d * 2 * (weight - 2 * mass) * sin * cos;
      double al = (weight * g * d * sin - rate / 2 * om * om) / inertia;
      if (cos * al - sin * om * om <= 0) {
        double vx = d * cos * om;
        return new double[] {d * sin + vx * (time - k * h), vx};
      }
      th += h * (om + h / 2 * al);
      om += h * al;
    }
    return new double[] {d * Math.sin(th), d * Math.cos(th) * om};
  }
}
