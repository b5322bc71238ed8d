// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.experiment.Crosses;
import org.junit.jupiter.api.Test;

class PlayerTest {

  /** Hits the right wall at 5, the left one at 15, and so on. */
  private static final Scene TO_AND_FRO =
      Scene.builder()
          .collide(false)
          .bounds(0, 0, 100, 60)
          .line(20, 10, 60, 10)
          .circle(50, 30, 10, 8, 0)
          .build();

  private final Player player = new Player(TO_AND_FRO, 1);

  private void run(int ticks) {
    player.setRunning(true);
    for (int i = 0; i < ticks; i++) {
      player.tick();
    }
  }

  private double x() {
    return ((Circle) player.scene().shape(Kind.CIRCLE, 0)).x();
  }

  @Test
  void standsStillUntilItRuns() {
    player.tick();
    assertThat(player.shown()).isZero();
    player.setSpeed(2);
    run(2);
    assertThat(player.shown()).isEqualTo(4);
    assertThat(x()).isEqualTo(82);
    player.setRunning(false);
    player.tick();
    assertThat(player.shown()).isEqualTo(4);
    player.stepFrame();
    assertThat(player.shown()).isEqualTo(5);
  }

  @Test
  void goesFromImpactToImpact() {
    assertThat(player.nextImpact()).isTrue();
    assertThat(player.shown()).isEqualTo(5);
    assertThat(player.impacts()).isEqualTo(1);
    assertThat(player.nextImpact()).isTrue();
    assertThat(player.shown()).isEqualTo(15);
    assertThat(player.marks(1, 9)).containsExactly(new Mark(15, 0, 0, 30, 1, 0));
    player.seek(2);
    assertThat(player.nextImpact()).as("a recorded one").isTrue();
    assertThat(player.shown()).isEqualTo(5);
    assertThat(player.impacts()).isEqualTo(1);
  }

  @Test
  void goesThroughAllImpactsOfTheExperimentOneByOne() throws Exception {
    Scene scene = Crosses.canonical(1).scene();
    Player each = new Player(scene, 1);
    World world = new World(scene);
    world.advanceTo(20);
    for (int i = 0; i < world.impacts().size(); i++) {
      assertThat(each.nextImpact()).isTrue();
      assertThat(each.impacts()).isEqualTo(i + 1);
      assertThat(each.shown()).isCloseTo(world.impacts().time(i), offset(1e-14));
    }
  }

  @Test
  void showsThePastAndReplaysIt() {
    run(20);
    double end = x();
    player.seek(7.5);
    assertThat(player.isRunning()).isFalse();
    assertThat(x()).isEqualTo(70);
    player.seek(-3);
    assertThat(player.shown()).isZero();
    player.seek(99);
    assertThat(player.shown()).isEqualTo(20);
    player.seek(10);
    run(10);
    assertThat(x()).isEqualTo(end);
    assertThat(player.impacts()).as("counted once").isEqualTo(2);
  }

  @Test
  void anEditInThePastBeginsAnotherFutureThere() {
    run(20);
    player.seek(7);
    player.moveCircle(0, 40, 31);
    assertThat(player.end()).isEqualTo(7);
    assertThat(player.scene().shape(Kind.CIRCLE, 0)).isEqualTo(new Circle(40, 31, 10));
    assertThat(player.scene().velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(-8, 0));
    assertThat(player.impacts()).as("those before").isEqualTo(1);
    run(8);
    assertThat(player.end()).isEqualTo(15);
    assertThat(player.impacts()).isEqualTo(2);
    player.seek(9);
    assertThat(x()).isEqualTo(40 - 2 * 8);
    assertThat(player.impacts()).isEqualTo(1);
    player.restart();
    assertThat(player.scene()).isEqualTo(TO_AND_FRO);
  }

  /** A piston that leaves the circle behind, seen at rest, live, in the past, and taken hold of. */
  @Test
  void obstaclesThatMoveAreShownWhereTheyAre() {
    Scene scene = Scene.builder().line(0, 0, 0, 20).velocity(3, 0).circle(50, 10, 2, 0, 0).build();
    Player moving = new Player(scene, 1);
    moving.setRunning(true);
    for (int i = 0; i < 20; i++) {
      moving.tick();
    }
    assertThat(moving.scene().shape(Kind.LINE, 0)).isEqualTo(new Line(60, 0, 60, 20));
    assertThat(moving.scene().velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(6, 0));
    moving.seek(4);
    assertThat(moving.scene().shape(Kind.LINE, 0)).isEqualTo(new Line(12, 0, 12, 20));
    assertThat(Grip.at(moving, new Vec2(12, 10), 1).kind()).isEqualTo(Kind.LINE);
    moving.moveLine(0, new Line(22, 0, 22, 20));
    moving.stepFrame();
    assertThat(moving.scene().shape(Kind.LINE, 0)).isEqualTo(new Line(25, 0, 25, 20));
  }

  /** The future that was is dropped with its removals and jumps, and ids stay. */
  @Test
  void aFutureThatWasDroppedLeavesNoTrace() {
    player.addCircle(70, 50, 5, 0, 0);
    player.addPeg(20, 50, 2);
    run(4);
    player.remove(Kind.CIRCLE, 0);
    player.moveCircle(1, 71, 50);
    run(4);
    player.seek(2);
    player.movePeg(0, 21, 50);
    assertThat(player.circleIds()).containsExactly(0, 1);
    assertThat(player.scene().shape(Kind.PEG, 0)).isEqualTo(new Circle(21, 50, 2));
    run(4);
    assertThat(player.end()).isEqualTo(6);
    assertThat(player.lastJump(1)).isEqualTo(Double.NEGATIVE_INFINITY);
    assertThat(player.look().x(1)).isEqualTo(70);
    player.seek(3);
    player.remove(Kind.CIRCLE, 0);
    player.seek(3);
    assertThat(player.circleIds()).containsExactly(1);
  }

  /** Grips take the ids of the world: circle 0 is gone at the moment that is shown. */
  @Test
  void aLookIntoThePastKeepsIds() {
    player.addCircle(70, 50, 5, 0, 0);
    player.remove(Kind.CIRCLE, 0);
    run(4);
    player.seek(2);
    Grip grip = Grip.at(player, new Vec2(70, 50), 2);
    assertThat(grip.id()).isEqualTo(1);
    grip.drag(new Vec2(72, 50), 0);
    assertThat(player.look().x(1)).isEqualTo(72);
    assertThat(player.end()).isEqualTo(2);
  }

  @Test
  void takesHoldOfCirclesLinesAndEnds() {
    assertThat(Grip.at(player, new Vec2(5, 50), 2)).isNull();
    Grip.at(player, new Vec2(55, 35), 2).drag(new Vec2(56, 36), 0);
    assertThat(player.scene().shape(Kind.CIRCLE, 0)).isEqualTo(new Circle(51, 31, 10));
    Grip.at(player, new Vec2(40, 11), 2).drag(new Vec2(41, 16), 0);
    assertThat(player.scene().shape(Kind.LINE, 0)).isEqualTo(new Line(21, 15, 61, 15));
    Grip.at(player, new Vec2(60.5, 15), 2).drag(new Vec2(60.5, 20), 0);
    assertThat(player.scene().shape(Kind.LINE, 0)).isEqualTo(new Line(21, 15, 61, 20));
    Grip.at(player, new Vec2(21, 15), 2).drag(new Vec2(20, 15), 0);
    assertThat(player.scene().shape(Kind.LINE, 0)).isEqualTo(new Line(20, 15, 61, 20));
  }

  @Test
  void aClickInThePastDropsNothing() {
    run(20);
    player.seek(7);
    Grip.at(player, new Vec2(74, 30), 2);
    assertThat(player.end()).isEqualTo(20);
  }

  @Test
  void countsTheImpactsUpToTheMomentShown() {
    run(20);
    assertThat(player.impacts()).isEqualTo(2);
    player.seek(14.9);
    assertThat(player.impacts()).isEqualTo(1);
    player.seek(4.9);
    assertThat(player.impacts()).isZero();
    player.seek(20);
    assertThat(player.impacts()).isEqualTo(2);
  }

  @Test
  void showsAtMostSoManyNormalsTheNewest() {
    run(100);
    assertThat(player.marks(100, 3)).extracting(Mark::time).containsExactly(75.0, 85.0, 95.0);
    assertThat(player.marks(12, 3)).extracting(Mark::time).containsExactly(95.0);
  }

  @Test
  void aSceneThatIsRefusedLeavesTheOldOne() {
    run(3);
    assertThatThrownBy(() -> player.load(null)).isInstanceOf(RuntimeException.class);
    assertThat(player.shown()).isEqualTo(3);
    player.restart();
    assertThat(player.scene()).isEqualTo(TO_AND_FRO);
  }

  @Test
  void aCircleThatIsLetGoOfWhileItMovesIsThrown() {
    long tick = 1_000_000_000 / 60;
    Grip grip = Grip.at(player, new Vec2(50, 30), 2);
    for (int i = 0; i < 30; i++) {
      grip.drag(new Vec2(50 + 0.5 * i, 30), i * tick);
    }
    grip.release(30 * tick);
    double cut = 1e9 / 60 / tick; // to whole nanoseconds
    assertThat(player.scene().velocity(Kind.CIRCLE, 0).x()).isCloseTo(0.5 * cut, offset(1e-12));
    assertThat(player.scene().velocity(Kind.CIRCLE, 0).y()).isZero();
  }

  /** A busy machine hands over ten motions of 6 in 160 ms as ten at one moment. */
  @Test
  void motionsThatComeAllAtOnceThrowNoFasterThanTheirWayInThreeTicks() {
    Grip grip = Grip.at(player, new Vec2(50, 30), 2);
    grip.drag(new Vec2(50, 30), 1_000_000_000);
    for (int i = 1; i <= 10; i++) {
      grip.drag(new Vec2(50 + 0.6 * i, 30), 1_000_000_000 + i);
    }
    grip.release(1_000_000_100);
    assertThat(player.scene().velocity(Kind.CIRCLE, 0).x()).isCloseTo(6 / 3.0, offset(1e-6));
  }

  @Test
  void aCircleThatIsLetGoOfAtRestFliesOnAsBefore() {
    Grip grip = Grip.at(player, new Vec2(50, 30), 2);
    grip.drag(new Vec2(52, 30), 10);
    grip.hold();
    assertThat(player.scene().velocity(Kind.CIRCLE, 0)).isEqualTo(Vec2.ZERO);
    grip.release(1_000_000_000);
    assertThat(player.scene().velocity(Kind.CIRCLE, 0)).isEqualTo(new Vec2(8, 0));
    assertThat(((Circle) player.scene().shape(Kind.CIRCLE, 0)).x()).isEqualTo(52);
  }

  @Test
  void whatIsHeldStaysWhileTheWorldGoesOn() {
    Grip grip = Grip.at(player, new Vec2(50, 30), 2);
    player.setRunning(true);
    for (int i = 0; i < 5; i++) {
      grip.hold();
      player.tick();
    }
    assertThat(player.shown()).isEqualTo(5);
    assertThat(x()).isEqualTo(50);
  }

  @Test
  void addsAndRemoves() {
    new Draft(Tool.CIRCLE, new Vec2(20, 40), new Vec2(50, 40), 5).add(player);
    assertThat(player.scene().shape(Kind.CIRCLE, 1)).isEqualTo(new Circle(20, 40, 5));
    assertThat(player.scene().velocity(Kind.CIRCLE, 1)).isEqualTo(new Vec2(1, 0));
    new Draft(Tool.LINE, new Vec2(80, 10), new Vec2(90, 20), 5).add(player);
    assertThat(player.scene().shape(Kind.LINE, 1)).isEqualTo(new Line(80, 10, 90, 20));
    new Draft(Tool.LINE, new Vec2(80, 10), new Vec2(80, 10), 5).add(player);
    assertThat(player.scene().count(Kind.LINE)).isEqualTo(2);
    new Draft(Tool.PEG, new Vec2(30, 50), new Vec2(33, 54), 5).add(player);
    assertThat(player.scene().shape(Kind.PEG, 0)).isEqualTo(new Circle(30, 50, 5));
    Grip peg = Grip.at(player, new Vec2(30, 50), 2);
    peg.drag(new Vec2(31, 50), 0);
    assertThat(player.scene().shape(Kind.PEG, 0)).isEqualTo(new Circle(31, 50, 5));
    player.remove(peg.kind(), peg.id());
    assertThat(player.scene().count(Kind.PEG)).isZero();
  }

  @Test
  void aDraftShowsTheWayThatTheCircleTakes() {
    Draft draft = new Draft(Tool.CIRCLE, new Vec2(20, 40), new Vec2(170, 40), 5);
    double turn = draft.way(player).points().get(1).x();
    draft.add(player);
    player.seek(player.end());
    run(15);
    assertThat(turn).isEqualTo(95);
    assertThat(((Circle) player.scene().shape(Kind.CIRCLE, 1)).x()).isEqualTo(95);
  }

  /** Bounces of height 20 over the floor: 20 frames up, 20 down; a fork in mid-air. */
  @Test
  void circlesFall() {
    Scene scene =
        Scene.builder().gravity(0, -0.1).bounds(0, 0, 100, 60).circle(50, 30, 10, 1, 0).build();
    Player falling = new Player(scene, 1);
    assertThat(falling.nextImpact()).isTrue();
    assertThat(falling.shown()).isEqualTo(20);
    falling.setRunning(true);
    for (int i = 0; i < 10; i++) {
      falling.tick();
    }
    double y = ((Circle) falling.scene().shape(Kind.CIRCLE, 0)).y();
    assertThat(y).isCloseTo(25, offset(1e-12));
    assertThat(falling.scene().gravity()).isEqualTo(new Vec2(0, -0.1));
    falling.setGravity(0, 0);
    falling.stepFrame();
    assertThat(((Circle) falling.scene().shape(Kind.CIRCLE, 0)).y())
        .as("straight on")
        .isCloseTo(26, offset(1e-12));
    assertThat(falling.scene().gravity()).isEqualTo(Vec2.ZERO);
    falling.seek(10);
    assertThat(falling.scene().shape(Kind.CIRCLE, 0)).isEqualTo(new Circle(60, 25, 10));
    assertThat(falling.look().gravity()).as("that of then").isEqualTo(new Vec2(0, -0.1));
    falling.throwCircle(0, 1, 2);
    assertThat(falling.end()).isEqualTo(10);
    assertThat(falling.scene().gravity()).isEqualTo(new Vec2(0, -0.1));
    falling.stepFrame();
    assertThat(((Circle) falling.scene().shape(Kind.CIRCLE, 0)).y())
        .isCloseTo(26.95, offset(1e-12));
  }

  /** The way that is drawn is an arc, and the circle takes it. */
  @Test
  void aDraftFallsToo() {
    player.setGravity(0, -0.1);
    Draft draft = new Draft(Tool.CIRCLE, new Vec2(20, 40), new Vec2(50, 40), 5);
    Vec2 half = draft.way(player).at(10);
    assertThat(half).isEqualTo(new Vec2(30, 35));
    draft.add(player);
    run(10);
    assertThat(((Circle) player.scene().shape(Kind.CIRCLE, 1)).y()).isCloseTo(35, offset(1e-12));
  }

  @Test
  void knowsWhenACircleJumped() {
    run(3);
    player.moveCircle(0, 40, 40);
    run(3);
    assertThat(player.lastJump(0)).isEqualTo(3);
    player.seek(2);
    assertThat(player.lastJump(0)).isEqualTo(Double.NEGATIVE_INFINITY);
  }
}
