// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.assertState;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Run;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A circle in a corner, in touch with both lines: no jitter. More of it: RestTest. */
class RestingTest {

  private static final Line FLOOR = new Line(0, 0, 10, 0);
  private static final Line WALL = new Line(0, 0, 0, 10);

  private static SceneBuilder corner(double vx, double vy) {
    return Play.among(FLOOR, WALL).circle(2, 2, 2, vx, vy);
  }

  /** In a narrower corner, gravity and push take turns: the naive circle never lies still. */
  @Test
  void restingAgainstTwoLinesNothingHappens() {
    Line slope = new Line(0, 0, 10, 5);
    Line other = new Line(0, 0, 5, 10);
    Naive naive = new Naive(new Circle(4, 4, 1), new Vec2(0, 0), slope, other);
    int moved = 0;
    for (int frame = 0; frame < 200; frame++) {
      double y = naive.y;
      naive.vx -= 0.01;
      naive.vy -= 0.01;
      naive.pushOut(1, 0);
      moved += frame >= 100 && naive.y != y ? 1 : 0;
    }
    assertThat(moved).as("frames in which it trembles").isPositive();

    World world = world(corner(0, 0));
    assertThat(advance(world, 1e6)).isEmpty();
    assertState(world, 0, 2, 2, 0, 0);
  }

  /** Gravity into the corner: two impacts a frame, and not a bit of motion. */
  @Test
  void pressedIntoTheCornerEachFrameItStays() {
    World world =
        world(
            Play.among()
                .line(0, 0, 10, 0)
                .restitution(0)
                .line(0, 0, 0, 10)
                .restitution(0)
                .circle(2, 2, 2, 0, 0));
    for (int frame = 1; frame <= 1000; frame++) {
      world.setVelocity(0, world.vx(0) - 0.01, world.vy(0) - 0.01);
      assertThat(advance(world, frame)).hasSize(2);
      assertState(world, 0, 2, 2, 0, 0);
    }
  }

  @ParameterizedTest
  @CsvSource({"1,0", "0,1", "1,1"})
  void leavingTwoLinesAlongOneOfThemNothingHappens(double vx, double vy) {
    World world = world(corner(vx, vy));
    assertThat(advance(world, 5)).isEmpty();
    assertState(world, 0, 2 + 5 * vx, 2 + 5 * vy, vx, vy);
  }

  @Test
  void movingIntoOneOfTwoTouchedLinesTurnsRoundNow() {
    World world = world(corner(-1, 0));
    List<Run.Row> hits = advance(world, 5);
    assertThat(hits).extracting(Run.Row::obstacle).containsExactly(1);
    assertThat(hits.get(0).time()).isZero();
    assertState(world, 0, 7, 2, 1, 0);
  }

  @Test
  void movingIntoBothOfTwoTouchedLinesTurnsRoundNow() {
    World world = world(corner(-1, -2));
    List<Run.Row> hits = advance(world, 3);
    assertThat(hits).extracting(Run.Row::obstacle).containsExactly(0, 1);
    assertThat(hits).extracting(Run.Row::time).containsOnly(0.0);
    assertState(world, 0, 5, 8, 1, 2);
  }
}
