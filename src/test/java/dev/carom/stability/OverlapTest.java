// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.assertState;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Started inside of something, or of several things: let out, never in, and never moved. */
class OverlapTest {

  private static final Line FLOOR = new Line(-10, 0, 10, 0);

  /** "No root above 0 means never" lets it through; a push moves it into the roof. */
  @Test
  void overlappingAndApproachingTurnsRoundNow() {
    Naive naive = new Naive(new Circle(0, 0.5, 1), new Vec2(0, -1), FLOOR);
    naive.impactsPerFrame(4, 10);
    assertThat(naive.y).as("falls through").isNegative();
    Naive pushed =
        new Naive(new Circle(0, 0.5, 1), new Vec2(0, 0), FLOOR, new Line(-10, 1.2, 10, 1.2));
    pushed.pushOut(0, 1);
    assertThat(pushed.y).as("is moved").isNotEqualTo(0.5);

    World world = world(among(FLOOR).circle(0, 0.5, 1, 0, -1));
    assertThat(advance(world, 4)).singleElement().matches(hit -> hit.time() == 0);
    assertState(world, 0, 0, 4.5, 0, 1);
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "1, 0", "0, 0", "3, 1e-300"})
  void overlappingAndNotApproachingIsLetGo(double vx, double vy) {
    World world = world(among(FLOOR).circle(0, 0.5, 1, vx, vy));
    assertThat(advance(world, 1)).isEmpty();
    assertState(world, 0, vx, 0.5 + vy, vx, vy);
  }

  /** A centre exactly on a line cannot come nearer to it, whichever way it leaves. */
  @ParameterizedTest
  @CsvSource({"0, 1", "0, -1", "1, 1"})
  void aCentreOnALineLeavesIt(double vx, double vy) {
    World world = world(among(FLOOR).circle(0, 0, 1, vx, vy));
    assertThat(advance(world, 3)).isEmpty();
    assertState(world, 0, 3 * vx, 3 * vy, vx, vy);
  }

  /** Lines on all sides overlap it: it is turned round by some, and then leaves them all. */
  @Test
  void overlappingSeveralItGetsOut() {
    SceneBuilder builder = Scene.builder();
    for (int i = 0; i < 12; i++) {
      double angle = i * Math.PI / 6;
      double x = 0.5 * Math.cos(angle);
      double y = 0.5 * Math.sin(angle);
      builder.line(x - y, y + x, x + y, y - x);
    }
    World world = world(builder.circle(0.1, 0.05, 1, 3, 1));
    int impacts = Play.finish(world, 100, 5).size();
    assertThat(impacts).isPositive();
    assertThat(world.x(0)).isFinite();
    assertThat(Play.speed(world, 0)).isLessThanOrEqualTo(Math.hypot(3, 1) * (1 + 1e-12));
  }

  /** Inside of a peg, and of a circle. */
  @Test
  void insideOfAPegItGoesOutOnly() {
    World out = world(Scene.builder().peg(0, 0, 10).circle(3, 0, 1, 1, 0));
    assertThat(advance(out, 20)).isEmpty();
    World in = world(Scene.builder().peg(0, 0, 10).circle(3, 0, 1, -1, 0));
    assertThat(advance(in, 20)).singleElement().matches(hit -> hit.time() == 0);
    assertState(in, 0, 23, 0, 1, 0);

    World pair = world(Scene.builder().circle(0, 0, 9, 0, 0).circle(3, 0, 1, -1, 0));
    assertThat(advance(pair, 20)).singleElement().matches(hit -> hit.time() == 0);
    assertState(pair, 0, -20, 0, -1, 0);
    assertState(pair, 1, 3, 0, 0, 0);
  }

  /** Outside of the bounds: walls are half-planes, and let it come in. */
  @Test
  void outsideOfTheBoundsItComesIn() {
    World world = world(Scene.builder().bounds(0, 0, 10, 10).circle(-5, 5, 1, -1, 0));
    assertThat(advance(world, 7)).singleElement().matches(hit -> hit.time() == 0);
    assertState(world, 0, 2, 5, 1, 0);
  }
}
