// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Feature;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Circles that collide: the reference by itself, and the library against it. */
class CollidingTruthTest {

  private static final int FRAMES = 100;

  /** Promised, in units of 2^-53 x conditioning. */
  private static final double PROMISE = 4;

  /** Beyond this conditioning, 10^12, nothing is promised. */
  private static final double MOST = 12;

  private static Truth truth(Scene scene, int frames) {
    return Truth.of(scene, frames, () -> {});
  }

  /**
   * A light circle between a wall and one 100^n times as heavy. Source: G. Galperin, Playing pool
   * with pi, Regular and Chaotic Dynamics 8 (2003).
   */
  @ParameterizedTest
  @CsvSource({"1, 3", "100, 31", "10000, 314"})
  void impactsCountTheDigitsOfPi(double mass, int impacts) {
    SceneBuilder setup = Scene.builder().line(0, -10, 0, 10).circle(5, 0, 1, 0, 0);
    Scene scene = setup.circle(10, 0, 1, -1, 0).mass(mass).collide(true).build();
    Truth truth = truth(scene, 1000);
    assertThat(truth.impacts()).isEqualTo(impacts);
    assertThat(truth.vx(1000, 1))
        .as("none is left")
        .isGreaterThanOrEqualTo(truth.vx(1000, 0))
        .isPositive();
  }

  /** Equal masses swap their velocities along the line of centres; e scales what they part with. */
  @ParameterizedTest
  @CsvSource({"1, -1, 2", "0.5, -0.25, 1.25", "0, 0.5, 0.5"})
  void headOnPairPartsByItsRestitution(double restitution, double v1, double v2) {
    SceneBuilder setup = Scene.builder().circle(0, 0, 1, 2, 0).restitution(restitution);
    Scene scene = setup.circle(5, 0, 1, -1, 0).collide(true).build();
    Truth truth = truth(scene, 3);
    assertThat(truth.vx(3, 0)).isEqualTo(v1);
    assertThat(truth.vx(3, 1)).isEqualTo(v2);
  }

  /** Its velocity is zero, but not to be told from zero by any digits. */
  @Test
  void circleThatStopsHitsNothing() {
    SceneBuilder setup = Scene.builder().line(1.05, -5, 1.05, 5).circle(2.1, 0.1, 0.7, 0.3, 0.1);
    Scene scene = setup.circle(5.6, 0.1 + 3.5 / 3, 0.7, 0, 0).collide(true).build();
    SceneBuilder other = Scene.builder().line(-0.75, -5, -0.75, 5).circle(0, 0.1, 0.7, 0.3, 0);
    Scene headOn = other.circle(3.1, 0.1, 0.7, 0, 0).collide(true).build();
    assertThat(truth(scene, 20).impacts()).isEqualTo(1);
    Truth truth = truth(headOn, 20);
    assertThat(truth.impacts()).isEqualTo(1);
    assertThat(truth.vx(20, 0)).isZero();
    assertThat(truth.vx(20, 1)).isEqualTo(0.3);
  }

  @Test
  void infiniteMassIsNotDeflected() {
    SceneBuilder setup = Scene.builder().circle(0, 0, 1, 2, 0);
    Scene scene = setup.circle(5, 0, 1, -1, 0).mass(Double.POSITIVE_INFINITY).collide(true).build();
    Truth truth = truth(scene, 2);
    assertThat(truth.vx(2, 0)).isEqualTo(-4);
    assertThat(truth.vx(2, 1)).isEqualTo(-1);
  }

  /** Both pairs touch at time 1: the one with the lower numbers comes first. */
  @Test
  void simultaneousPairsAreTakenByTheirNumbers() {
    SceneBuilder setup = Scene.builder().circle(0, 0, 1, 0.3, 0).circle(2.3, 9, 1, 0, 0);
    Scene scene = setup.circle(2.3, 0, 1, 0, 0).circle(0, 9, 1, 0.3, 0).collide(true).build();
    List<Hit> hits = truth(scene, 2).proofs().get(0).hits();
    assertThat(hits)
        .containsExactly(
            new Hit(0, Kind.CIRCLE, 2, Feature.CIRCLE), new Hit(1, Kind.CIRCLE, 3, Feature.CIRCLE));
  }

  /** The sum over the start values of |d place / d ln q|, by differences of runs in many digits. */
  @Test
  void conditioningIsTheSumOfTheDerivatives() {
    Scene scene = CollidingScene.of(4, 1, true, 8);
    Truth truth = truth(Differences.moved(scene, -1, 0), 60);
    assertThat(truth.impacts()).isGreaterThan(10);
    for (int i = 0; i < 4; i++) {
      double sum = 0;
      for (int q = 0; q < 4 * 4; q++) {
        sum += Differences.derivative(scene, q, 60, i);
      }
      assertThat(truth.log10Conditioning(60, i)).isCloseTo(Math.log10(sum), within(1e-4));
    }
  }

  /**
   * World against the reference, at every circle and frame until the first circle of the scene is
   * beyond the promise: from then on it may miss another one, or hit it, whatever that one's own
   * conditioning is.
   */
  @Test
  void errorsOfTheWorldStayWithinThePromise() {
    double[] ratios = new double[0];
    int impacts = 0;
    for (int circles : new int[] {8, 16, 30}) {
      for (double restitution : new double[] {1, 0.95}) {
        for (boolean obstacles : new boolean[] {false, true}) {
          Scene scene = CollidingScene.of(circles, restitution, obstacles, circles);
          Truth truth = truth(scene, FRAMES);
          double[] more = ratios(scene, truth);
          ratios = Arrays.copyOf(ratios, ratios.length + more.length);
          System.arraycopy(more, 0, ratios, ratios.length - more.length, more.length);
          impacts += truth.impacts();
        }
      }
    }
    Arrays.sort(ratios);
    int count = ratios.length;
    System.out.printf(
        "colliding: error / (2^-53 x conditioning) at %d places: worst %.2f, p99 %.2f, median"
            + " %.3f; %d impacts in all%n",
        count, ratios[count - 1], ratios[count * 99 / 100], ratios[count / 2], impacts);
    assertThat(count).isGreaterThan(10_000);
    assertThat(ratios[count - 1]).isLessThanOrEqualTo(PROMISE);
  }

  private static double[] ratios(Scene scene, Truth truth) {
    World world = new World(scene);
    int circles = scene.count(Kind.CIRCLE);
    double[] ratios = new double[FRAMES * circles];
    int count = 0;
    for (int frame = 1; frame <= FRAMES && isWithin(truth, frame); frame++) {
      world.advanceTo(frame);
      for (int i = 0; i < circles; i++) {
        double error = Math.hypot(world.x(i) - truth.x(frame, i), world.y(i) - truth.y(frame, i));
        double unit = 0x1p-53 * Math.pow(10, truth.log10Conditioning(frame, i));
        ratios[count++] = error / unit;
      }
    }
    return Arrays.copyOf(ratios, count);
  }

  private static boolean isWithin(Truth truth, int frame) {
    boolean within = true;
    for (int i = 0; i < truth.circles(); i++) {
      within &= truth.log10Conditioning(frame, i) < MOST;
    }
    return within;
  }
}
