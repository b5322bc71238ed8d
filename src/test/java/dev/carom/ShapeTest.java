// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;
import static dev.carom.Kind.WALL;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShapeTest {

  private static final Bounds BOX = new Bounds(0, 0, 100, 100);

  private static SceneBuilder builder() {
    return Scene.builder()
        .bounds(0, 0, 100, 100)
        .line(10, 80, 20, 90)
        .line(50, 0, 50, 10)
        .velocity(2, 0)
        .peg(70, 20, 3)
        .circle(20, 20, 2, 3, 1);
  }

  @ParameterizedTest
  @CsvSource({"WALL, 4", "LINE, 2", "PEG, 1", "CIRCLE, 1"})
  void thingsOfEachKindAreCounted(Kind kind, int count) {
    Scene scene = builder().build();

    assertThat(builder().count(kind)).isEqualTo(count);
    assertThat(scene.count(kind)).isEqualTo(count);
    assertThat(new World(scene).count(kind)).isEqualTo(count);
    assertThat(new World(Scene.builder().build()).count(kind)).isZero();
  }

  @Test
  void whatIsRemovedIsNoLongerCounted() {
    World world = new World(builder().build());
    world.remove(LINE, 0);
    world.remove(CIRCLE, 0);

    assertThat(world.count(LINE)).isEqualTo(1);
    assertThat(world.count(CIRCLE)).isZero();
  }

  @Test
  void aSceneHasTheShapesOfItsStartAndAWorldThoseOfNow() {
    Scene scene = builder().build();
    World world = new World(scene);
    world.advanceTo(4);

    assertThat(scene.shape(WALL, 3)).isEqualTo(BOX).isEqualTo(world.shape(WALL, 3));
    assertThat(scene.shape(LINE, 1)).isEqualTo(new Line(50, 0, 50, 10));
    assertThat(world.shape(LINE, 1)).isEqualTo(new Line(58, 0, 58, 10));
    assertThat(scene.shape(PEG, 0)).isEqualTo(new Circle(70, 20, 3)).isEqualTo(world.shape(PEG, 0));
    assertThat(scene.shape(CIRCLE, 0)).isEqualTo(new Circle(20, 20, 2));
    assertThat(world.shape(CIRCLE, 0)).isEqualTo(new Circle(32, 24, 2));
  }

  @Test
  void aThingGetsAnotherShape() {
    World world = new World(builder().build());
    Line line = new Line(1, 2, 3, 4);
    Circle peg = new Circle(30, 30, 5);
    Circle ball = new Circle(60, 70, 1);

    world.setShape(LINE, 0, line);
    world.setShape(PEG, 0, peg);
    world.setShape(CIRCLE, 0, ball);

    assertThat(world.shape(LINE, 0)).isEqualTo(line);
    assertThat(world.shape(PEG, 0)).isEqualTo(peg);
    assertThat(world.shape(CIRCLE, 0)).isEqualTo(ball);
    assertThat(world.velocity(CIRCLE, 0)).isEqualTo(new Vec2(3, 1));
  }

  /** A new place is one edit with the radius, and the same as a new place alone. */
  @Test
  void aNewPlaceIsAsThatOfSetPosition() {
    World one = new World(builder().build());
    World two = new World(builder().build());
    one.advanceTo(1.7);
    two.advanceTo(1.7);

    one.setShape(CIRCLE, 0, new Circle(60, 70, 2));
    two.setPosition(0, 60, 70);

    assertThat(one.snapshot()).isEqualTo(two.snapshot());
  }

  @Test
  void anotherSortOfShapeIsRefused() {
    World world = new World(builder().build());
    Snapshot before = world.snapshot();
    Line line = new Line(1, 2, 3, 4);
    Circle disk = new Circle(30, 30, 5);

    refused("shape of line 1 is " + disk + ": expected a Line", world, LINE, 1, disk);
    refused("shape of peg 0 is " + line + ": expected a Circle", world, PEG, 0, line);
    refused("shape of circle 0 is " + BOX + ": expected a Circle", world, CIRCLE, 0, BOX);
    refused("kind is WALL: expected LINE, PEG or CIRCLE: walls stay", world, WALL, 0, BOX);
    assertThat(world.snapshot()).isEqualTo(before);
    assertThatThrownBy(() -> world.setShape(PEG, 1, disk))
        .isInstanceOf(IndexOutOfBoundsException.class)
        .hasMessage("peg 1 does not exist: expected an id from 0 to 0");
  }

  private static void refused(String message, World world, Kind kind, int id, Obstacle shape) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.setShape(kind, id, shape))
        .withMessage(message);
  }
}
