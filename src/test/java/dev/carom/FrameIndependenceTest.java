// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
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

  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "base-2.csv", "base-3.csv", "fast-1.csv", "radii.csv"})
  void wholeAndHalfFramesAndNoneAtAll(String file) {
    Scene scene = TestScenes.read(file);
    Run whole = whole(scene);
    assertThat(whole.impacts()).hasSizeGreaterThan(2000);
    assertThat(Run.step(new World(scene), 1, 600)).isEqualTo(whole);
    assertThat(Run.step(new World(scene), 0.5, 1200)).isEqualTo(whole);
  }

  /** Frames of 1/60 end at times that no frame of another length shares, but for the last. */
  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "fast-1.csv", "radii.csv"})
  void framesThatAreNoDoubles(String file) {
    Scene scene = TestScenes.read(file);
    double[] times = new double[6000];
    for (int i = 0; i < times.length; i++) {
      times[i] = (i + 1) / 10.0;
    }
    assertThat(Run.advance(new World(scene), times)).isEqualTo(whole(scene));
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "fast-1.csv", "radii.csv"})
  void anySlicing(String file) {
    Scene scene = TestScenes.read(file);
    Run whole = whole(scene);
    Random random = new Random(3);
    for (int slices : new int[] {2, 3, 10, 100, 1000, 5000}) {
      double[] times = random.doubles(slices, 0, END).sorted().toArray();
      times[slices - 1] = END;
      assertThat(Run.advance(new World(scene), times)).as("%s slices", slices).isEqualTo(whole);
    }
  }

  /** Cut exactly at impacts, and one ulp before and after each. */
  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "fast-1.csv", "radii.csv"})
  void cutsAtTheImpactsThemselves(String file) {
    Scene scene = TestScenes.read(file);
    Run whole = whole(scene);
    double[] at = whole.impacts().stream().mapToDouble(Run.Row::time).toArray();
    assertThat(Run.advance(new World(scene), withEnd(at))).isEqualTo(whole);
    double[] around =
        Arrays.stream(at)
            .flatMap(t -> Arrays.stream(new double[] {Math.nextDown(t), t, Math.nextUp(t)}))
            .sorted()
            .toArray();
    assertThat(Run.advance(new World(scene), withEnd(around))).isEqualTo(whole);
  }

  /** Among slides that end between impacts, and circles that come to rest. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void wherePathsAreParabolasToo(long seed) {
    Scene scene = RandomScenes.falling(new Random(seed)).build();
    Run whole = whole(scene);
    assertThat(whole.impacts()).hasSizeGreaterThan(1000);
    assertThat(Run.step(new World(scene), 0.5, 1200)).isEqualTo(whole);
    double[] at = whole.impacts().stream().mapToDouble(Run.Row::time).toArray();
    assertThat(Run.advance(new World(scene), withEnd(at))).isEqualTo(whole);
  }

  private static double[] withEnd(double[] times) {
    double[] all = Arrays.copyOf(times, times.length + 1);
    all[times.length] = END;
    return all;
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
