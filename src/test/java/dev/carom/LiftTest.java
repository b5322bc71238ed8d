// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Balls that lie on each other give way together to what moves. */
class LiftTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /** Far more than the rounding of a place, which is below 128, and of those around it. */
  private static final double ROUNDING = 0x1p-40;

  /** A stack of balls of radius 0.5 above x = 2; the lowest one touches y = 0. */
  private static SceneBuilder stack(SceneBuilder scene, int balls, double e) {
    for (int i = 0; i < balls; i++) {
      scene.circle(2, 0.5 + i, 0.5, 0, 0).restitution(e);
    }
    return scene;
  }

  private static void play(World world, double end) {
    for (double t = world.now(); t < end; t += 0.25) {
      world.advanceTo(Math.min(end, t + 0.25));
    }
  }

  /** Each ball is above the lift, and above the ball below. */
  private static void assertStacked(World world, int balls, double floor) {
    double below = floor - 0.5;
    for (int i = 0; i < balls; i++) {
      assertThat(world.y(i))
          .as("ball %s at %s", i, world.now())
          .isGreaterThan(below + 1 - ROUNDING);
      below = world.y(i);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "2, 0, 1",
    "2, 0.3, 1",
    "2, 0.8, 1",
    "3, 0, 2",
    "3, 0.5, 0.1",
    "5, 0, 1",
    "5, 0.3, 3"
  })
  void aLiftTakesAStackAlong(int balls, double e, double speed) {
    SceneBuilder scene = Scene.builder().gravity(0, -10).line(0, 0, 4, 0);
    World world = new World(stack(scene.bounds(1.5, -10, 2.5, 100), balls, e).build());
    play(world, 1);
    world.setVelocity(Kind.LINE, 0, 0, speed);
    play(world, 4);
    assertStacked(world, balls, 3 * speed);
    world.setVelocity(Kind.LINE, 0, 0, 0);
    play(world, 6);
    assertStacked(world, balls, 3 * speed);
  }

  /** The log tells of each ball that gave way; at the next tick all have the speed of the lift. */
  @Test
  void eachBallOfAStackHasARow() {
    SceneBuilder scene = Scene.builder().gravity(0, -10).line(0, 0, 4, 0);
    World world = new World(stack(scene.velocity(0, 1), 4, 0).build());
    world.advanceTo(0);
    assertThat(circles(world.impacts())).containsExactlyInAnyOrder(0, 1, 2, 3);
    world.advanceTo(0x1p-6);
    for (int ball = 0; ball < 4; ball++) {
      assertThat(world.vy(ball)).as("ball %s", ball).isGreaterThan(0.99);
    }
  }

  @ParameterizedTest
  @CsvSource({"2, 0", "2, 0.3", "3, 0.5"})
  void aCircleOfInfiniteMassLiftsAStack(int balls, double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -10).bounds(1.5, -10, 2.5, 100);
    stack(scene, balls, e).circle(2, -5, 5, 0, 1).mass(INFINITE).restitution(e);
    World world = new World(scene.build());
    play(world, 3);
    assertStacked(world, balls, 3);
  }

  /** A press stops upon the first of three balls, which have crushed each other. */
  @Test
  void ballsThatAPressCrushedCollideAgainWhenItStops() {
    SceneBuilder scene = Scene.builder().gravity(0, -10).bounds(0, 0, 2.8, 30);
    scene.line(0.01, -1, 0.01, 31).restitution(0.5).velocity(1, 0);
    double[] radii = {0.26838199107459054, 0.29425024364785923, 0.2857621593882945};
    double[] places = {0.46838199107459055, 1.0510142257970405, 1.6510266288331943};
    for (int i = 0; i < 3; i++) {
      scene.circle(places[i], radii[i], radii[i], 0, 0).restitution(0.5);
    }
    World world = new World(scene.build());
    world.advanceTo(1.3799787973590059);
    world.setVelocity(Kind.LINE, 0, 0, 0);
    for (int frame = 0; frame < 60; frame++) {
      world.step(1.0 / 60);
      for (int i = 1; i < 3; i++) {
        double distance = Math.hypot(world.x(i) - world.x(i - 1), world.y(i) - world.y(i - 1));
        assertThat(distance).isGreaterThan(radii[i] + radii[i - 1] - 1e-12);
      }
    }
  }

  /** Without room above, the stack is squeezed. */
  @ParameterizedTest
  @CsvSource({"0", "0.5"})
  void aLiftThatPressesAStackAgainstTheCeilingGoesThrough(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -10).bounds(1.5, -10, 2.5, 5);
    scene.line(0, 0, 4.3, 0).velocity(0, 1);
    World world = new World(stack(scene, 3, e).build());
    play(world, 6);
    assertThat(world.line(0).start().y()).isEqualTo(6);
    for (int i = 0; i < 3; i++) {
      assertThat(world.y(i)).isLessThan(4.5 + ROUNDING);
    }
  }

  /** The circles of which a log has rows. */
  private static Set<Integer> circles(ImpactLog log) {
    Set<Integer> hit = new HashSet<>();
    for (int row = 0; row < log.size(); row++) {
      hit.add(log.circle(row));
      if (log.kind(row) == Kind.CIRCLE) {
        hit.add(log.id(row));
      }
    }
    return hit;
  }
}
