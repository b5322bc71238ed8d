// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.assertState;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Feature;
import dev.carom.Line;
import dev.carom.Run;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Lines of no length, or hardly any, the same line many times, and lines that cross. */
class DegenerateLinesTest {

  @Test
  void aLineOfNoLengthIsAPoint() {
    Line point = new Line(0, 0, 0, 0);
    assertThat(Naive.sideTime(new Circle(0, 9, 1), new Vec2(0, -1), point))
        .as("0 / 0, so it is not there")
        .isEqualTo(Naive.NEVER);

    World world = world(among(point).circle(0, 9, 1, 0, -1));
    assertThat(advance(world, 16))
        .singleElement()
        .matches(hit -> hit.time() == 8 && hit.feature() == Feature.START);
    assertState(world, 0, 0, 9, 0, 1);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.MIN_VALUE, 1e-310, 1e-200, 1e-17})
  void aLineOfHardlyAnyLengthIsNearlyAPoint(double length) {
    double squared = length * length;
    assertThat(length < 1e-160 ? 1 / squared : Double.POSITIVE_INFINITY)
        .as("what a naive projection divides by")
        .isInfinite();

    World world = world(among(new Line(0, 0, length, 0)).circle(0.6, 9, 1, 0, -1));
    assertThat(advance(world, 16))
        .singleElement()
        .matches(hit -> hit.feature() == Feature.END && Math.abs(hit.time() - 8.2) < 1e-14);
    // The normal is (0.6, 0.8).
    assertThat(world.vx(0)).isCloseTo(0.96, within(1e-14));
    assertThat(world.vy(0)).isCloseTo(0.28, within(1e-14));
  }

  /** Turned round by each of them in turn, an even number of times is not at all. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 10_000})
  void theSameLineManyTimesIsHitOnce(int count) {
    Line[] same = Collections.nCopies(count, new Line(-9, 0, 9, 0)).toArray(new Line[0]);
    World world = world(among(same).circle(0, 9, 1, 0, -1));
    List<Run.Row> hits = advance(world, 16);
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).obstacle()).isZero();
    assertState(world, 0, 0, 9, 0, 1);
  }

  /** The valley between two lines that cross: both sides at once, and back up. */
  @Test
  void crossingLinesAreAValleyOnEachSide() {
    Line rising = new Line(-9, -9, 9, 9);
    Line falling = new Line(-9, 9, 9, -9);
    Naive naive = new Naive(new Circle(0, 6, 1), new Vec2(0, -1), rising, falling);
    naive.oneImpactPerFrame(9);
    assertThat(naive.y).as("has not come back").isLessThan(3);

    for (int turn = 0; turn < 4; turn++) {
      double x = turn % 2 == 0 ? 0 : turn == 1 ? -6 : 6;
      double y = turn % 2 == 1 ? 0 : turn == 0 ? 6 : -6;
      World world = world(among(rising, falling).circle(x, y, 1, -x / 6, -y / 6));
      assertThat(advance(world, 9)).hasSize(2);
      double t = 6 - Math.sqrt(2);
      assertThat(Math.hypot(world.x(0), world.y(0))).isCloseTo(6 + 9 - 2 * t, within(1e-13));
      assertThat(world.vx(0)).isCloseTo(x / 6, within(1e-15));
      assertThat(world.vy(0)).isCloseTo(y / 6, within(1e-15));
    }
  }
}
