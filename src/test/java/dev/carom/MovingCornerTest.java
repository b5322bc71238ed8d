// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Balls between two things, of which one moves. */
class MovingCornerTest {

  /** How far a contact may hover where something moves, in radii, which are 1. */
  private static final double HOPS = 0x1p-7;

  /** A ball of radius 1 falls into a V; its left side is at rest, and its right side moves. */
  private static World playedUntil(double end, double u, double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -1).line(-10, 10, 0, 0).restitution(e);
    scene.line(0, 0, 10, 10).restitution(e).velocity(u, 0).circle(0, 1.5, 1, 0, 0);
    World world = new World(scene.build());
    world.advanceTo(end);
    return world;
  }

  /** The ball touches both sides as they part or close. */
  @ParameterizedTest
  @CsvSource({"0.5, 2", "0.125, 6", "-0.125, 20", "-0.5, 9"})
  void theBallStaysInTheCorner(double u, double end) {
    World world = playedUntil(end, u, 0);
    assertThat(world.x(0)).isCloseTo(u * end / 2, within(HOPS));
    assertThat(world.y(0)).isCloseTo(Math.sqrt(2) - u * end / 2, within(HOPS));
  }

  @ParameterizedTest
  @CsvSource({"0.5, 0", "0.5, 0.25", "0.5, 0.5", "0.125, 0", "0.125, 0.5"})
  void theBallFallsThroughTheGap(double u, double e) {
    assertThat(playedUntil(40, u, e).y(0)).isLessThan(-100);
  }

  /** The hops off a side that moves take a bounded number of rows. */
  @Test
  void theBallMakesFewHops() {
    World world = playedUntil(10, -0.125, 0);
    world.advanceTo(11);
    assertThat(world.impacts().size()).isLessThan(100);
  }

  private static SceneBuilder lifting(String what, double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -1).bounds(0, -100, 100, 100);
    scene.circle(1, 1.5, 1, 0, 0).restitution(e);
    return switch (what) {
      case "peg" -> scene.peg(1.6, -1, 0.5).velocity(0, 0.25).restitution(e);
      case "end of a line" -> scene.line(1.6, -1, 10, -4).velocity(0, 0.25).restitution(e);
      default -> scene.collide(true).circle(1.6, -1, 0.5, 0, 0.25).mass(Double.POSITIVE_INFINITY);
    };
  }

  /** The ball lies on what rises beside a wall, and touches the wall. */
  @ParameterizedTest
  @CsvSource({
    "peg, 0",
    "peg, 0.5",
    "end of a line, 0",
    "end of a line, 0.5",
    "infinite mass, 0",
    "infinite mass, 0.25"
  })
  void whatIsRoundLiftsABallAlongAWall(String what, double e) {
    World world = new World(lifting(what, e).build());
    for (int t = 10; t <= 40; t += 5) {
      world.advanceTo(t);
      double reach = what.startsWith("end") ? 1 : 1.5;
      double above = Math.sqrt(reach * reach - 0.6 * 0.6);
      assertThat(world.x(0)).isCloseTo(1, within(HOPS));
      assertThat(world.y(0)).isCloseTo(-1 + 0.25 * t + above, within(HOPS));
    }
  }

  /** A peg rises between a slope and a ball, until the ball is no longer held and falls. */
  @ParameterizedTest
  @CsvSource({"0", "0.5", "0.9"})
  void aPegThatRisesPastABallLetsItFall(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -1).line(-50, 100, 0, 0);
    scene.peg(1.6, -1, 0.5).velocity(0, 0.25).restitution(e).circle(1, 1.5, 1, 0, 0);
    World world = new World(scene.restitution(e).build());
    world.advanceTo(40);
    assertThat(world.y(0)).isLessThan(-100);
  }

  /** A ball that nothing lets out is squeezed, as before. */
  @ParameterizedTest
  @CsvSource({"0", "0.5", "0.9"})
  void aPressJamsABallInAV(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -1).line(-10, 10, 0, 0).line(0, 0, 10, 10);
    scene.line(-10, 10, 10, 10).velocity(0, -0.25).restitution(e).circle(0, 3, 1, 0, 0);
    World world = new World(scene.restitution(e).build());
    world.advanceTo(60);
    assertThat(world.isResting(0)).isTrue();
    assertThat(world.y(0)).isCloseTo(Math.sqrt(2), within(HOPS));
  }

  /**
   * Gravity presses the ball on neither the wall nor the line that pushes it down along it. If the
   * ball left them by less than rounding, it would hit them without end.
   */
  @ParameterizedTest
  @CsvSource({"1e-6", "1e-9", "1e-12", "1e-30"})
  void aLineThatPushesABallDownAWallMakesFewRows(double g) {
    Random random = new Random(1);
    for (int i = 0; i < 200; i++) {
      SceneBuilder scene = Scene.builder().bounds(0, -100, 10, 100).gravity(0, -g);
      scene.line(-10, -4, 30, 10 + 30 * random.nextDouble()).restitution(0.25);
      scene.velocity(1e-8 * random.nextDouble(), -0.1 - random.nextDouble()).circle(9, 0, 1, 0, 0);
      World world = new World(scene.restitution(0.25).build());
      int rows = 0;
      for (int t = 1; t <= 60; t++) {
        world.advanceTo(t);
        rows += world.impacts().size();
      }
      assertThat(rows).isLessThan(1000);
    }
  }
}
