// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/**
 * A frame without the contract of this library: plain doubles, the same kind of cells, a filter
 * before the test, no bound of a rounding error, no log, no budget. Unit normals of the lines are
 * computed before. A line that is behind, or too far away to be the next, costs its distance only.
 */
final class PlainGridMethod extends GridEventDriven {

  private final double[] nx;
  private final double[] ny;
  private final double[] offset;
  private final double[] length;

  PlainGridMethod(Scene scene) {
    super(scene, new PlainDetector());
    nx = new double[lines];
    ny = new double[lines];
    offset = new double[lines];
    length = new double[lines];
    for (int k = 0; k < lines; k++) {
      length[k] = Math.hypot(bx[k] - ax[k], by[k] - ay[k]);
      nx[k] = length[k] == 0 ? 1 : (ay[k] - by[k]) / length[k];
      ny[k] = length[k] == 0 ? 0 : (bx[k] - ax[k]) / length[k];
      offset[k] = nx[k] * ax[k] + ny[k] * ay[k];
    }
  }

  @Override
  double test(int i, int k, double first) {
    detector.pairTests++;
    double px = x[i];
    double py = y[i];
    double r = radius[i];
    double ux = vx[i];
    double uy = vy[i];
    double away = nx[k] * px + ny[k] * py - offset[k];
    double pace = nx[k] * ux + ny[k] * uy;
    double gap = Math.abs(away) - r;
    if (gap > 0 && (away * pace >= 0 || gap > first * Math.abs(pace))) {
      return NEVER;
    }
    double dx = px - ax[k];
    double dy = py - ay[k];
    double along = ny[k] * dx - nx[k] * dy;
    double t = 0;
    if (gap > 0) {
      t = gap / Math.abs(pace);
      along += t * (ny[k] * ux - nx[k] * uy);
    }
    if (along > 0 && along < length[k]) {
      return away * pace < 0 ? t : NEVER;
    }
    double ends = along <= 0 ? point(dx, dy, r, ux, uy) : point(px - bx[k], py - by[k], r, ux, uy);
    return ends <= first ? ends : NEVER;
  }

  /** g / (s - b), with g the room to a point, b the approach and s^2 the discriminant. */
  private static double point(double dx, double dy, double r, double ux, double uy) {
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
    return reach > 0 ? g / (Math.sqrt(reach) - b) : NEVER;
  }
}
