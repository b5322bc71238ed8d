// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/** The detector of this library without its promise. */
final class PlainDetector extends LineDetector {

  @Override
  boolean countsRoots() {
    return false;
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
    pairTests++;
    return PlainSweptCircle.line(px, py, r, vx, vy, ax, ay, bx, by, end);
  }
}
