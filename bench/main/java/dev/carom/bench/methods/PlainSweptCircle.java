// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import java.util.stream.DoubleStream;

/**
 * The detector of this library without its promise: the same decisions in the same order, each by
 * the sign that a plain double happens to have, and times as the first formula gives them. Written
 * as well as doubles allow (nothing cancels but what must), it is what exactness is to be compared
 * with in cost. It refuses the same arguments as the library, by the same sums.
 */
public final class PlainSweptCircle {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private PlainSweptCircle() {}

  /**
   * A moving circle against a line.
   *
   * @param px the x coordinate of the centre
   * @param py the y coordinate of the centre
   * @param r the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param ax the x coordinate of the line's start
   * @param ay the y coordinate of the line's start
   * @param bx the x coordinate of the line's end
   * @param by the y coordinate of the line's end
   * @param end the end of the window
   * @return the time of impact, infinite for a miss
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double line(
      double px,
      double py,
      double r,
      double vx,
      double vy,
      double ax,
      double ay,
      double bx,
      double by,
      double end) {
    if (!(0 * (px + py + r + vx + vy + ax + ay + bx + by) == 0 && r >= 0 && end >= 0)) {
      check(r, 0, end, px, py, vx, vy, ax, ay, bx, by);
    }
    double wx = bx - ax;
    double wy = by - ay;
    double dx = px - ax;
    double dy = py - ay;
    double c = wx * dy - wy * dx;
    double ww = wx * wx + wy * wy;
    double drift = wx * vy - wy * vx;
    if (c * c <= r * r * ww) {
      double along = wx * dx + wy * dy;
      return along <= 0
          ? disk(dx, dy, r, vx, vy, end)
          : along >= ww ? disk(px - bx, py - by, r, vx, vy, end) : c * drift < 0 ? 0 : NEVER;
    }
    double side = Math.signum(c);
    if (side * drift >= 0) {
      return NEVER;
    }
    // On which side of the strip's corners does the path pass?
    double y = r * (vx * wx + vy * wy);
    double yy = y * Math.abs(y);
    double x = -side * (dx * vy - dy * vx);
    if (x * Math.abs(x) * ww <= yy) {
      return disk(dx, dy, r, vx, vy, end);
    }
    x = -side * ((px - bx) * vy - (py - by) * vx);
    if (x * Math.abs(x) * ww >= yy) {
      return disk(px - bx, py - by, r, vx, vy, end);
    }
    return within((Math.abs(c) - r * Math.sqrt(ww)) / Math.abs(drift), end);
  }

  /**
   * Two moving circles.
   *
   * @param x1 the x coordinate of the first circle's centre
   * @param y1 the y coordinate of the first circle's centre
   * @param r1 the radius of the first circle
   * @param vx1 the x component of the first circle's velocity
   * @param vy1 the y component of the first circle's velocity
   * @param x2 the x coordinate of the second circle's centre
   * @param y2 the y coordinate of the second circle's centre
   * @param r2 the radius of the second circle
   * @param vx2 the x component of the second circle's velocity
   * @param vy2 the y component of the second circle's velocity
   * @param end the end of the window
   * @return the time of impact, infinite for a miss
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double pair(
      double x1,
      double y1,
      double r1,
      double vx1,
      double vy1,
      double x2,
      double y2,
      double r2,
      double vx2,
      double vy2,
      double end) {
    double b = (vx1 - vx2) * (x1 - x2) + (vy1 - vy2) * (y1 - y2);
    if (!(0 * (b + (r1 + r2)) == 0 && r1 >= 0 && r2 >= 0 && end >= 0)) {
      check(r1, r2, end, x1, y1, vx1, vy1, x2, y2, vx2, vy2);
    }
    return disk(x1 - x2, y1 - y2, r1 + r2, vx1 - vx2, vy1 - vy2, end);
  }

  private static void check(double r1, double r2, double end, double... numbers) {
    boolean finite = DoubleStream.of(numbers).allMatch(Double::isFinite);
    if (!(finite
        && r1 >= 0
        && r2 >= 0
        && r1 <= Double.MAX_VALUE
        && r2 <= Double.MAX_VALUE
        && end >= 0)) {
      throw new IllegalArgumentException("a number outside its range");
    }
  }

  /** A point at offset d from the middle of a disk of radius r, moving with u. */
  private static double disk(double dx, double dy, double r, double ux, double uy, double end) {
    double b = ux * dx + uy * dy;
    if (b >= 0) {
      return NEVER;
    }
    double g = dx * dx + dy * dy - r * r;
    if (g <= 0) {
      return 0;
    }
    double k = ux * dy - uy * dx;
    double reach = (ux * ux + uy * uy) * (r * r) - k * k;
    if (reach < 0 || (reach == 0 && r > 0)) {
      return NEVER;
    }
    return within(g / (Math.sqrt(reach) - b), end);
  }

  private static double within(double t, double end) {
    return t <= end ? t : NEVER;
  }
}
