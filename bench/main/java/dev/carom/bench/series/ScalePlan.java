// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Gas;
import dev.carom.bench.experiment.Tiles;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Which scenes are played, and for how long.
 *
 * @param sides of the scenes: each has 100 side^2 circles, and, where these ignore each other, as
 *     many lines; ascending
 * @param rounds in which methods take turns, at least 1
 * @param roundMillis how long a method plays in a round, at least one frame
 * @param warmUpMillis how long each method plays the first scene before anything is measured
 * @param limitMillis a method of which one frame takes longer plays no larger scenes
 */
public record ScalePlan(
    List<Integer> sides,
    int rounds,
    int roundMillis,
    int warmUpMillis,
    int limitMillis,
    long seed) {

  /** How circles treat each other. */
  public enum Model {
    ALONE("alone", "circles that ignore each other"),
    GAS("gas", "circles that collide");

    private final String label;
    private final String words;

    Model(String label, String words) {
      this.label = label;
      this.words = words;
    }

    /** Its name in files. */
    public String label() {
      return label;
    }

    /** It for a title: a few words. */
    public String title() {
      return this == GAS ? "Colliding circles" : "Circles among lines";
    }

    /** Returns it in words. */
    public String words() {
      return words;
    }
  }

  /** By default, one frame may take so long. */
  public static final int LIMIT_MILLIS = 1000;

  private static final int[] SIDES = {1, 2, 3, 6, 10, 18, 32, 56, 100};
  private static final int MOST_QUICK = 1000;
  private static final double PACKING = 0.2;

  /**
   * From a hundred circles on, two scenes a decade.
   *
   * @param most circles, at least 100
   * @param quick whether up to a thousand circles, and short rounds, will do
   * @param limitMillis see above
   */
  public static ScalePlan of(int most, boolean quick, int limitMillis, long seed) {
    int end = quick ? Math.min(most, MOST_QUICK) : most;
    List<Integer> sides = IntStream.of(SIDES).filter(s -> circles(s) <= end).boxed().toList();
    return new ScalePlan(
        sides, quick ? 3 : 5, quick ? 20 : 300, quick ? 500 : 2000, limitMillis, seed);
  }

  /**
   * The same scenes for another time.
   *
   * @param rounds see above
   * @param warmUpMillis see above
   */
  public ScalePlan lasting(int rounds, int warmUpMillis) {
    return new ScalePlan(sides, rounds, roundMillis, warmUpMillis, limitMillis, seed);
  }

  /** The circles of a scene. */
  public static int circles(int side) {
    return 100 * side * side;
  }

  Scene scene(Model model, int side) throws CannotPlaceException {
    return model == Model.ALONE
        ? new Tiles(side, true, seed).scene()
        : new Gas(circles(side), PACKING, 1, false, seed).scene();
  }
}
