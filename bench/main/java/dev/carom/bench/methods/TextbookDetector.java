// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static dev.carom.bench.methods.RealDouble.real;

/**
 * The test of the textbooks: first the line as if it had no ends; if the foot of that contact is
 * not on it, its two ends by the quadratic with c = e.e - r^2 and b^2 - a c. Right as mathematics;
 * in doubles the differences cancel.
 */
public final class TextbookDetector extends LineDetector {

  @Override
  public double time(
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
    pairTests++;
    double ex = px - ax;
    double ey = py - ay;
    double wx = bx - ax;
    double wy = by - ay;
    double cross = wx * ey - wy * ex;
    double drift = wx * vy - wy * vx;
    if (cross * drift < 0) {
      squareRoots++;
      double ww = wx * wx + wy * wy;
      double t = Math.max(0, (Math.abs(cross) - r * real(Math.sqrt(ww))) / Math.abs(drift));
      double along = wx * (ex + t * vx) + wy * (ey + t * vy);
      if (along > 0 && along < ww) {
        return t <= end ? t : NEVER;
      }
    }
    return Math.min(point(ex, ey, r, vx, vy, end), point(px - bx, py - by, r, vx, vy, end));
  }

  /** a t^2 + 2 b t + c = 0 with a = v.v, b = e.v, c = e.e - r^2 */
  private double point(double ex, double ey, double r, double vx, double vy, double end) {
    double b = ex * vx + ey * vy;
    if (b >= 0) {
      return NEVER;
    }
    double c = ex * ex + ey * ey - r * r;
    if (c <= 0) {
      return 0;
    }
    double a = vx * vx + vy * vy;
    double discriminant = b * b - a * c;
    if (discriminant <= 0) {
      return NEVER;
    }
    squareRoots++;
    double t = (-b - real(Math.sqrt(discriminant))) / a;
    return t <= end ? t : NEVER;
  }
}
