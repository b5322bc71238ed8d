// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** The path that a circle of a world would take. */
class PathOfACircleTest {

  /** It falls, bounces by its own restitution, and then does so. */
  @Test
  void isTheWayThatItThenGoesUnderGravity() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(-10, 0, 100, 0)
                .line(30, -5, 30, 50)
                .restitution(0.9)
                .circle(0, 5, 1, 0, 0)
                .restitution(0.8)
                .mass(3)
                .build());
    Trajectory path = world.trace(0, 7, 3, 8, 100);
    world.setVelocity(0, 7, 3);
    world.step(8);
    assertThat(path.duration()).isEqualTo(8);
    assertThat(path.end().x()).isCloseTo(world.x(0), within(1e-12));
    assertThat(path.end().y()).isCloseTo(world.y(0), within(1e-12));
    assertThat(path.impacts()).hasSameSizeAs(world.impacts()).hasSizeGreaterThan(3);
    for (int row = 0; row < path.impacts().size(); row++) {
      Impact expected = world.impacts().get(row);
      Impact impact = path.impacts().get(row);
      assertThat(impact.circle()).isZero();
      assertThat(impact.time()).isCloseTo(expected.time(), within(1e-12));
      assertThat(impact.impulse()).isCloseTo(expected.impulse(), within(1e-11));
      assertThat(impact.outcome()).isEqualTo(expected.outcome());
      assertThat(impact.id()).isEqualTo(expected.id());
    }
  }

  /** A bank shot: off the wall, past a sensor, onto a ball that moves on. */
  @Test
  void endsAtTheFirstBallInTheWayAndListsSensors() {
    SceneBuilder scene =
        Scene.builder()
            .bounds(0, 0, 100, 100)
            .line(60, 0, 60, 100)
            .response(Response.SENSOR)
            .circle(50, 50, 5, 0, 0)
            .circle(20, 20, 5, 0, 0)
            .circle(1, 50, 1, 2, 0);
    World world = new World(scene.build());
    world.remove(Kind.CIRCLE, 1);
    Trajectory path = world.trace(0, 10, 0, 100, 100);
    assertThat(path.impacts())
        .extracting(Impact::outcome)
        .containsExactly(Outcome.SENSED, Outcome.BOUNCED, Outcome.SENSED, Outcome.BOUNCED);
    assertThat(path.impacts())
        .extracting(Impact::kind)
        .containsExactly(Kind.LINE, Kind.WALL, Kind.LINE, Kind.CIRCLE);
    Impact last = path.impacts().get(3);
    // At t it is at 95 - 10 (t - 4.5), and the other one at 1 + 2 t, 6 to the left.
    double t = (95 + 45 - 7) / 12.0;
    assertThat(last.id()).isEqualTo(2);
    assertThat(last.time()).isCloseTo(t, within(1e-14));
    assertThat(last.x()).isCloseTo(2 + 2 * t, within(1e-13));
    assertThat(last.normal()).isEqualTo(new Vec2(1, 0));
    assertThat(last.approachSpeed()).isEqualTo(12);
    assertThat(last.impulse()).as("nobody moves by it").isZero();
    assertThat(path.duration()).isEqualTo(last.time());
    assertThat(path.complete()).isTrue();
    assertThat(path.points()).hasSize(3);
    assertThat(world.trace(0, 10, 0, 100, 1).duration()).as("sensors do not count").isEqualTo(4.5);
    Filter apart = new Filter(2, 2);
    world.setTraits(Kind.CIRCLE, 2, Traits.DEFAULT.withFilter(apart));
    assertThat(world.trace(0, 10, 0, 10, 100).impacts())
        .extracting(Impact::kind)
        .doesNotContain(Kind.CIRCLE);
  }

  @Test
  void knowsWhatTheWorldThenDoes() {
    Random random = new Random(5);
    int hits = 0;
    for (int k = 0; k < 200; k++) {
      SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 40).gravity(0, -1).line(9, 9, 30, 12);
      for (int i = 0; i < 4; i++) {
        scene.circle(4 + 10 * i, 30 - 3 * i, 1, random.nextGaussian(), random.nextGaussian());
      }
      World world = new World(scene.build());
      Trajectory path = world.trace(0, 30, -9 + 3 * random.nextGaussian(), 20, 3);
      Vec2 v = path.velocityAt(0);
      world.setVelocity(0, v.x(), v.y());
      world.step(20);
      if (path.impacts().isEmpty()) {
        continue;
      }
      for (Impact expected : world.impacts()) {
        if (expected.involves(Kind.CIRCLE, 0)) {
          Impact first = path.impacts().get(0);
          if (expected.time() <= firstAmongOthers(world)) {
            assertThat(first.time()).as("%s", k).isCloseTo(expected.time(), within(1e-12));
            hits += first.kind() == Kind.CIRCLE ? 1 : 0;
          }
          break;
        }
      }
    }
    assertThat(hits).isGreaterThan(10);
  }

  /** The time of the first impact that circle 0 has no part in: from then on the others turn. */
  private static double firstAmongOthers(World world) {
    for (Impact impact : world.impacts()) {
      if (!impact.involves(Kind.CIRCLE, 0)) {
        return impact.time();
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  @Test
  void aFlightHasTheAccelerationOfTheCircle() {
    World world =
        new World(
            Scene.builder()
                .collide(false)
                .gravity(0, -10)
                .circle(0, 5, 1, 2, 3)
                .circle(9, 5, 1, 2, 3)
                .mass(Double.POSITIVE_INFINITY)
                .line(-99, 0, 99, 0)
                .build());
    assertThat(world.flight(0)).isEqualTo(new SweptCircle(0, 5, 1, 2, 3, 0, -10));
    assertThat(world.flight(1)).isEqualTo(new SweptCircle(9, 5, 1, 2, 3));
    assertThat(world.trace(1, 2, 3, 9, 9).impacts()).isEmpty();
    Impact hit = world.cast(world.flight(0), 10).orElseThrow();
    assertThat(hit.time()).isCloseTo((3 + Math.sqrt(89)) / 10, within(1e-15));
  }

  /** One that falls as a circle of the world does meets it as if both flew straight. */
  @Test
  void aCastFallsBesideCirclesThatFall() {
    Scene scene = Scene.builder().gravity(0, -10).circle(20, 0, 1, -1, 0).mass(2).build();
    World world = new World(scene);
    Impact hit = world.cast(new SweptCircle(0, 0, 1, 2, 0, 0, -10), 9).orElseThrow();
    assertThat(hit.time()).isEqualTo(6);
    assertThat(hit.point()).isEqualTo(new Vec2(13, -180));
    assertThat(hit.normal()).isEqualTo(new Vec2(-1, 0));
    Impact up = world.cast(new SweptCircle(20, -100, 1, -1, 0, 0, 10), 9).orElseThrow();
    assertThat(up.time()).isCloseTo(Math.sqrt(9.8), within(1e-15));
    assertThat(up.normal()).isEqualTo(new Vec2(0, -1));
  }

  @Test
  void isRefusedByName() {
    World world = new World(Scene.builder().circle(0, 0, 1, 0, 0).build());
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.trace(0, Double.NaN, 0, 1, 1))
        .withMessageContaining("vx is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.trace(0, 0, 0, -1, 1))
        .withMessageContaining("duration is -1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.trace(0, 0, 0, 1, -1))
        .withMessageContaining("impacts is -1");
    assertThatThrownBy(() -> world.trace(1, 0, 0, 1, 1))
        .isInstanceOf(IndexOutOfBoundsException.class)
        .hasMessageContaining("circle 1");
    assertThatThrownBy(() -> world.flight(1)).isInstanceOf(IndexOutOfBoundsException.class);
  }
}
