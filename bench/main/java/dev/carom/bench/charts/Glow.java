// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.ImpactLog;

/** Remembers for a few frames which circles hit something, so that the eye can follow. */
public final class Glow {

  private final int frames;
  private final int[] left;

  /**
   * Starts without glow.
   *
   * @param circles the number of circles
   * @param frames for how many frames a circle glows, at least 1
   */
  public Glow(int circles, int frames) {
    this.frames = frames;
    left = new int[circles];
  }

  /** Goes on by one frame. */
  public void frame(ImpactLog impacts) {
    for (int i = 0; i < left.length; i++) {
      left[i] = Math.max(0, left[i] - 1);
    }
    for (int row = 0; row < impacts.size(); row++) {
      left[impacts.circle(row)] = frames;
    }
  }

  boolean of(int circle) {
    return left[circle] > 0;
  }
}
