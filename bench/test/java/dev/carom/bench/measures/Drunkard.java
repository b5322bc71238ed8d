// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.methods.Circles;
import dev.carom.bench.methods.Contender;

/**
 * A method with known faults: it meets nothing, goes astray by a step along +y in each frame, and
 * gains speed by a factor.
 */
final class Drunkard extends Circles {

  private final double astray;
  private final double gain;
  private final int lastFrame;
  private int frame;

  private Drunkard(Scene scene, double astray, double gain, int lastFrame) {
    super(scene);
    this.astray = astray;
    this.gain = gain;
    this.lastFrame = lastFrame;
  }

  static Contender astray(double step) {
    return contender(step, 1, Integer.MAX_VALUE);
  }

  static Contender gaining(double factor) {
    return contender(0, factor, Integer.MAX_VALUE);
  }

  /** It falls in the frame after the given one. */
  static Contender falling(int lastFrame) {
    return contender(0, 1, lastFrame);
  }

  /** A contender that cannot run here. */
  static Contender absent(String reason) {
    return new Contender(
        "absent",
        "absent",
        "",
        scene -> {
          throw new UnsupportedOperationException(reason);
        });
  }

  private static Contender contender(double astray, double gain, int lastFrame) {
    return new Contender(
        "drunkard",
        "drunkard",
        "step=" + astray,
        scene -> new Drunkard(scene, astray, gain, lastFrame));
  }

  @Override
  public void frame() {
    if (frame++ == lastFrame) {
      throw new IllegalStateException("it fell");
    }
    for (int i = 0; i < circles; i++) {
      x[i] += vx[i];
      y[i] += vy[i] + astray;
      vx[i] *= gain;
      vy[i] *= gain;
    }
  }

  @Override
  public int impacts() {
    return UNKNOWN;
  }

  @Override
  public int wallImpacts() {
    return 3;
  }

  @Override
  public int squareRoots() {
    return 0;
  }

  @Override
  public long pairTests() {
    return frame;
  }
}
