// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

/** A detector in float: the question is rounded first. */
final class RoundedDetector extends LineDetector {

  private final FloatLineDetector detector;

  RoundedDetector(FloatLineDetector detector) {
    this.detector = detector;
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
    return detector.time(
        (float) px,
        (float) py,
        (float) r,
        (float) vx,
        (float) vy,
        (float) ax,
        (float) ay,
        (float) bx,
        (float) by,
        (float) end);
  }
}
