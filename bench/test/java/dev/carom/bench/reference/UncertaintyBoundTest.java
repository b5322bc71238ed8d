// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Uncertainty;
import dev.carom.World;
import java.io.IOException;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The bound of an {@link Uncertainty} against true courses, in arbitrary precision. */
class UncertaintyBoundTest {

  /**
   * The bound at the median place, in units of its error. Measured: 6 to 13, printed by each test.
   */
  private static final double MEDIAN = 15;

  /**
   * The error is below the bound at every circle and frame, until the bound of that circle reaches
   * its radius; and the bound is not much larger than need be.
   */
  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"base-1", "base-2", "base-3", "fast-1", "radii", "falling"})
  void holdsUntilItReachesARadius(String name) throws IOException {
    double[] ratios = ratios(References.scene(name), References.load(name), name);
    assertThat(ratios.length).isGreaterThan(3_500);
    assertThat(ratios[ratios.length / 2]).isLessThan(MEDIAN);
  }

  /** Impacts of any restitution, with walls, pegs and lines, without gravity and with it. */
  @ParameterizedTest
  @CsvSource({"0.5, 0", "0.9, 0", "1.1, 0", "0.5, 0.05", "0.9, 0.05", "1.1, 0.05"})
  void holdsAtAnyRestitution(double e, double gravity) {
    SceneBuilder builder =
        Scene.builder().collide(false).bounds(0, 0, 200, 200).gravity(gravity / 4, -gravity);
    builder.line(70, 25, 80, 35).restitution(e);
    for (int i = 0; i < 9; i++) {
      builder.peg(47 + 50 * (i % 3) + 3 * (i / 3), 50 + 50 * (i / 3), 9 + i).restitution(e);
    }
    for (int i = 0; i < 8; i++) {
      builder.circle(20 + 20 * i, 75, 3, 7 * Math.cos(i), 7 * Math.sin(i));
    }
    Scene scene = builder.build();
    Truth truth = Truth.of(scene, 40, () -> {});
    double[] ratios = ratios(scene, truth, "restitution %s, gravity %s".formatted(e, gravity));
    assertThat(ratios.length).isGreaterThan(100);
    assertThat(ratios[ratios.length / 2]).isLessThan(MEDIAN);
  }

  /** By how much the bound exceeds the error, ascending, at all places that are known. */
  private static double[] ratios(Scene scene, Reference truth, String name) {
    World world = new World(scene);
    int frames = truth.frames();
    int circles = scene.count(Kind.CIRCLE);
    Uncertainty uncertainty = world.uncertainty(1);
    boolean[] isKnown = new boolean[circles];
    Arrays.fill(isKnown, true);
    double[] ratios = new double[frames * circles];
    int count = 0;
    double worst = 0;
    for (int frame = 1; frame <= frames; frame++) {
      world.advanceTo(frame);
      for (int i = 0; i < circles; i++) {
        double bound = uncertainty.bound(i);
        isKnown[i] &= bound < world.radius(i);
        if (isKnown[i]) {
          double x = truth.x(frame, i);
          double y = truth.y(frame, i);
          double error = Math.hypot(world.x(i) - x, world.y(i) - y);
          double rounding = Math.hypot(Math.ulp(x), Math.ulp(y)) / 2; // of the reference
          worst = Math.max(worst, (error - rounding) / bound);
          ratios[count++] = bound / Math.max(error, rounding);
        }
      }
    }
    Arrays.sort(ratios, 0, count);
    System.out.printf(
        "%s: %d places, error / bound at most %.3f; bound / error: median %.1f, p99 %.0f%n",
        name, count, worst, ratios[count / 2], ratios[count * 99 / 100]);
    assertThat(worst).isLessThanOrEqualTo(1);
    return Arrays.copyOf(ratios, count);
  }
}
