// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.methods.PlainScene;
import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class WorldFuzzTest {

  @Test
  void someWorldsPlayWithoutAFinding() throws FindingException {
    WorldFuzz fuzz = new WorldFuzz();
    for (int seed = 9; seed < 20; seed++) {
      fuzz.play(seed);
    }

    assertThat(fuzz.sessions()).isEqualTo(11);
    assertThat(fuzz.impacts()).isGreaterThan(1_000);
    assertThat(fuzz.flights()).isGreaterThan(500);
    assertThat(fuzz.steps()).isGreaterThan(100);
  }

  /** Lines and pegs that move, in sessions of their own. */
  @Test
  void worldsWithThingsThatMovePlayWithoutAFinding() throws FindingException {
    WorldFuzz fuzz = new WorldFuzz();
    for (long seed : new long[] {5, 14, 23, 26, 35, 47}) {
      fuzz.play(seed);
      assertThat(new Session(seed).scene())
          .as("%d", seed)
          .satisfies(scene -> assertThat(PlainScene.isAtRest(scene)).isFalse());
    }
    assertThat(PlainScene.isAtRest(new Session(6).scene())).isTrue();
    assertThat(fuzz.flights()).isGreaterThan(500);
  }

  /** Circles that collide or not, in the open too, in units of any size. */
  @Test
  void worldsWithGravityPlayWithoutAFinding() throws FindingException {
    WorldFuzz fuzz = new WorldFuzz();
    for (long seed : new long[] {13, 14, 27, 29, 30, 59}) {
      fuzz.play(seed);
      assertThat(new Session(seed).scene().gravity()).as("%d", seed).isNotEqualTo(Vec2.ZERO);
    }
    assertThat(new Session(6).scene().gravity()).isEqualTo(Vec2.ZERO);
    assertThat(fuzz.flights()).isGreaterThan(1_000);
    assertThat(fuzz.impacts()).isGreaterThan(1_000);
  }

  /** A circle is put far outside: the next step once did not end. */
  @Test
  void aStepEndsAlsoWithACircleFarOutside() throws FindingException {
    assertThat(Variation.Kind.of(49)).isEqualTo(Variation.Kind.FAR);
    WorldFuzz fuzz = new WorldFuzz();
    fuzz.play(49);

    assertThat(fuzz.steps()).isPositive();
  }

  /** Circles far outside, common centres, small whole numbers, and edits before each step. */
  @ParameterizedTest
  @CsvSource({"FAR, 73", "FAR, 94", "CONCENTRIC, 66", "SMALL, 70", "EDITED, 57"})
  void worldsOfASpecialKindPlayWithoutAFinding(Variation.Kind kind, long seed)
      throws FindingException {
    assertThat(Variation.Kind.of(seed)).isEqualTo(kind);
    Scene scene = new Session(seed).scene();
    assertThat(scene.collide()).isTrue();
    double[] places = places(scene);
    assertThat(Arrays.stream(places).anyMatch(p -> Math.abs(p) > 4 * Numbers.WIDTH))
        .isEqualTo(kind == Variation.Kind.FAR);
    assertThat(Arrays.stream(places).allMatch(p -> 2 * p == Math.rint(2 * p) && p <= 20))
        .isEqualTo(kind == Variation.Kind.SMALL);
    WorldFuzz fuzz = new WorldFuzz();
    fuzz.play(seed);

    assertThat(fuzz.impacts()).isPositive();
  }

  private static double[] places(Scene scene) {
    return IntStream.range(0, scene.count(Kind.CIRCLE))
        .mapToObj(i -> (Circle) scene.shape(Kind.CIRCLE, i))
        .flatMapToDouble(c -> DoubleStream.of(c.x(), c.y()))
        .toArray();
  }

  /**
   * What fuzzing found once. In the first session a heavy circle hops off a light one that is held.
   * In the second a circle that overlaps a wall slides off a line there. In the third a circle that
   * a line crushed, and that held another one, is free again. In 127 one slides into a corner that
   * gravity hardly pulls it to. In 235 squares of impulses leave the range of doubles. In 1,263,
   * 1,519 and 2,611 a heavy circle comes to rest, and its load is left on one of 1e-150 its mass.
   * In 3,151 a ball is in contact for a tick, and then slides on the same parabola. In 285 what
   * holds a calm circle is taken away. In 4,031 something very fast comes to a squeezed circle. In
   * 4,600 a ball that leans on another one rests on a slope, and that one rolls away. In 2,359 an
   * infinite mass meets a heap and loses the line behind it; in 2,821 a ball leans on a sensor; in
   * 3,309 what a ball leans on is moved after a restore. In 6,137 what is squeezed after others
   * were removed goes on otherwise when it is restored. In 60,014 a squeezed circle flies aside as
   * fast as what moves lets it.
   */
  @ParameterizedTest
  @ValueSource(
      longs = {
        110_175, 120_123, 140_018, 127, 235, 1_263, 1_519, 2_611, 3_151, 285, 4_031, 4_600, 2_359,
        2_821, 3_309, 6_137, 60_014
      })
  void whatWasFoundUnderGravityIsFoundNoMore(long seed) throws FindingException {
    WorldFuzz fuzz = new WorldFuzz();
    fuzz.play(seed);

    assertThat(fuzz.impacts()).isPositive();
  }

  /** An infinite mass that passes over a stuck circle stands on its centre when it hits a wall. */
  @Test
  void aRowOfConcentricCirclesHasANormal() throws FindingException {
    WorldFuzz fuzz = new WorldFuzz();
    fuzz.play(12_266);

    assertThat(fuzz.jams()).isPositive();
  }

  /** Trapped circles, a pocket, a heap, and infinite masses. */
  @ParameterizedTest
  @ValueSource(longs = {36, 40, 52, 116})
  void scenesOfTheEndRulePlayWithoutAFinding(long seed) throws FindingException {
    WorldFuzz fuzz = new WorldFuzz();
    fuzz.play(seed);

    assertThat(fuzz.jams()).isPositive();
  }
}
