// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles without room, which hit obstacles and each other many times at one time, or nearly. */
class ImpactsAtOneTimeTest {

  /**
   * A ball hits two touching ones at one moment: first the one of the lower id, by an impulse along
   * (sqrt(3) / 2, y / 2), then the other one with what is left.
   */
  @ParameterizedTest
  @ValueSource(ints = {1, -1})
  void aBallHitsTwoInTheOrderOfTheirIds(int y) {
    SceneBuilder scene = Scene.builder();
    scene.circle(-5, 0, 1, 1, 0).circle(0, y, 1, 0, 0).circle(0, -y, 1, 0, 0);
    World world = new World(scene.build());
    assertReaches(world, 10);
    double part = Math.sqrt(3) / 8;
    double[] expected = {-1 / 8.0, -y * part, 3 / 4.0, 2 * y * part, 3 / 8.0, -y * part};
    for (int i = 0; i < 3; i++) {
      assertThat(world.vx(i)).isCloseTo(expected[2 * i], within(1e-15));
      assertThat(world.vy(i)).isCloseTo(expected[2 * i + 1], within(1e-15));
    }
  }

  /** Two lines press a ball down upon one that halts, and nothing holds that one. */
  @Test
  void twoCirclesThatHaltFallTogether() {
    SceneBuilder scene = Scene.builder().gravity(0, -10);
    scene.line(-10, -3, 10, 4).line(-10, 6, 10, -3);
    scene.circle(0, 0, 2, 2, 0).circle(0.25, -0.75, 1, 0, 0).response(Response.HALT);
    World world = new World(scene.build());
    world.advanceTo(2);
    assertThat(world.y(0)).isLessThan(-19);
    assertThat(world.y(1)).isLessThan(world.y(0));
    assertThat(world.impacts().size()).isLessThan(100);
    assertThat(world.impacts().outcome(1)).isEqualTo(Outcome.HALTED);
  }

  /** Each of two elastic balls overlaps two obstacles, and the other ball. */
  @ParameterizedTest
  @ValueSource(doubles = {0, -1, -10})
  void twoElasticCirclesThatOverlapObstaclesJam(double g) {
    SceneBuilder scene = Scene.builder().gravity(0, g);
    scene.line(1, 4, -3, -2).line(4, 4, 3, 6).peg(0, -2, 1);
    scene.circle(2.5, 3, 2, -2, 2).circle(0, 0, 2, 1, 2);
    World world = new World(scene.build());
    assertReaches(world, 2);
    assertThat(world.vx(0)).isZero();
    assertThat(world.vy(0)).isZero();
    assertThat(world.x(0)).isEqualTo(2.5);
    assertThat(world.y(1)).isZero();
  }

  /** A ball on the floor of a box, and two that overlap between it, the walls and the ceiling. */
  @Test
  void elasticCirclesThatJamEachOtherDoNotFreeEachOtherForEver() {
    SceneBuilder scene = Scene.builder().gravity(0, -10).bounds(-3, -3, 3, 3);
    scene.circle(0, 0, 2, 0, -2).circle(0, 3, 2, 2, 0).circle(0, 3, 2, -2, -1);
    assertReaches(new World(scene.build()), 2);
  }

  /** The lower one rests, the upper one falls beside it, until both have the same height. */
  @Test
  void twoBallsInAShaftOfTheirWidthComeToAnEnd() {
    SceneBuilder scene = Scene.builder().gravity(0, -10);
    scene.bounds(0, 0, 2, 10).restitution(0.9);
    scene.circle(0.5, 0.5, 0.5, 0, 0).restitution(0.9).circle(0.75, 1.75, 0.5, 0, 0);
    World world = new World(scene.restitution(0.9).build());
    assertReaches(world, 2);
    assertThat(world.y(0)).isBetween(0.5, 0.6);
    assertThat(world.y(1)).isBetween(0.5, 0.6);
  }

  /** A ball in a corner makes many impacts without bounce while another one bounces on it. */
  @Test
  void blowsOfAnotherCircleDoNotMakeACircleInACornerStuck() {
    SceneBuilder scene = Scene.builder().gravity(0, -10);
    scene.bounds(0, 0, 10, 10).restitution(0);
    scene.circle(1, 1, 1, 0, 0).circle(1.5, 5, 1, 0, 0).restitution(0.9);
    World world = new World(scene.build());
    while (world.now() < 2) {
      world.step(1.0 / 64);
      ImpactLog log = world.impacts();
      for (int row = 0; row < log.size(); row++) {
        assertThat(log.outcome(row)).isNotEqualTo(Outcome.JAMMED);
      }
    }
  }

  /** The light ball is pressed between them, and makes few impacts. */
  @Test
  void heavyBallsRollOnWithALightOneBetweenThem() {
    SceneBuilder scene = Scene.builder().gravity(0, -10).bounds(0, 0, 8, 30);
    scene.restitution(0.5).circle(2, 0.3, 0.3, 1, 0).restitution(0).mass(1000);
    scene.circle(2.601, 0.3, 0.3, 0, 0).restitution(0).mass(0.1);
    World world = new World(scene.circle(3.2, 0.28, 0.28, 0, 0).restitution(0).mass(100).build());
    world.advanceTo(1);
    assertThat(world.impacts().size()).isLessThan(5_000);
    double momentum = 1000 * world.vx(0) + 0.1 * world.vx(1) + 100 * world.vx(2);
    assertThat(momentum).isCloseTo(1000, within(1e-9));
    assertThat(world.vx(2)).isGreaterThan(0.5);
  }

  private static void assertReaches(World world, double time) {
    boolean reached = false;
    for (int call = 0; call < 5 && !reached; call++) {
      reached = world.advanceTo(time, Run.WORK);
    }
    assertThat(reached).isTrue();
  }
}
