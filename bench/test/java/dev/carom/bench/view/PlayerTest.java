// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.experiment.Crosses;
import org.junit.jupiter.api.Test;

class PlayerTest {

  /** Hits the right wall at 5, the left one at 15, and so on. */
  private static final Scene TO_AND_FRO =
      Scene.builder().bounds(0, 0, 100, 60).line(20, 10, 60, 10).circle(50, 30, 10, 8, 0).build();

  private final Player player = new Player(TO_AND_FRO, 1);

  private void run(int ticks) {
    player.setRunning(true);
    for (int i = 0; i < ticks; i++) {
      player.tick();
    }
  }

  private double x() {
    return player.scene().circle(0).x();
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
    assertThat(player.marks(1)).containsExactly(new Mark(15, 0, 30, 1, 0));
    player.seek(2);
    assertThat(player.nextImpact()).as("a recorded one").isTrue();
    assertThat(player.shown()).isEqualTo(5);
    assertThat(player.impacts()).isEqualTo(2);
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
  void saysThatNothingIsAhead() {
    Player free = new Player(Scene.builder().circle(0, 0, 1, 1, 0).build(), 1);
    assertThat(free.nextImpact()).isFalse();
    assertThat(free.shown()).isZero();
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
  void anEditInThePastBeginsANewRunFromThere() {
    run(20);
    player.seek(7);
    player.moveCircle(0, 40, 31);
    assertThat(player.end()).isZero();
    assertThat(player.scene().circle(0)).isEqualTo(new Circle(40, 31, 10));
    assertThat(player.scene().velocity(0)).isEqualTo(new Vec2(-8, 0));
    player.restart();
    assertThat(player.scene()).isEqualTo(TO_AND_FRO);
  }

  @Test
  void takesHoldOfCirclesLinesAndEnds() {
    assertThat(Grip.at(player, new Vec2(5, 50), 2)).isNull();
    Grip.at(player, new Vec2(55, 35), 2).drag(new Vec2(56, 36));
    assertThat(player.scene().circle(0)).isEqualTo(new Circle(51, 31, 10));
    Grip.at(player, new Vec2(40, 11), 2).drag(new Vec2(41, 16));
    assertThat(player.scene().line(0)).isEqualTo(new Line(21, 15, 61, 15));
    Grip.at(player, new Vec2(60.5, 15), 2).drag(new Vec2(60.5, 20));
    assertThat(player.scene().line(0)).isEqualTo(new Line(21, 15, 61, 20));
    Grip.at(player, new Vec2(21, 15), 2).drag(new Vec2(20, 15));
    assertThat(player.scene().line(0)).isEqualTo(new Line(20, 15, 61, 20));
  }

  @Test
  void aClickInThePastDropsNothing() {
    run(20);
    player.seek(7);
    Grip.at(player, new Vec2(74, 30), 2);
    assertThat(player.end()).isEqualTo(20);
  }
}
