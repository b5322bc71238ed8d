// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Nothing deflects an infinite mass: not another one, not many, not a circle that has no way out.
 * That circle is crushed: it stops, and the infinite masses pass over it.
 */
class InfiniteMassTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private static int count(ImpactLog log, Outcome outcome) {
    int count = 0;
    for (int i = 0; i < log.size(); i++) {
      count += log.outcome(i) == outcome ? 1 : 0;
    }
    return count;
  }

  @Test
  void threeInARowPassThroughEachOther() {
    SceneBuilder scene = Scene.builder().circle(0, 0, 1, 0, 0).mass(INFINITE);
    scene.circle(3, 0, 1, -1, 0).mass(INFINITE).circle(7, 0, 1, -2, 0).mass(INFINITE);
    World world = new World(scene.build());
    world.step(10);
    assertThat(world.impacts().size()).isEqualTo(3);
    assertThat(count(world.impacts(), Outcome.PASSED)).isEqualTo(3);
    assertThat(world.x(0)).isZero();
    assertThat(world.x(1)).isEqualTo(-7);
    assertThat(world.x(2)).isEqualTo(-13);
  }

  /** A press becomes an ordinary circle upon what it has crushed, and comes back from the wall. */
  @Test
  void aPressThatBecomesACircleHitsWhatItCrushed() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 20, 4).circle(1.5, 2, 1, 0, 0);
    World world = new World(scene.circle(10, 2, 1, -1, 0).mass(INFINITE).build());
    world.advanceTo(8);
    assertThat(count(world.impacts(), Outcome.JAMMED)).isPositive();
    world.setTraits(Kind.CIRCLE, 1, world.traits(Kind.CIRCLE, 1).withMass(1));
    world.advanceTo(50);
    int meetings = 0;
    for (int i = 0; i < world.impacts().size(); i++) {
      meetings += world.impacts().kind(i) == Kind.CIRCLE ? 1 : 0;
    }
    assertThat(meetings).isPositive();
  }

  /** Sixteen that overlap are moved as a flipper: each approach is one row, each frame. */
  @Test
  void manyThatOverlapReportEachApproachOnce() {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < 16; i++) {
      scene.circle(0.5 * i, 0, 1, 0, 0).mass(INFINITE);
    }
    World world = new World(scene.build());
    for (int frame = 0; frame < 10; frame++) {
      double turn = frame % 2 == 0 ? 0.1 : -0.1;
      for (int i = 0; i < 16; i++) {
        world.setVelocity(i, -turn * world.y(i), turn * world.x(i));
      }
      world.step(0.1);
      assertThat(world.impacts().size()).isLessThanOrEqualTo(16 * 15 / 2);
      assertThat(count(world.impacts(), Outcome.PASSED)).isEqualTo(world.impacts().size());
      for (int i = 0; i < 16; i++) {
        assertThat(world.vx(i)).isEqualTo(-turn * (world.y(i) - 0.1 * world.vy(i)), within(1e-15));
      }
    }
  }

  /**
   *
   *
   * <pre>
   *   ( door )->   (ball)   <-( door )
   * </pre>
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.3, 0.5, 0.9, 1})
  void twoDoorsThatCloseCrushABall(double e) {
    SceneBuilder scene = Scene.builder().circle(0, 0, 1, 0.3, 0).restitution(e);
    scene.circle(-5, 0, 1, 1, 0).mass(INFINITE).circle(5, 0, 1, -1, 0).mass(INFINITE);
    World world = new World(scene.build());
    world.step(2.5);
    int rows = world.impacts().size();
    world.step(1);
    rows += world.impacts().size();
    assertThat(count(world.impacts(), Outcome.JAMMED)).isPositive();
    assertThat(rows).isLessThan(3_000);
    assertThat(world.x(0)).isCloseTo(0, within(1e-4));
    assertThat(world.vx(0)).isZero();
    assertThat(world.vx(1)).isEqualTo(1);
    assertThat(world.vx(2)).isEqualTo(-1);
    double crushed = world.x(0);
    world.step(10);
    assertThat(count(world.impacts(), Outcome.PASSED)).as("the doors meet each other").isOne();
    assertThat(world.impacts().size()).isOne();
    assertThat(world.x(0)).isEqualTo(crushed);
    assertThat(world.x(1)).isCloseTo(8.5, within(1e-12));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 1})
  void aPistonCrushesABallAtAWall(double e) {
    SceneBuilder scene =
        Scene.builder().bounds(0, 0, 20, 20).circle(15, 10, 1, 0.3, 0).restitution(e);
    World world = new World(scene.circle(5, 10, 1, 1, 0).mass(INFINITE).build());
    world.advanceTo(13);
    assertThat(world.x(0)).isCloseTo(19, within(1e-4));
    assertThat(world.vx(0)).isZero();
    assertThat(world.x(1)).isCloseTo(18, within(1e-12));
    world.advanceTo(16);
    assertThat(world.x(1)).as("back from the wall").isCloseTo(17, within(1e-12));
    assertThat(world.x(0)).isCloseTo(19, within(1e-4));
  }

  /** A crushed circle is hit like one of infinite mass, and moves again once the doors left it. */
  @Test
  void aCrushedCircleStandsUntilTheDoorsHaveLeft() {
    SceneBuilder scene =
        Scene.builder().circle(0, 0, 1, 0, 0).circle(-5, 0, 1, 1, 0).mass(INFINITE);
    scene.circle(5, 0, 1, -1, 0).mass(INFINITE).circle(0, 10, 1, 0, -2).restitution(1);
    World world = new World(scene.build());
    world.advanceTo(4);
    assertThat(world.y(3)).as("before").isEqualTo(2, within(1e-12));
    world.advanceTo(4.5);
    assertThat(world.vy(3)).as("turned round").isEqualTo(2);
    assertThat(world.y(0)).isZero();
    world.setVelocity(3, 0, 0);
    world.advanceTo(9);
    world.setVelocity(3, 0, -2);
    world.advanceTo(10);
    assertThat(world.vy(0)).as("moved").isCloseTo(-2, within(1e-12));
  }

  /** Also if it gets its new velocity at the place and the time at which a flight begins. */
  @Test
  void aCircleMeetsADoorAgainThatCrushedItAndLeft() {
    SceneBuilder scene =
        Scene.builder().circle(0, 0, 1, 0, 0).circle(-5, 0, 1, 1, 0).mass(INFINITE);
    scene.circle(5, 0, 1, -1, 0).mass(INFINITE).circle(0, 99, 1, 0, 0).restitution(1);
    World world = new World(scene.build());
    world.advanceTo(9);
    world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 1));
    world.setPosition(3, -2, 0);
    world.setVelocity(3, 10, 0); // the circle is stuck, so they go on together
    world.advanceTo(9.25);
    assertThat(world.vx(0)).isCloseTo(5, within(1e-12));
    world.advanceTo(10);
    assertThat(world.impacts().id(0)).as("the door that went ahead").isOne();
    assertThat(world.impacts().time(0)).isCloseTo(9.5, within(0.01));
    assertThat(world.impacts().outcome(0)).isEqualTo(Outcome.BOUNCED);
  }

  /** A ball that rides on one door is hit by the other one: it is not crushed while it moves. */
  @Test
  void onlyWhatStandsIsPassedOver() {
    SceneBuilder scene =
        Scene.builder().bounds(-50, 0, 50, 50).circle(0, 1.5, 1, 0, 0).restitution(0);
    scene.circle(-3, 3.5, 2, 0.5, -1).mass(INFINITE).circle(3, 3.5, 2, -2, -0.5).mass(INFINITE);
    World world = new World(scene.build());
    for (int frame = 1; frame <= 400; frame++) {
      world.advanceTo(frame / 100.0);
      double nearest = Double.POSITIVE_INFINITY;
      for (int door = 1; door <= 2; door++) {
        double dx = world.x(0) - world.x(door);
        nearest = Math.min(nearest, Math.hypot(dx, world.y(0) - world.y(door)));
      }
      boolean stands = world.vx(0) == 0 && world.vy(0) == 0;
      assertThat(nearest > 3 - 1e-9 || stands).as("at %s", world.now()).isTrue();
    }
  }

  @Test
  void whoComesLaterPassesOverACrushedCircleToo() {
    SceneBuilder scene =
        Scene.builder().circle(0, 0, 1, 0, 0).circle(-5, 0, 1, 1, 0).mass(INFINITE);
    scene.circle(5, 0, 1, -1, 0).mass(INFINITE).circle(0, 9, 1, 0, -2).mass(INFINITE);
    World world = new World(scene.build());
    world.advanceTo(3);
    world.advanceTo(4);
    assertThat(count(world.impacts(), Outcome.JAMMED)).as("it comes").isPositive();
    assertThat(count(world.impacts(), Outcome.BOUNCED)).isZero();
    assertThat(world.vy(0)).isZero();
    assertThat(world.vy(3)).isEqualTo(-2);
  }

  /** A row between a piston and a wall ends with all of it at rest, and the piston goes on. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aRowIsCrushedToo(double e) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 10);
    for (int i = 0; i < 5; i++) {
      scene.circle(20 + 3 * i, 5, 1, 0, 0).restitution(e);
    }
    World world = new World(scene.circle(2, 5, 1, 1, 0).mass(INFINITE).build());
    world.advanceTo(36);
    assertThat(world.x(5)).isCloseTo(38, within(1e-12));
    for (int i = 0; i < 5; i++) {
      assertThat(world.x(i)).isBetween(20.0, 39 + 1e-12);
    }
  }
}
