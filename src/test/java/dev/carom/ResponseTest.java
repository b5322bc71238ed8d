// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Halting, sensors and one-way lines. */
class ResponseTest {

  private static SceneBuilder box() {
    return Scene.builder().collide(false).bounds(0, 0, 100, 100);
  }

  private static List<Impact> impacts(SceneBuilder scene, double end) {
    return Run.advance(new World(scene.build()), end).impacts();
  }

  // Halt.

  @Test
  void aCircleSlidesAlongALineAtWhichItHalts() {
    World world =
        new World(
            box().line(0, 50, 100, 50).response(Response.HALT).circle(20, 30, 5, 1, 2).build());
    world.step(30);
    assertThat(world.vx(0)).isEqualTo(1);
    assertThat(world.vy(0)).isZero();
    assertThat(world.y(0)).isEqualTo(45);
    assertThat(world.x(0)).isEqualTo(50);
  }

  @Test
  void aPegAndTheBoundsCanHalt() {
    SceneBuilder scene =
        Scene.builder().collide(false).bounds(0, 0, 100, 100).response(Response.HALT);
    scene.peg(50, 20, 5).response(Response.HALT).circle(20, 20, 5, 3, 0).circle(20, 50, 5, 3, 1);
    World world = new World(scene.build());
    world.step(100);
    assertThat(List.of(world.vx(0), world.vy(0))).containsExactly(0.0, 0.0);
    assertThat(List.of(world.vx(1), world.vy(1))).containsExactly(0.0, 0.0);
    assertThat(List.of(world.x(1), world.y(1))).containsExactly(95.0, 95.0);
  }

  @Test
  void bothCirclesOfAPairLoseTheirMotionAlongTheNormal() {
    SceneBuilder scene = Scene.builder();
    scene.circle(0, 0, 1, 2, 1).mass(5).response(Response.HALT).circle(10, 4, 1, -2, -1);
    World world = new World(scene.build());
    world.step(3);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.impacts().nx(0)).isEqualTo(-1);
    assertThat(List.of(world.vx(0), world.vy(0))).containsExactly(0.0, 1.0);
    assertThat(List.of(world.vx(1), world.vy(1))).containsExactly(0.0, -1.0);
  }

  @Test
  void atACircleThatNothingDeflectsTheOtherTakesOverItsMotion() {
    SceneBuilder scene = Scene.builder();
    scene.circle(0, 0, 1, 3, 0).response(Response.HALT);
    World world = new World(scene.circle(10, 0, 1, -1, 0).mass(Double.POSITIVE_INFINITY).build());
    world.step(10);
    assertThat(world.vx(0)).isEqualTo(-1);
    assertThat(world.vx(1)).isEqualTo(-1);
    assertThat(world.x(1) - world.x(0)).isEqualTo(2);
  }

  // Sensors.

  @Test
  void aSensorReportsEachEntryAndDeflectsNothing() {
    SceneBuilder with = box().peg(50, 50, 10).response(Response.SENSOR).circle(20, 50, 5, 5, 0);
    SceneBuilder without = box().circle(20, 50, 5, 5, 0);
    List<Impact> rows = impacts(with, 60);
    assertThat(rows.stream().filter(row -> row.kind() == Kind.WALL).toList())
        .isEqualTo(impacts(without, 60));
    assertThat(rows.stream().filter(row -> row.kind() == Kind.PEG).map(Impact::time))
        .containsExactly(3.0, 21.0, 39.0, 57.0);
    Impact first = rows.get(0);
    assertThat(List.of(first.x(), first.y(), first.nx(), first.approachSpeed()))
        .containsExactly(40.0, 50.0, -1.0, 5.0);
  }

  /** Inside a sensor the circle turns round at a line: it has not left, so it does not enter. */
  @Test
  void aBounceInsideASensorReportsNothing() {
    List<Impact> rows =
        impacts(
            box()
                .peg(50, 50, 20)
                .response(Response.SENSOR)
                .line(50, 0, 50, 100)
                .circle(10, 50, 5, 5, 0),
            13);
    assertThat(rows).extracting(Impact::kind).containsExactly(Kind.PEG, Kind.LINE);
  }

  @Test
  void aCircleThatStartsInsideHasNotEntered() {
    assertThat(impacts(box().peg(50, 50, 20).response(Response.SENSOR).circle(45, 50, 5, 1, 0), 9))
        .isEmpty();
  }

  @Test
  void oneThatStartsInTouchHasEntered() {
    assertThat(impacts(box().peg(50, 50, 20).response(Response.SENSOR).circle(25, 50, 5, 1, 0), 9))
        .isEmpty();
  }

  /** Where a sensor and a line are hit at one time, the sensor is reported, and first. */
  @Test
  void aSensorAtTheVeryPlaceOfALineIsReportedToo() {
    List<Impact> rows =
        impacts(
            box()
                .line(50, 0, 50, 100)
                .line(50, 0, 50, 100)
                .response(Response.SENSOR)
                .line(50, 100, 50, 0)
                .response(Response.SENSOR)
                .circle(10, 50, 5, 5, 0),
            8);
    assertThat(rows).extracting(Impact::id).containsExactly(1, 2, 0);
    assertThat(rows).extracting(Impact::time).containsOnly(7.0);
  }

  // One-way lines.

  @Test
  void aOneWayLineIsThereOnlyFromItsLeft() {
    List<Impact> rows =
        impacts(
            box().line(50, 0, 50, 100).oneWay().circle(20, 50, 5, 2, 0).circle(80, 20, 5, -2, 0),
            35);
    assertThat(rows.stream().filter(row -> row.circle() == 0).map(Impact::kind))
        .containsOnly(Kind.LINE, Kind.WALL);
    assertThat(rows.stream().filter(row -> row.circle() == 1)).isEmpty();
  }

  /** One that passed through from the right comes back from the left, and bounces. */
  @Test
  void whoPassedCannotReturn() {
    World world = new World(box().line(50, 0, 50, 100).oneWay().circle(80, 20, 5, -2, 0).build());
    for (int frame = 0; frame < 1000; frame++) {
      world.step(1);
      assertThat(frame < 30 || world.x(0) <= 45).isTrue();
    }
  }

  /** A centre exactly on the line is not left of it; nor is anything left of a point. */
  @Test
  void onTheLineIsNotLeftOfIt() {
    assertThat(impacts(box().line(50, 0, 50, 100).oneWay().circle(50, 50, 5, 1, 0), 20)).isEmpty();
    assertThat(impacts(box().line(50, 50, 50, 50).oneWay().circle(20, 50, 5, 1, 0), 70)).isEmpty();
  }

  @Test
  void itsEndsAreSolidFromTheLeftToo() {
    List<Impact> rows = impacts(box().line(50, 50, 50, 100).oneWay().circle(20, 47, 5, 2, 0), 20);
    assertThat(rows).extracting(Impact::feature).startsWith(Feature.START);
    assertThat(impacts(box().line(50, 100, 50, 50).oneWay().circle(20, 47, 5, 2, 0), 20)).isEmpty();
  }

  @Test
  void aLineThatOpensIsNotHitAnyMore() {
    for (boolean collide : new boolean[] {false, true}) {
      SceneBuilder scene = box().collide(collide).line(50, 0, 50, 99).circle(80, 50, 5, -2, 0);
      World world = new World(scene.build());
      world.step(1);
      world.setTraits(Kind.LINE, 0, world.traits(Kind.LINE, 0).withOneWay(true));
      assertThat(Run.advance(world, 20).impacts()).isEmpty();
    }
  }

  /** It moves neither to the right nor to the left, or is neither here nor there. */
  @Test
  void alongAOneWayLineIsPastIt() {
    assertThat(impacts(box().line(50, 50, 50, 80).oneWay().circle(48, 20, 5, 0, 2), 20)).isEmpty();
    assertThat(impacts(box().line(50, 50, 50, 80).circle(48, 20, 5, 0, 2), 20)).hasSize(1);
    // Neither on its left nor on its right, and bound for the right.
    assertThat(impacts(box().line(50, 50, 50, 80).oneWay().circle(50, 20, 5, 0.01, 2), 20))
        .isEmpty();
    assertThat(impacts(box().line(50, 50, 50, 80).circle(50, 20, 5, 0.01, 2), 20)).hasSize(1);
  }

  // Scenes.

  @Test
  void boundsCannotBeASensor() {
    assertThatThrownBy(() -> box().response(Response.SENSOR))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "bounds: response is sensor: expected bounce or halt: bounds keep circles inside");
  }

  @Test
  void traitsBelongToTheThingAddedLast() {
    assertThatThrownBy(() -> Scene.builder().response(Response.HALT))
        .isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> box().peg(1, 1, 1).oneWay())
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("one-way belongs to the line just added: add one first");
  }
}
