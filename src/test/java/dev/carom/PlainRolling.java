// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * A ball of restitution 0 rolls off a round thing without friction: its centre follows a circle of
 * radius rho until nothing presses it on, and then a parabola. With theta from the vertical
 *
 * <pre>theta'' = g / rho sin theta,   and it leaves where   rho theta'^2 = g cos theta.</pre>
 */
final class PlainRolling {

  private static final int STEPS = 20_000;

  private PlainRolling() {}

  /** Where a ball is, and how far it has come. */
  record Place(double x, double y, double path) {}

  /**
   * Where the centre is at a time.
   *
   * @param rho the distance of the centres
   * @param theta the angle at the start; to the right
   * @param omega the angular velocity at the start
   * @param g the size of gravity, which points down
   */
  static Place after(double rho, double theta, double omega, double g, double time) {
    double h = time / STEPS;
    double th = theta;
    double om = omega;
    double t = 0;
    while (t < time && g * Math.cos(th) > rho * om * om) {
      double k = g / rho;
      double a1 = k * Math.sin(th);
      double b1 = om;
      double a2 = k * Math.sin(th + h / 2 * b1);
      double b2 = om + h / 2 * a1;
      double a3 = k * Math.sin(th + h / 2 * b2);
      double b3 = om + h / 2 * a2;
      double a4 = k * Math.sin(th + h * b3);
      double b4 = om + h * a3;
      th += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
      om += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
      t += h;
    }
    double left = time - t;
    double fall = g * left * left / 2;
    double vx = rho * om * Math.cos(th);
    double vy = -rho * om * Math.sin(th);
    double x = rho * Math.sin(th) + vx * left;
    double y = rho * Math.cos(th) + vy * left - fall;
    double path = rho * Math.abs(th - theta) + Math.hypot(vx * left, vy * left - fall);
    return new Place(x, y, path);
  }
}
