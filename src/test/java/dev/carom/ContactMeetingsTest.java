// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.Consumer;
import java.util.function.Function;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Balls at rest that something else comes to; solid polygons and traces beside what they equal. */
class ContactMeetingsTest {

  private static final double FRAME = 0.1;

  private static SceneBuilder falling() {
    return Scene.builder().gravity(0, -10);
  }

  private static SceneBuilder wedge(SceneBuilder scene) {
    return scene.line(-10, 10, 0, 0).line(0, 0, 10, 10);
  }

  private static ContactRun run(SceneBuilder scene) {
    return new ContactRun(new World(scene.build())).withMovers();
  }

  /** A line sweeps a ball up the side of a wedge; it comes back, as if it were alone. */
  @ParameterizedTest
  @CsvSource({"0, true", "0.5, true", "0, false", "0.5, false"})
  void aLineWakesABallAtRest(double e, boolean collide) {
    SceneBuilder scene = wedge(falling().collide(collide)).line(-60, 1, -60, 5).velocity(2, 0);
    ContactRun run = run(scene.circle(0, 4, 1, 0, 0).restitution(e));
    run.play(20);
    assertThat(run.world.isResting(0)).isTrue();
    double low = run.world.y(0);
    Trajectory trace = run.world.trace(0, 0, 0, 40, 10_000);
    double highest = low;
    for (double t = 20 + FRAME; t < 60; t += FRAME) {
      run.play(t);
      highest = Math.max(highest, run.world.y(0));
    }
    assertThat(run.faults()).isEmpty();
    assertThat(highest).isGreaterThan(low + 1);
    assertThat(run.world.isResting(0)).isTrue();
    assertThat(trace.at(40).y()).isEqualTo(run.world.y(0), within(1e-9));
  }

  /** Two cradles that move towards each other, each with a ball at rest in it. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void ballsInCradlesMeet(double e) {
    SceneBuilder scene = falling();
    for (int side = -1; side <= 1; side += 2) {
      double x = 10 * side;
      scene.line(x + 10 * side, 5, x, 0).velocity(-side, 0);
      scene.line(x, 0, x - 3 * side, 1.5).velocity(-side, 0);
      scene.circle(x, 4, 2, -side, 0).restitution(e);
    }
    ContactRun run = run(scene);
    run.play(6);
    assertThat(run.resting()).isEqualTo(2);
    run.play(9);
    assertThat(run.faults()).isEmpty();
    assertThat(run.resting()).isZero();
    assertThat(run.world.x(1) - run.world.x(0)).isBetween(3.9, 6.0);
  }

  /** Nothing moves an infinite mass, and it moves what rests. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aMassPushesABallAtRest(double e) {
    SceneBuilder scene = falling().line(-10, 5, 0, 0).line(0, 0, 3, 1.5);
    scene.circle(0, 4, 2, 0, 0).restitution(e);
    ContactRun run = run(scene.circle(40, 3.5, 2, -1, 0).mass(Double.POSITIVE_INFINITY));
    run.play(34);
    assertThat(run.world.isResting(0)).isTrue();
    run.play(39);
    assertThat(run.faults()).isEmpty();
    assertThat(run.world.x(0)).isLessThan(-1);
    assertThat(run.world.x(1)).isEqualTo(1, within(1e-12));
  }

  @SuppressWarnings("ImmutableEnumChecker") // each ball is added by a function without state
  private enum Ground {
    TABLE(s -> s.circle(-10, 1, 1, 1.5, 0), -50, 0, 0, 0, 0, -40, -50, -40),
    ROOF(s -> s.circle(0.001, 12, 1, 0, 0), 0, 10, -10, 0, -10, -5, 10, -5, 10, 0),
    SPIRE(s -> s.circle(0.3, 12, 1, 0, 0), 0, 10, -1, 0, -1, -5, 1, -5, 1, 0),
    WEDGE(s -> s.circle(-3, 7, 1, 0, 0), -10, 10, 0, 0, 10, 10, 10, -5, -10, -5),
    PIT(s -> s.circle(-2, 3, 1, 0.3, 0), -9, 0, -3, 0, -3, -4, 3, -4, 3, 0, 9, 0, 9, -8, -9, -8),
    GAP(s -> s.circle(0.3, 3, 2, 0, 0), -9, 0, -1, 0, -1, -6, 1, -6, 1, 0, 9, 0, 9, -8, -9, -8);

    private final Function<SceneBuilder, SceneBuilder> ball;
    private final double[] xy;

    Ground(Function<SceneBuilder, SceneBuilder> ball, double... xy) {
      this.ball = ball;
      this.xy = xy;
    }

    World world(double e, Consumer<SceneBuilder> ground) {
      SceneBuilder scene = falling();
      ground.accept(scene);
      return new World(ball.apply(scene).restitution(e).build());
    }
  }

  /** A ball outside of a solid polygon moves as among its sides. */
  @ParameterizedTest
  @EnumSource
  void aSolidPolygonCarriesAsItsSides(Ground ground) {
    Outline outline = Outline.polygon(ground.xy);
    for (double e : new double[] {0, 0.5}) {
      World solid = ground.world(e, scene -> scene.outline(outline));
      World sides =
          ground.world(
              e,
              scene -> {
                for (int i = 0; i < outline.points().size(); i++) {
                  Line side = outline.side(i);
                  scene.line(side.ax(), side.ay(), side.bx(), side.by());
                }
              });
      for (double t = FRAME; t < 20; t += FRAME) {
        solid.advanceTo(t);
        sides.advanceTo(t);
        assertThat(solid.x(0)).as("x at %s", t).isEqualTo(sides.x(0));
        assertThat(solid.y(0)).as("y at %s", t).isEqualTo(sides.y(0));
      }
    }
  }

  @SuppressWarnings("ImmutableEnumChecker") // each motion is started by a function without state
  private enum Motion {
    WEDGE_GOES(-10, w -> w.moveTo(Kind.LINE, 0, -5, 12, 7)),
    WEDGE_TURNS(-10, w -> w.turn(Kind.LINE, 0, 0, 0, 0.3, 7)),
    HALF_GOES(-10, w -> w.moveTo(Kind.LINE, 2, 20, 0, 7)),
    TRAY_GOES(-10, w -> w.moveTo(Kind.LINE, 1, -25, 3, 7)),
    TRAY_TURNS(-10, w -> w.turn(Kind.LINE, 1, -25, 0, 0.2, 7)),
    WEIGHTLESS(0, w -> w.turn(Kind.LINE, 1, -60, 0, 0.3, 7));

    private final double gravity;
    private final Consumer<World> start;

    Motion(double gravity, Consumer<World> start) {
      this.gravity = gravity;
      this.start = start;
    }
  }

  /** The trace of each of three balls, on what moves and arrives, is the path that it takes. */
  @ParameterizedTest
  @EnumSource
  void aTraceOnWhatMovesIsThePath(Motion motion) {
    for (double e : new double[] {0, 0.5}) {
      SceneBuilder scene = Scene.builder().collide(false).gravity(0, motion.gravity);
      scene.outline(Outline.polyline(-10, 10, 0, 0, 10, 10)).line(-60, 0, -15, 0).restitution(e);
      scene.line(30, 10, 40, 0).restitution(e).line(40, 0, 50, 10).restitution(e);
      scene.circle(0, 4, 1, 0.3, -1).restitution(e).circle(-25, 2, 1, 0.1, -1).restitution(e);
      World world = new World(scene.circle(40, 4, 1, 0.3, -1).restitution(e).build());
      motion.start.accept(world);
      for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
        Trajectory trace = world.trace(i, world.vx(i), world.vy(i), 15, 10_000);
        World played = new World(world.scene());
        motion.start.accept(played);
        for (double t = FRAME; t < 15; t += FRAME) {
          played.advanceTo(t);
          assertThat(trace.at(t).x())
              .as("x of %s at %s", i, t)
              .isEqualTo(played.x(i), within(1e-9));
          assertThat(trace.at(t).y())
              .as("y of %s at %s", i, t)
              .isEqualTo(played.y(i), within(1e-9));
        }
      }
    }
  }
}
