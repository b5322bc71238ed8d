// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.methods.PlainScene;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The true position of a circle at the end of a run, rounded to a number of decimals.
 *
 * @param circle the number of the circle in the scene
 * @param x the x coordinate, correctly rounded
 * @param y the y coordinate, correctly rounded
 */
public record LastPlace(int circle, BigDecimal x, BigDecimal y) {

  private static final int FIRST_BITS = 128;
  private static final int MOST_BITS = 1 << 17;

  /** So many decimals, and the 309 digits that may stand before the point, need fewer bits. */
  public static final int MOST_DECIMALS = 39_000;

  /**
   * Computes the positions of all circles. The precision is doubled until every decimal is proved.
   *
   * @param scene any scene that {@link Truth} plays
   * @param frames the number of frames, at least 1, each one unit of time
   * @param decimals the number of digits behind the point, from 0 to {@link #MOST_DECIMALS}
   * @param progress called after each circle, where circles ignore each other
   * @return one position per circle, in their order
   * @throws IllegalArgumentException if {@link Truth} does not play the scene, or frames is less
   *     than 1
   * @throws IllegalStateException if impacts pile up, or 131,072 bits do not prove the decimals
   */
  public static List<LastPlace> of(Scene scene, int frames, int decimals, Runnable progress) {
    Scope.check(scene, frames);
    int[] all = IntStream.range(0, scene.count(Kind.CIRCLE)).toArray();
    if (PlainScene.collides(scene)) {
      return prove(scene, all, frames, decimals);
    }
    List<LastPlace> places = new ArrayList<>();
    for (int i : all) {
      places.addAll(prove(scene, new int[] {i}, frames, decimals));
      progress.run();
    }
    return places;
  }

  private static List<LastPlace> prove(Scene scene, int[] circles, int frames, int decimals) {
    for (int bits = FIRST_BITS; bits <= MOST_BITS; bits *= 2) {
      try {
        return attempt(scene, circles, frames, decimals, bits);
      } catch (DoubtException e) {
        // With more bits, then.
      }
    }
    throw new IllegalStateException(
        "circle %d: %d bits do not decide its course: expected fewer frames or digits"
            .formatted(circles[0], MOST_BITS));
  }

  private static List<LastPlace> attempt(
      Scene scene, int[] circles, int frames, int decimals, int bits) {
    Run run = new Run(scene, circles, new Lookout(scene, bits), frames, bits);
    run.play();
    List<LastPlace> places = new ArrayList<>();
    for (int i = 0; i < circles.length; i++) {
      Body body = run.body(i);
      Vec place = body.at(Ball.of(frames, bits).minus(body.t));
      places.add(
          new LastPlace(circles[i], place.x().rounded(decimals), place.y().rounded(decimals)));
    }
    return places;
  }
}
