// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;
import static dev.carom.Kind.WALL;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The effect of each edit of a world. */
class WorldEditTest {

  private static SceneBuilder box() {
    return Scene.builder().bounds(0, 0, 100, 100);
  }

  private static World world(SceneBuilder builder) {
    return new World(builder.build());
  }

  /** The times of impacts with one kind until a given time. */
  private static List<Double> times(World world, Kind kind, double end) {
    return Run.advance(world, end).impacts().stream()
        .filter(row -> row.kind() == kind)
        .map(Impact::time)
        .toList();
  }

  // Circles.

  // Lines and pegs.

  /** A paddle that goes up and down every frame; the circle meets it where it is by then. */
  @CollidingOrNot
  void aMovedPaddleIsHitWhereItIs(boolean collide) {
    World world = world(box().collide(collide).line(50, 0, 50, 20).circle(20, 50, 5, 1, 0));
    for (int frame = 1; frame <= 24; frame++) {
      assertThat(world.impacts().size()).isZero();
      world.step(1);
      world.setShape(Kind.LINE, 0, new Line(50, 2 * frame, 50, 2 * frame + 20));
    }
    assertThat(times(world, LINE, 25)).containsExactly(25.0);
    assertThat(world.vx(0)).isEqualTo(-1);
    // It was hit last; put behind the circle, it is hit again.
    world.setShape(Kind.LINE, 0, new Line(20, 40, 20, 60));
    assertThat(times(world, LINE, 60)).containsExactly(45.0);
  }

  @CollidingOrNot
  void whatWasSetIsReadBack(boolean collide) {
    World world =
        world(
            box()
                .restitution(0.5)
                .response(Response.HALT)
                .collide(collide)
                .line(60, 0, 60, 100)
                .restitution(0.25)
                .oneWay()
                .peg(80, 50, 1)
                .response(Response.SENSOR)
                .circle(50, 50, 5, 1, 0)
                .restitution(2));
    assertTraits(world, WALL, 3, 0.5, Response.HALT);
    assertTraits(world, LINE, 0, 0.25, Response.BOUNCE);
    assertTraits(world, PEG, 0, 1, Response.SENSOR);
    assertTraits(world, CIRCLE, 0, 2, Response.BOUNCE);
    assertThat(world.traits(Kind.LINE, 0).oneWay()).isTrue();

    for (Kind kind : Kind.values()) {
      world.setTraits(kind, 0, world.traits(kind, 0).withRestitution(0.75 + kind.ordinal()));
      world.setTraits(
          kind,
          0,
          world.traits(kind, 0).withResponse(kind == PEG ? Response.BOUNCE : Response.HALT));
    }
    world.setTraits(Kind.LINE, 0, world.traits(Kind.LINE, 0).withOneWay(false));
    assertThat(world.addLine(1, 1, 2, 2, Traits.DEFAULT)).isEqualTo(1);
    assertThat(world.addCircle(20, 20, 5, 0, 0, Traits.DEFAULT)).isEqualTo(1);
    Snapshot edited = world.snapshot();
    world.step(100);
    World other = world(box().collide(collide));
    other.restore(edited);
    for (World each : List.of(world, other)) {
      assertTraits(each, WALL, 2, 0.75, Response.HALT);
      assertTraits(each, LINE, 0, 1.75, Response.HALT);
      assertTraits(each, PEG, 0, 2.75, Response.BOUNCE);
      assertTraits(each, CIRCLE, 0, 3.75, Response.HALT);
      assertTraits(each, LINE, 1, 1, Response.BOUNCE);
      assertTraits(each, CIRCLE, 1, 1, Response.BOUNCE);
      assertThat(each.traits(Kind.LINE, 0).oneWay() || each.traits(Kind.LINE, 1).oneWay())
          .isFalse();
    }
    assertThat(world.scene().traits(LINE, 0).restitution()).isEqualTo(0.25);
    assertThat(world.scene().traits(Kind.LINE, 0).oneWay()).isTrue();
  }

  private static void assertTraits(World world, Kind kind, int id, double e, Response r) {
    assertThat(world.traits(kind, id).restitution()).isEqualTo(e);
    assertThat(world.traits(kind, id).response()).isEqualTo(r);
  }

  /** More than a few lines, and more than are looked at beside a grid: it is made later. */
  @ParameterizedTest
  @ValueSource(ints = {9, 40, 1100})
  void linesAddedOneByOneActAsThoseOfAScene(int count) {
    for (boolean collide : new boolean[] {false, true}) {
      Random random = new Random(count);
      SceneBuilder builder = Scene.builder().bounds(0, 0, 800, 600).collide(collide);
      for (int i = 0; i < 20; i++) {
        builder.circle(20 + 35 * i, 300, 3 + i % 5, 6 * random.nextGaussian(), 4);
      }
      World world = world(builder);
      for (int i = 0; i < count; i++) {
        double x = 800 * random.nextDouble();
        double y = 600 * random.nextDouble();
        double bx = x + 10 * random.nextGaussian();
        double by = y + 10 * random.nextGaussian();
        builder.line(x, y, bx, by);
        assertThat(world.addLine(x, y, bx, by, Traits.DEFAULT)).isEqualTo(i);
        if (i % 7 == 0) {
          world.step(0); // impacts of now, in both orders the same: nothing overlaps twice
        }
      }
      World fresh = world(builder);
      Snapshot lines = world.snapshot();
      for (int i = 0; i < 20; i++) {
        Circle c = (Circle) world.scene().shape(Kind.CIRCLE, i);
        Vec2 v = world.scene().velocity(Kind.CIRCLE, i);
        world.setPosition(i, c.x(), c.y());
        world.setVelocity(i, v.x(), v.y());
      }
      assertThat(lines.state.obstacles()).isEqualTo(fresh.snapshot().state.obstacles());
      assertThat(Run.step(world, 1, 60)).isEqualTo(Run.step(fresh, 1, 60));
    }
  }

  // Unfinished.

  /** A circle in a corridor as wide as itself never comes to an end; an edit sets it free. */
  @Tag("long")
  @CollidingOrNot
  void anUnfinishedWorldCanBeEdited(boolean collide) {
    World world =
        world(
            Scene.builder()
                .collide(collide)
                .line(0, 0, 1e9, 0)
                .line(0, 2 + 0x1p-30, 1e9, 2 + 0x1p-30)
                .circle(1, 1, 1, 1e-3, 1)
                .circle(1, 9, 1, 0, 1));
    assertThatThrownBy(() -> world.step(1)).isInstanceOf(UnfinishedException.class);
    double reached = world.now();
    assertThat(reached).isLessThan(1);
    world.remove(LINE, 1);
    world.setVelocity(0, 0, 4);
    world.setVelocity(1, 0, 5);
    world.step(2);
    assertThat(world.now()).isEqualTo(reached + 2);
    assertThat(world.vy(1)).isEqualTo(5);
    assertThat(world.y(0)).isGreaterThan(7);
  }

  /** So large that places a few steps ahead are beyond the range of doubles. */
  private static final double S = 1e306;

  private static void assertHarmless(boolean collide, double v, Consumer<World> edit) {
    SceneBuilder scene =
        Scene.builder()
            .collide(collide)
            .line(60 * S, 20 * S, 60 * S, 100 * S)
            .circle(0, 0, S, v, 0)
            .circle(50 * S, 50 * S, 5 * S, S, 0);
    World world = world(scene);
    world.step(2);
    assertThat(world.x(0)).isEqualTo(v * Double.POSITIVE_INFINITY);
    edit.accept(world);
    for (int i = 0; i < 4; i++) {
      world.step(1);
      for (int id = 0; id < world.idLimit(CIRCLE); id++) {
        if (world.contains(CIRCLE, id)) {
          assertThat(world.x(id) + world.y(id)).isNotNaN();
          assertThat(world.vx(id) + world.vy(id)).isFinite();
        }
      }
    }
    World other = world(scene);
    other.restore(world.snapshot());
    other.step(5);
    world.step(5);
    assertThat(other.snapshot()).isEqualTo(world.snapshot());
  }

  @CollidingOrNot
  void aCircleBeyondTheRangeOfDoublesCanBeEdited(boolean collide) {
    for (double v : new double[] {100 * S, -100 * S}) {
      assertHarmless(collide, v, w -> w.setVelocity(0, -v, 1));
      assertHarmless(collide, v, w -> w.setVelocity(0, 0, 0));
      assertHarmless(collide, v, w -> setRadius(w, S / 2));
      assertHarmless(collide, v, w -> setRadius(w, 7 * S));
      assertHarmless(
          collide,
          v,
          w -> w.setTraits(CIRCLE, 0, w.traits(CIRCLE, 0).withResponse(Response.SENSOR)));
      assertHarmless(collide, v, w -> w.addLine(0, 0, S, S, Traits.DEFAULT));
      assertHarmless(collide, v, w -> w.addCircle(0, 0, S, S, S, Traits.DEFAULT));
      assertHarmless(
          collide,
          v,
          w -> {
            w.setPosition(0, 40 * S, 50 * S);
            w.setVelocity(0, S, 0);
          });
      assertHarmless(collide, v, w -> w.remove(CIRCLE, 1));
    }
  }

  /** The centre stays where the world says that it is, within the doubles. */
  private static void setRadius(World world, double radius) {
    Circle now = (Circle) world.shape(CIRCLE, 0);
    world.setShape(CIRCLE, 0, new Circle(now.center(), radius));
  }

  /** Far out, but not put there: that does not keep a radius from being set. */
  @Test
  void theRadiusOfACircleThatFlewFarCanBeSet() {
    World world = world(Scene.builder().circle(0, 0, 1, 1e20, 0));
    world.step(1);
    world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), 2));
    assertThat(world.radius(0)).isEqualTo(2);
  }
}
