// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Frames do not matter: however a run to the same time is cut into steps, its impacts are the same
 * in every column, bit for bit, and so is its end.
 */
class FrameIndependenceTest {

  private static final double END = 600;

  private static Run whole(Scene scene) {
    return Run.advance(new World(scene), END);
  }

  /** Frames of one, and of a half, and of 1/10, which is no double. */
  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "base-2.csv", "base-3.csv", "fast-1.csv", "radii.csv"})
  void framesDoNotMatter(String file) {
    Scene scene = TestScenes.read(file);
    Run whole = whole(scene);
    assertThat(whole.impacts()).hasSizeGreaterThan(2000);
    for (int frames : new int[] {600, 1200, 6000}) {
      double[] ends = IntStream.rangeClosed(1, frames).mapToDouble(i -> i * END / frames).toArray();
      assertThat(Run.advance(new World(scene), ends)).as("%s frames", frames).isEqualTo(whole);
    }
  }

  /** Cut exactly at impacts, and one ulp before and after each, also where paths are parabolas. */
  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "fast-1.csv", "radii.csv", "falling"})
  void cutsAtTheImpactsDoNotMatter(String name) {
    Scene scene =
        name.equals("falling")
            ? RandomScenes.falling(new Random(1)).build()
            : TestScenes.read(name);
    Run whole = whole(scene);
    assertThat(whole.impacts()).hasSizeGreaterThan(1000);
    double[] ends =
        DoubleStream.concat(
                whole.impacts().stream()
                    .mapToDouble(Impact::time)
                    .flatMap(t -> DoubleStream.of(Math.max(0, Math.nextDown(t)), t, Math.nextUp(t)))
                    .sorted(),
                DoubleStream.of(END))
            .toArray();
    assertThat(Run.advance(new World(scene), ends)).isEqualTo(whole);
  }

  /** Asking where the circles are does not move them. */
  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "radii.csv"})
  void lookingChangesNothing(String file) {
    Scene scene = TestScenes.read(file);
    World watched = new World(scene);
    for (int frame = 0; frame < 600; frame++) {
      watched.step(1);
      Run.states(watched);
    }
    assertThat(Run.states(watched)).isEqualTo(whole(scene).end());
  }
}
