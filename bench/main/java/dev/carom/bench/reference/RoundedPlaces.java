// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Scene;
import dev.carom.Vec2;

/**
 * Exact motion whose places are rounded to doubles at each impact, and nothing else: what a method
 * that keeps places in doubles loses, however well it computes.
 */
public final class RoundedPlaces {

  private static final int BITS = 512;

  private RoundedPlaces() {}

  /**
   * Plays one circle.
   *
   * @param scene any scene of circles that ignore each other, and that {@link Truth} plays
   * @param frames how many, at least 1, each one unit of time
   * @throws IllegalStateException if 512 bits do not decide what happens
   */
  public static Vec2 end(Scene scene, int circle, int frames) {
    Run run = new Run(scene, new int[] {circle}, new Lookout(scene, BITS), frames, BITS);
    run.body(0).keepPlacesInDoubles();
    try {
      run.play();
    } catch (DoubtException e) {
      throw new IllegalStateException("circle " + circle + ": " + BITS + " bits do not do", e);
    }
    double[] state = run.courses().get(0).states[frames];
    return new Vec2(state[0], state[1]);
  }
}
