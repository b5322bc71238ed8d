// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.box;
import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Edits of a world with gravity in mid-flight, in mid-hop and at rest. */
class GravityEditsTest {

  @Test
  void gravityCanBeTurned() {
    World world = new World(box().circle(50, 1, 1, 0, 0).restitution(0).build());
    rows(world, 5);
    assertThat(world.y(0)).isEqualTo(1);
    world.setGravity(0, 10);
    assertThat(world.gravity()).isEqualTo(new Vec2(0, 10));
    rows(world, 6);
    assertThat(world.y(0)).isEqualTo(6);
    world.setGravity(0, 0);
    rows(world, 7);
    assertThat(world.y(0)).isEqualTo(16);
    assertThat(world.vy(0)).isEqualTo(10);
  }

  /** A peg that has a velocity, but of 0, carries a ball like one that has none. */
  @Test
  void aPegOfVelocity0CarriesABall() {
    World world = onAPeg();
    world.setVelocity(Kind.PEG, 0, 0, 0);
    world.advanceTo(20);
    assertThat(world.isResting(0)).isTrue();
  }

  @Test
  void aLiftThatStoppedCarriesAHeap() {
    SceneBuilder scene = Scene.builder().gravity(0, -10);
    scene.line(0, 0, 0, 20).line(5, 0, 5, 20).line(-1, 1, 6, 1).velocity(0, 0.5);
    scene.circle(1.5, 3, 1, 0, 0).restitution(0.5).circle(3.5, 4, 1, 0, 0).restitution(0.5);
    scene.circle(2.6, 7, 1, 0, 0).restitution(0.5);
    World world = new World(scene.build());
    world.advanceTo(2);
    world.setVelocity(Kind.LINE, 2, 0, 0);
    world.advanceTo(60);
    assertThat(IntStream.range(0, 3)).allMatch(world::isResting);
    world.setVelocity(Kind.LINE, 2, 0, 0.5);
    assertThat(IntStream.range(0, 3)).noneMatch(world::isResting);
  }

  /** The slope of the lift presses the ball against a wall, along which it goes up. */
  @Test
  void aLiftWithASlopeCarriesABallAlongAWall() {
    SceneBuilder scene = Scene.builder().gravity(0, -10).line(0, -50, 0, 50);
    scene.line(-2, -1, 10, 5).velocity(0, 0.5).circle(3, 6, 1, 0, 0).restitution(0.5);
    World world = new World(scene.build());
    world.advanceTo(8);
    double y = world.y(0);
    assertThat(world.x(0)).isBetween(1.0, 1 + 0x1p-7);
    world.advanceTo(20);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.y(0)).isCloseTo(y + 6, within(1e-9));
    world.setVelocity(Kind.LINE, 1, 0, 0);
    world.advanceTo(30);
    assertThat(world.isResting(0)).isTrue();
    assertThat(world.y(0)).isCloseTo(y + 6, within(1e-9));
  }

  private static World onAPeg() {
    SceneBuilder scene = Scene.builder().gravity(0, -10).peg(0, 0, 1);
    return new World(scene.circle(0, 2, 1, 0, 0).restitution(0.5).build());
  }

  @Test
  void aSupportThatGoesLetsTheBallFall() {
    SceneBuilder scene = Scene.builder().gravity(0, -10).line(0, 0, 20, 0);
    World world = new World(scene.circle(10, 1, 1, 0, 0).restitution(0).build());
    rows(world, 5);
    assertThat(world.y(0)).isEqualTo(1);
    world.remove(Kind.LINE, 0);
    rows(world, 6);
    assertThat(world.y(0)).isEqualTo(-4);
  }

  /** The new flight begins in mid-air: the floor that was hit last is not touched there. */
  @Test
  void anObstacleThatAppearsInTheWayOfAHopLeavesTheReturnAsItIs() {
    World world = new World(box().circle(50, 6, 1, 0, 0).build());
    rows(world, 1.25); // it touches the floor at 1
    world.addPeg(50, 8, 1, Traits.DEFAULT);
    rows(world, 2.75); // it touches the peg at 2, at its apex: a graze
    assertThat(world.y(0)).isLessThan(6);
    assertThat(world.y(0)).isEqualTo(6 - 5 * 0.75 * 0.75);
  }

  @Test
  void aBallThatShrinksInAHopReturnsLater() {
    World world = new World(box().circle(50, 7, 2, 0, 0).build());
    rows(world, 2); // at its apex
    world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 1));
    rows(world, 3.0625);
    assertThat(world.y(0)).isEqualTo(7 - 5 * 1.0625 * 1.0625);
  }

  /** One has landed on the other, which rested. They fall alike, and do not meet again. */
  @Test
  void twoBallsOnEachOtherFallTogether() {
    SceneBuilder setup = Scene.builder().gravity(0, -10);
    setup.line(0, 0, 20, 0).restitution(0).circle(10, 1, 1, 0, 0).circle(10, 8, 1, 0, 0);
    World world = new World(setup.build());
    rows(world, 2.5);
    double apart = world.y(1) - world.y(0);
    world.remove(Kind.LINE, 0);
    assertThat(rows(world, 10)).isZero();
    assertThat(world.y(0)).isLessThan(-250);
    assertThat(world.y(1) - world.y(0)).isCloseTo(apart, within(0x1p-6));
  }

  @Test
  void collidingBallsBeginToFall() {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 100);
    for (int i = 0; i < 9; i++) {
      builder.circle(10 + 9 * i, 40 + 5 * i, 3, i - 4, 0);
    }
    World world = new World(builder.build());
    World other = new World(builder.gravity(0, -10).build());
    world.setGravity(0, -10);
    assertThat(rows(world, 20)).isEqualTo(rows(other, 20));
    assertThat(world.snapshot()).isEqualTo(other.snapshot());
  }

  private static final int EDITS = 400;

  /** A ball moves along a line, which is set anew in each frame, and neither feels it. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 1})
  void aLineThatIsEditedInEachFrameLetsABallSlideOnIt(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -10).line(0, 10, 1000, 10);
    World world = new World(scene.circle(40, 12, 2, 4, 0).restitution(e).build());
    for (int frame = 1; frame <= EDITS; frame++) {
      world.setVelocity(Kind.LINE, 0, Math.sin(frame), 0);
      world.advanceTo(frame / 60.0);
    }
    assertThat(world.x(0)).isCloseTo(40 + 4 * EDITS / 60.0, within(1e-10));
    assertThat(world.y(0)).isCloseTo(12, within(1e-12));
  }

  /** As a game steers a lift: by its velocity, in each frame. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 1})
  void aLiftThatIsSetInEachFrameCarriesABall(double e) {
    SceneBuilder scene = Scene.builder().gravity(0, -10).line(0, 10, 1000, 10);
    World world = new World(scene.circle(40, 12, 2, 0, 3).restitution(e).build());
    for (int frame = 1; frame <= EDITS; frame++) {
      world.setVelocity(Kind.LINE, 0, 0, 3);
      world.advanceTo(frame / 60.0);
    }
    assertThat(world.y(0)).isCloseTo(12 + 3 * EDITS / 60.0, within(1e-10));
  }

  /** The ball that rests on it begins to fall, and searches, before the floor moves. */
  @Test
  void aFloorThatBeginsToMoveIsNoLongerWhereItWas() {
    SceneBuilder scene = Scene.builder().gravity(0, -1).line(-10, 0, 10, 0);
    for (int i = 0; i < 20; i++) { // so many that there is a grid
      scene.line(10 * i, -50, 10 * i + 5, -50);
    }
    World world = new World(scene.circle(0, 1, 1, 0, 0).restitution(0).build());
    world.step(1);
    assertThat(world.isResting(0)).isTrue();
    world.setVelocity(Kind.LINE, 0, 100, 0);
    world.setGravity(0, 0);
    world.setVelocity(0, 0, 0);
    world.step(10);
    world.setVelocity(0, 0, -1);
    world.step(10);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.y(0)).isCloseTo(-9, within(1e-12));
  }
}
