// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

/**
 * The offset to a path that starts beside that of a circle which falls, at the same velocity,
 * infinitely near. It is counted in units of its start, and kept in range by a logarithm.
 */
final class FallingNeighbor {

  /** Above this, the offset is scaled down to about 1. */
  private static final double MOST = 0x1p500;

  private final double[] offset = new double[FallingMap.SIZE];
  private double log;

  /** Starts in a direction, of any length. */
  FallingNeighbor(double x, double y) {
    double length = PathError.length(x, y);
    offset[0] = x / length;
    offset[1] = y / length;
  }

  void fly(double dt) {
    offset[0] += offset[2] * dt;
    offset[1] += offset[3] * dt;
  }

  void bounce(FallingMap map) {
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

  /** The logarithm of the distance, dt from now. */
  double log(double dt) {
    return log + Math.log(PathError.length(offset[0] + offset[2] * dt, offset[1] + offset[3] * dt));
  }
}
