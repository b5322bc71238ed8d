// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

/**
 * The offset to a path that starts beside that of a circle, at the same velocity, infinitely near.
 * It is counted in units of its start, and kept in range by a logarithm.
 */
final class NearbyPath {

  /** Above this, the offset is scaled down to about 1: far below where its square overflows. */
  private static final double MOST = 0x1p100;

  private final double[] offset = new double[ImpactMap.SIZE];
  private double log;

  /** Starts in a direction, of any length. */
  NearbyPath(double x, double y) {
    double length = PathError.length(x, y);
    offset[0] = length > 0 ? x / length : 1;
    offset[1] = length > 0 ? y / length : 0;
  }

  void fly(double dt) {
    offset[0] += offset[2] * dt;
    offset[1] += offset[3] * dt;
  }

  void bounce(ImpactMap map) {
    map.apply(offset, 0);
    double size = 0;
    for (double number : offset) {
      size = Math.max(size, Math.abs(number));
    }
    if (!(size < MOST)) {
      for (int i = 0; i < offset.length; i++) {
        offset[i] /= size;
      }
      log += Math.log(size);
    }
  }

  /** The paths become one. */
  void join() {
    log = Double.NEGATIVE_INFINITY;
  }

  /**
   * The logarithm of the distance, dt from now: of the part at right angles to a velocity, and of
   * all of it if that is 0.
   */
  double log(double dt, double vx, double vy) {
    double x = offset[0] + offset[2] * dt;
    double y = offset[1] + offset[3] * dt;
    double speed = PathError.length(vx, vy);
    return log + Math.log(speed == 0 ? PathError.length(x, y) : Math.abs(vx * y - vy * x) / speed);
  }
}
