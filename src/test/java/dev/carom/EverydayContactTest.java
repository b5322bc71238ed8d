// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.ContactRun.SEEDS;
import static dev.carom.EverydayScenes.MIXED;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.EverydayScenes.Places;
import dev.carom.EverydayScenes.Shape;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Everyday scenes, in all sizes and restitutions: each call is finished, nothing overlaps by more
 * than rounding, energy does not grow, and heaps come to rest.
 *
 * <p>Of a hundred balls and more each shape is played once, with places and restitution that change
 * from shape to shape; with {@code -Dcarom.contacts=N} all of them, with N seeds.
 */
class EverydayContactTest {

  private static final double[] RESTITUTIONS = {0, 0.3, 0.5, 0.9, MIXED};

  /** Twenty seconds, in frames. */
  private static final double SOON = 1_200;

  /** What was wrong in some scenes, a line each. */
  private static void assertLawful(List<EverydayScenes> all) {
    List<String> wrong = new ArrayList<>();
    for (EverydayScenes scenes : all) {
      String faults = new ContactRun(new World(scenes.scene())).play(300).faults();
      if (!faults.isEmpty()) {
        wrong.add(scenes + ": " + faults);
      }
    }
    assertThat(wrong).isEmpty();
  }

  private static List<EverydayScenes> sample(Shape shape, int balls) {
    int k = shape.ordinal() + balls / 100;
    EverydayScenes one = EverydayScenes.of(shape, balls).places(Places.values()[k % 3]);
    return SEEDS > 0 ? scenes(shape, balls, SEEDS) : List.of(one.restitution(RESTITUTIONS[k % 5]));
  }

  private static List<EverydayScenes> scenes(Shape shape, int balls, int seeds) {
    List<EverydayScenes> all = new ArrayList<>();
    for (int seed = 3; seed < 3 + seeds; seed++) {
      for (double e : RESTITUTIONS) {
        for (Places places : Places.values()) {
          all.add(EverydayScenes.of(shape, balls).restitution(e).places(places).seed(seed));
        }
      }
    }
    return all;
  }

  @ParameterizedTest
  @EnumSource(Shape.class)
  void tenBalls(Shape shape) {
    assertLawful(scenes(shape, 10, 1));
  }

  @ParameterizedTest
  @EnumSource(Shape.class)
  void thirtyBalls(Shape shape) {
    assertLawful(scenes(shape, 30, 1));
  }

  @ParameterizedTest
  @EnumSource(Shape.class)
  void aHundredBalls(Shape shape) {
    assertLawful(sample(shape, 100));
  }

  @ParameterizedTest
  @EnumSource(Shape.class)
  @Tag("long")
  void threeHundredBalls(Shape shape) {
    assertLawful(sample(shape, 300));
  }

  /**
   * At most 20 s after the last fast impact nothing moves but balls that roll alone on level
   * ground.
   */
  @ParameterizedTest
  @CsvSource({
    "BOX, 10, 0",
    "BOX, 10, 0.9",
    "BOX, 30, 0.5",
    "BOX, 30, -1",
    "V, 10, 0.3",
    "V, 30, 0",
    "V, 30, 0.9",
    "STAIRS, 10, 0.9",
    "STAIRS, 30, 0.5",
    "BINS, 10, 0",
    "BINS, 30, 0.5",
    "BINS, 30, -1",
    "RAMP, 10, 0.3",
    "RAMP, 30, 0",
    "RAMP, 30, 0.5"
  })
  void heapsComeToRest(Shape shape, int balls, double e) {
    assertRest(EverydayScenes.of(shape, balls).restitution(e).places(places(balls)));
  }

  private static Places places(int balls) {
    return Places.values()[balls % 3];
  }

  @ParameterizedTest
  @EnumSource(
      value = Shape.class,
      names = {"BOX", "V", "STAIRS", "BINS", "RAMP"})
  @Tag("long")
  void largerHeapsComeToRest(Shape shape) {
    for (int seed = 3; seed < 3 + Math.max(1, SEEDS); seed++) {
      for (double e : RESTITUTIONS) {
        assertRest(EverydayScenes.of(shape, 100).restitution(e).seed(seed));
      }
    }
  }

  private static void assertRest(EverydayScenes scenes) {
    ContactRun run = new ContactRun(new World(scenes.scene())).playUntilRest(6_000);
    assertThat(run.faults()).as("%s", scenes).isEmpty();
    assertThat(run.moving()).as("%s: do not rest", scenes).isZero();
    double now = run.world.now();
    assertThat(now - run.lastFast).as("%s: rest at %s", scenes, now).isLessThan(SOON);
  }
}
