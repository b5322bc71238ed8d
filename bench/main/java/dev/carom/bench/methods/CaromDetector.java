// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.SweptCircle;

/** The detector of this library. */
final class CaromDetector extends LineDetector {

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
    return new SweptCircle(px, py, r, vx, vy).timeToLine(ax, ay, bx, by, end);
  }
}
