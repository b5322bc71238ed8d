// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;
import static dev.carom.Kind.WALL;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Every edit that is refused names thing, value and expectation, and leaves the world alone. */
class RefusedEditTest {

  private static final double NAN = Double.NaN;
  private static final double INF = Double.POSITIVE_INFINITY;

  private static final double LEAST = 1;

  private static final String FINITE = ": expected a finite number";

  private static final String TOO_LARGE =
      ": expected a smaller one: 2^10 ulps of it must not exceed the least radius, " + LEAST;

  private static World world(boolean collide) {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 1000, 900).collide(collide);
    scene.line(10, 20, 30, 40).line(50, 60, 70, 80).peg(500, 500, 5).peg(600, 600, 5);
    scene.circle(100, 100, LEAST, 1, 2).circle(200, 100, 3, 1, 2).circle(300, 100, 3, 1, 2);
    World world = new World(scene.build());
    world.step(3);
    world.remove(CIRCLE, 2);
    world.remove(LINE, 1);
    world.remove(PEG, 1);
    return world;
  }

  private static Arguments refused(String message, Consumer<World> edit) {
    return arguments(message, edit);
  }

  static Stream<Arguments> numbers() {
    return Stream.of(
        refused("circle 0: vx is NaN" + FINITE, w -> w.setVelocity(0, NAN, 1)),
        refused("circle 1: vy is -Infinity" + FINITE, w -> w.setVelocity(1, 1, -INF)),
        refused("peg 0: vx is NaN" + FINITE, w -> w.setVelocity(PEG, 0, NAN, 0)),
        refused("kind is WALL: expected LINE, PEG or CIRCLE", w -> w.setVelocity(WALL, 0, 1, 0)),
        refused("circle 0: x is Infinity" + FINITE, w -> w.setPosition(0, INF, 1)),
        refused("circle 0: y is NaN" + FINITE, w -> w.setPosition(0, 1, NAN)),
        refused("circle 1: x is 1.0E13" + TOO_LARGE, w -> w.setPosition(1, 1e13, 0)),
        refused("circle 1: y is -1.0E13" + TOO_LARGE, w -> w.setPosition(1, 0, -1e13)),
        refused(
            "circle 0: radius is 0.0: expected more than 0, as there are lines",
            w -> w.setShape(Kind.CIRCLE, 0, new Circle(w.x(0), w.y(0), 0))),
        refused(
            "circle 1: radius is 1.0E-11: expected at least 1.1641532182693481E-10, 2^10 ulps of"
                + " the largest coordinate, 1000.0",
            w -> w.setShape(Kind.CIRCLE, 1, new Circle(w.x(1), w.y(1), 1e-11))),
        refused("circle 3: x is NaN" + FINITE, w -> w.addCircle(NAN, 1, 1, 1, 1, Traits.DEFAULT)),
        refused(
            "circle 3: y is 1.0E13" + TOO_LARGE,
            w -> w.addCircle(1, 1e13, 1, 1, 1, Traits.DEFAULT)),
        refused(
            "circle 3: radius is -1.0: expected a finite",
            w -> w.addCircle(1, 1, -1, 1, 1, Traits.DEFAULT)),
        refused(
            "circle 3: radius is 1.0E-11: expected at least",
            w -> w.addCircle(1, 1, 1e-11, 1, 1, Traits.DEFAULT)),
        refused(
            "circle 3: vx is Infinity" + FINITE, w -> w.addCircle(1, 1, 1, INF, 1, Traits.DEFAULT)),
        refused("circle 3: vy is NaN" + FINITE, w -> w.addCircle(1, 1, 1, 1, NAN, Traits.DEFAULT)),
        refused("line 2: ax is NaN" + FINITE, w -> w.addLine(NAN, 1, 1, 1, Traits.DEFAULT)),
        refused("line 2: by is 1.0E13" + TOO_LARGE, w -> w.addLine(1, 1, 1, 1e13, Traits.DEFAULT)),
        refused(
            "line 0: ay is 1.0E13" + TOO_LARGE,
            w -> w.setShape(Kind.LINE, 0, new Line(1, 1e13, 1, 1))),
        refused("peg 2: x is NaN" + FINITE, w -> w.addPeg(NAN, 1, 1, Traits.DEFAULT)),
        refused(
            "peg 2: radius is -1.0: expected a finite", w -> w.addPeg(1, 1, -1, Traits.DEFAULT)),
        refused(
            "peg 0: y is 1.0E13" + TOO_LARGE, w -> w.setShape(Kind.PEG, 0, new Circle(1, 1e13, 1))),
        refused(
            "bounds: response is sensor: expected bounce or halt: bounds keep circles inside",
            w -> w.setTraits(WALL, 0, w.traits(WALL, 0).withResponse(Response.SENSOR))),
        refused("line 0: x is NaN" + FINITE, w -> w.moveTo(LINE, 0, NAN, 1, 9)),
        refused("peg 0: y is 1.0E13" + TOO_LARGE, w -> w.moveTo(PEG, 0, 1, 1e13, 9)),
        refused(
            "line 0: arrival is 3.0: expected a finite time after now, 3.0",
            w -> w.moveTo(LINE, 0, 1, 1, 3)),
        refused(
            "peg 0: arrival is NaN: expected a finite time after now",
            w -> w.moveTo(PEG, 0, 1, 1, NAN)),
        refused(
            "peg 0: arrival is Infinity: expected a finite time after now",
            w -> w.moveTo(PEG, 0, 1, 1, INF)),
        refused(
            "kind is CIRCLE: expected LINE or PEG: walls do not move, and a circle is steered by"
                + " setVelocity",
            w -> w.moveTo(CIRCLE, 0, 1, 1, 9)),
        refused("kind is WALL: expected LINE or PEG", w -> w.moveTo(WALL, 0, 1, 1, 9)),
        refused("line 0: pivotX is NaN" + FINITE, w -> w.turn(LINE, 0, NAN, 1, 1, 9)),
        refused("peg 0: pivotY is 1.0E13" + TOO_LARGE, w -> w.turn(PEG, 0, 1, 1e13, 1, 9)),
        refused(
            "line 0: angle is 1.6: expected at most a quarter turn, +-1.5707963267948966",
            w -> w.turn(LINE, 0, 1, 1, 1.6, 9)),
        refused("line 0: angle is NaN: expected at most a", w -> w.turn(LINE, 0, 1, 1, NAN, 9)),
        refused(
            "peg 0: arrival is 3.0: expected a finite time after now, 3.0",
            w -> w.turn(PEG, 0, 1, 1, 1, 3)),
        refused("line 0: arrival is NaN: expected a", w -> w.turn(LINE, 0, 1, 1, 1, NAN)),
        refused(
            "kind is CIRCLE: expected LINE or PEG: walls do not move",
            w -> w.turn(CIRCLE, 0, 1, 1, 1, 9)),
        refused("kind is WALL: expected LINE or PEG", w -> w.turn(WALL, 0, 1, 1, 1, 9)),
        refused("kind is WALL: expected LINE, PEG or CIRCLE: walls stay", w -> w.remove(WALL, 0)),
        refused("dt is NaN: expected at least 0", w -> w.step(NAN)),
        refused("dt is -4.9E-324: expected at least 0", w -> w.step(-Double.MIN_VALUE)),
        refused("dt is Infinity: expected at least 0", w -> w.step(INF)),
        refused("t is -Infinity: expected ", w -> w.advanceTo(-INF)),
        refused("duration is -1.0: expected at least 0", w -> w.record(-1)));
  }

  @ParameterizedTest
  @MethodSource("numbers")
  void numbersThatMakeNoSense(String message, Consumer<World> edit) {
    for (boolean collide : new boolean[] {false, true}) {
      World world = world(collide);
      Snapshot before = world.snapshot();
      assertThatThrownBy(() -> edit.accept(world))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith(message);
      assertUntouched(world, before);
    }
  }

  static Stream<Arguments> ids() {
    String gone = " does not exist: it was removed";
    String below = " does not exist: expected an id from 0 to ";
    return Stream.of(
        refused("circle 2" + gone, w -> w.setVelocity(2, 1, 1)),
        refused("circle 2" + gone, w -> w.setPosition(2, 1, 1)),
        refused("circle 2" + gone, w -> w.setShape(CIRCLE, 2, new Circle(1, 1, 1))),
        refused("circle 2" + gone, w -> w.setTraits(CIRCLE, 2, Traits.DEFAULT)),
        refused("circle 2" + gone, w -> w.x(2)),
        refused("circle 2" + gone, w -> w.y(2)),
        refused("circle 2" + gone, w -> w.vx(2)),
        refused("circle 2" + gone, w -> w.vy(2)),
        refused("circle 2" + gone, w -> w.radius(2)),
        refused("circle 2" + gone, w -> w.traits(CIRCLE, 2)),
        refused("circle 2" + gone, w -> w.remove(CIRCLE, 2)),
        refused("circle 3" + below + 2, w -> w.x(3)),
        refused("circle -1" + below + 2, w -> w.x(-1)),
        refused("circle 3" + below + 2, w -> w.setVelocity(3, 1, 1)),
        refused("peg 2" + below + 1, w -> w.setVelocity(PEG, 2, 0, 0)),
        refused("circle 3" + below + 2, w -> w.traits(CIRCLE, 3)),
        refused("circle -1" + below + 2, w -> w.setVelocity(-1, 1, 1)),
        refused("circle -1" + below + 2, w -> w.setTraits(CIRCLE, -1, Traits.DEFAULT)),
        refused("line 1" + gone, w -> w.setShape(LINE, 1, new Line(1, 2, 3, 4))),
        refused("line 1" + gone, w -> w.setTraits(LINE, 1, Traits.DEFAULT)),
        refused("line 1" + gone, w -> w.traits(LINE, 1)),
        refused("line 1" + gone, w -> w.line(1)),
        refused("line 2" + below + 1, w -> w.setShape(LINE, 2, new Line(1, 2, 3, 4))),
        refused("peg 1" + gone, w -> w.setShape(PEG, 1, new Circle(1, 2, 3))),
        refused("peg 1" + gone, w -> w.traits(PEG, 1)),
        refused("peg 1" + gone, w -> w.peg(1)),
        refused("peg 1" + gone, w -> w.remove(PEG, 1)),
        refused("peg 7" + below + 1, w -> w.setTraits(PEG, 7, Traits.DEFAULT)),
        refused("wall 4" + below + 3, w -> w.traits(WALL, 4)),
        refused("wall 4" + below + 3, w -> w.setTraits(WALL, 4, Traits.DEFAULT)));
  }

  @ParameterizedTest
  @MethodSource("ids")
  void idsOfNothing(String message, Consumer<World> edit) {
    World world = world(false);
    Snapshot before = world.snapshot();
    assertThatThrownBy(() -> edit.accept(world))
        .isInstanceOf(IndexOutOfBoundsException.class)
        .hasMessage(message);
    assertUntouched(world, before);
  }

  /** A coordinate of 10^14 has ulps of 2^-6: 2^10 of them are 16. */
  @Test
  void aRadiusTooSmallForTheFarthestEnd() {
    for (Line far : List.of(new Line(1e14, 1, 0, 0), new Line(0, 0, 1, -1e14))) {
      SceneBuilder scene = Scene.builder().line(far.ax(), far.ay(), far.bx(), far.by());
      World world = new World(scene.circle(0, 99, 16, 0, 0).build());
      assertTooSmall(world);
    }
  }

  static Stream<Consumer<World>> farEdits() {
    return Stream.of(
        w -> w.setPosition(0, 1e14, 0),
        w -> w.setPosition(0, 0, -1e14),
        w -> w.addCircle(0, 1e14, 16, 0, 0, Traits.DEFAULT),
        w -> w.addLine(-1e14, 1, 0, 0, Traits.DEFAULT),
        w -> w.addLine(0, 0, 1e14, 1, Traits.DEFAULT),
        w -> w.setShape(Kind.LINE, 0, new Line(1, 1e14, 0, 0)),
        w -> w.setShape(Kind.LINE, 0, new Line(0, 0, 1, -1e14)),
        w -> w.addPeg(1e14, 0, 1, Traits.DEFAULT),
        w -> w.setShape(Kind.PEG, 0, new Circle(0, 1e14, 1)));
  }

  @ParameterizedTest
  @MethodSource("farEdits")
  void aRadiusTooSmallForWhatWasPutFarAway(Consumer<World> edit) {
    World world =
        new World(
            Scene.builder()
                .collide(false)
                .line(1, 2, 3, 4)
                .peg(9, 9, 1)
                .circle(0, 99, 16, 0, 0)
                .build());
    edit.accept(world);
    assertTooSmall(world);
  }

  @Test
  void aRadiusTooSmallForTheScene() {
    assertTooSmall(new World(Scene.builder().circle(1e14, 0, 16, 0, 0).build()));
    for (Bounds b : List.of(new Bounds(-1e14, 0, 9, 9), new Bounds(0, 0, 9, 1e14))) {
      SceneBuilder scene = Scene.builder().bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax());
      assertTooSmall(new World(scene.circle(4, 4, 16, 0, 0).build()));
    }
  }

  private static void assertTooSmall(World world) {
    assertThatThrownBy(() -> world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 8)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("expected at least 16.0");
    world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 16));
  }

  @Test
  void theFirstIdToo() {
    World world = world(false);
    world.remove(CIRCLE, 0);
    assertThatThrownBy(() -> world.x(0)).hasMessage("circle 0 does not exist: it was removed");
  }

  @Test
  void idsOfAnEmptyWorld() {
    World world = new World(Scene.builder().build());
    assertThatThrownBy(() -> world.x(0)).hasMessage("circle 0 does not exist: there is none");
    assertThatThrownBy(() -> world.traits(WALL, 0).restitution())
        .isInstanceOf(IndexOutOfBoundsException.class)
        .hasMessage("wall 0 does not exist: there is none");
  }

  private static void assertUntouched(World world, Snapshot before) {
    assertThat(world.snapshot()).isEqualTo(before);
    World other = new World(world.scene());
    other.restore(before);
    assertThat(Run.advance(world, 200).impacts()).isEqualTo(Run.advance(other, 200).impacts());
  }
}
