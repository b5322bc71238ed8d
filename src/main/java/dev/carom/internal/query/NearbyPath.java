// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

/**
 * The distance to a path that starts beside a circle's, at the same velocity, infinitely near. It
 * is counted in units of its start, and kept in range by a logarithm.
 */
final class NearbyPath {

  /** Above this, distance and rate are scaled down to about 1. */
  private static final double MOST = 0x1p500;

  private double across = 1;
  private double acrossRate;
  private double log;

  void fly(double dt) {
    across += acrossRate * dt;
  }

  void bounce(ImpactMap map) {
    acrossRate = map.kept * acrossRate + map.turned * across;
    across *= map.kept;
    if (!(across < MOST && acrossRate < MOST)) {
      double scale = Math.max(across, acrossRate);
      across /= scale;
      acrossRate /= scale;
      log += Math.log(scale);
    }
  }

  /** The logarithm of the distance, dt from now. */
  double log(double dt) {
    return log + Math.log(across + acrossRate * dt);
  }
}
