// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/**
 * Looks at the closest point of the line at evenly spaced moments of the window: the first one at
 * which it is within the radius, and the circle comes nearer, is the answer. Its resolution in time
 * is the window divided by the number of samples.
 */
final class ClosestPointDetector extends LineDetector {

  private final int samples;

  ClosestPointDetector(int samples) {
    this.samples = samples;
  }

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
    double wx = bx - ax;
    double wy = by - ay;
    double ww = wx * wx + wy * wy;
    for (int sample = 0; sample <= samples; sample++) {
      double t = end * ((double) sample / samples);
      double ex = px + t * vx - ax;
      double ey = py + t * vy - ay;
      double along = wx * ex + wy * ey;
      double s = along <= 0 ? 0 : along >= ww ? 1 : along / ww;
      double dx = ex - s * wx;
      double dy = ey - s * wy;
      if (dx * dx + dy * dy <= r * r && vx * dx + vy * dy < 0) {
        return t;
      }
    }
    return NEVER;
  }
}
