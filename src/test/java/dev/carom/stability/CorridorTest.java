// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Run;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A corridor as wide as the circle, an ulp more, an ulp less. More of it: EndsTest.
 *
 * <pre>
 *   =================
 *       ( o )  ->
 *   =================
 * </pre>
 */
class CorridorTest {

  private static final double WIDTH = 4;

  private static World corridor(double width, double vy) {
    return world(
        among(new Line(-100, 0, 100, 0), new Line(-100, width, 100, width)).circle(0, 2, 2, 1, vy));
  }

  /** Ends of the corridor's lines are not hit on the way along it, nor are its sides. */
  @ParameterizedTest
  @ValueSource(ints = {-1, 0, 1})
  void alongItNothingIsHit(int ulps) {
    World world = corridor(WIDTH + ulps * Math.ulp(WIDTH), 0);
    assertThat(Play.advance(world, 50)).isEmpty();
    Play.assertState(world, 0, 50, 2, 1, 0);
  }

  /** It has no room to move across: it slides, when its patience is over, without energy gained. */
  @Test
  void exactlyAsWideItIsSlidThrough() {
    Naive naive =
        new Naive(
            new Circle(0, 2, 2),
            new Vec2(1, 0.5),
            new Line(-100, 0, 100, 0),
            new Line(-100, WIDTH, 100, WIDTH));
    naive.impactsPerFrame(50, 100_000);
    assertThat(Math.abs(naive.y - 2)).as("the naive circle leaves through a side").isGreaterThan(2);

    World world = corridor(WIDTH, 0.5);
    List<Run.Row> hits = Play.advance(world, 50);
    assertThat(hits).allMatch(hit -> hit.time() == 0).hasSizeBetween(1_010, 2_030);
    Play.assertState(world, 0, 50, 2, 1, 0);
  }

  /** Overlapping both from the start, it can only leave: towards neither, so along. */
  @Test
  void oneUlpNarrowerItIsSlidThrough() {
    World world = corridor(Math.nextDown(WIDTH), 0.5);
    List<Run.Row> hits = Play.advance(world, 50);
    assertThat(hits).hasSizeBetween(1_010, 3_000);
    assertThat(world.x(0)).isCloseTo(50, within(1e-12));
    assertThat(world.y(0)).isCloseTo(2, within(1e-15));
    assertThat(world.vy(0)).isCloseTo(0, within(1e-15));
  }

  /** An ulp wider, each crossing takes 2e-15: it would make 5e16 impacts, and slides, too. */
  @Test
  void oneUlpWiderItIsSlidThrough() {
    World world = corridor(Math.nextUp(WIDTH), 0.5);
    List<Run.Row> hits = Play.advance(world, 50);
    assertThat(hits).hasSizeBetween(1_010, 2_030);
    assertThat(world.x(0)).isCloseTo(50, within(1e-12));
    assertThat(world.y(0)).isCloseTo(2, within(2 * Math.ulp(WIDTH)));
  }
}
