// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;

/**
 * The moments of one run that are drawn.
 *
 * @param opening the first frames one by one, from time 0, with circles that glow
 * @param middle half-way
 * @param end after the last frame
 */
record Replay(List<Still> opening, Still middle, Still end) {

  private static final int GLOW = 5;

  /** Runs a scene for a number of frames of length 1 and keeps at most so many of the first. */
  static Replay of(Scene scene, int frames, int openingFrames) {
    World world = new World(scene);
    Glow glow = new Glow(scene.count(Kind.CIRCLE), GLOW);
    List<Still> opening = new ArrayList<>();
    Still middle = null;
    for (int frame = 0; frame <= frames; frame++) {
      if (frame > 0) {
        world.step(1);
        glow.frame(world.impacts());
      }
      if (frame < openingFrames) {
        opening.add(Still.of(world, glow));
      }
      if (frame == frames / 2) {
        middle = Still.of(world);
      }
    }
    return new Replay(List.copyOf(opening), middle, Still.of(world));
  }
}
