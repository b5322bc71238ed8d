// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.Line;
import dev.carom.Resolver;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.SweptSphere;
import dev.carom.Trajectory;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The same bounces in every unit: speeds of 1e-300 and 1e150, huge and tiny coordinates. */
class MagnitudeTest {

  private static World world(SceneBuilder builder) {
    return new World(builder.build());
  }

  private static SceneBuilder among(Line line) {
    return Scene.builder().line(line.ax(), line.ay(), line.bx(), line.by());
  }

  private static List<Impact> advance(World world, double t) {
    world.advanceTo(t);
    return Run.rows(world.impacts());
  }

  /** A slope of 45 degrees turns what comes straight down into the horizontal. */
  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "1, 1e-300",
    "1, 1e150",
    "1, 1e300",
    "1e150, 1e150",
    "1e150, 1e-300",
    "1e-30, 1e-300",
    "1e-150, 1e-150",
    "1e-150, 1e150",
    "1e-290, 1",
    "1e300, 1e300",
    "1e-30, 5e-324"
  })
  void aSlopeTurnsACircleAside(double size, double speed) {
    Line slope = new Line(-10 * size, -10 * size, 10 * size, 10 * size);
    World world = world(among(slope).circle(0, 5 * size, size, 0, -speed));
    double t = (5 - Math.sqrt(2)) * size / speed;
    List<Impact> hits = advance(world, Math.min(2 * t, Double.MAX_VALUE));
    if (t > Double.MAX_VALUE) {
      assertThat(hits).as("beyond the last finite time").isEmpty();
      return;
    }
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).time()).isCloseTo(t, within(1e-15 * t));
    assertThat(hits.get(0).approachSpeed())
        .isCloseTo(speed * Math.sqrt(0.5), within(1e-15 * speed + 1e-323));
    assertThat(world.vx(0)).isCloseTo(-speed, within(1e-15 * speed + 1e-323));
    assertThat(world.vy(0)).isCloseTo(0, within(1e-15 * speed + 1e-323));
  }

  @ParameterizedTest
  @CsvSource({"1, 1e-300", "1, 1e150", "1e150, 1e150", "1e-150, 1e-150", "1e-290, 1", "1e300, 1e7"})
  void aPegSendsBack(double size, double speed) {
    World world = world(Scene.builder().peg(0, 0, size).circle(5 * size, 0, size, -speed, 0));
    List<Impact> hits = advance(world, 6 * (size / speed));
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).time()).isCloseTo(3 * (size / speed), within(1e-15 * (size / speed)));
    assertThat(world.vx(0)).isEqualTo(speed);
  }

  /** Textbook impulses divide by d.d, which is 0 or infinite for half of these. */
  @ParameterizedTest
  @CsvSource({"1, 1e-300", "1, 1e150", "1e200, 1e200", "1e-200, 1e-200", "1e-290, 1", "1e300, 1e7"})
  void aPairSwapsItsVelocities(double size, double speed) {
    World world =
        world(Scene.builder().circle(0, 0, size, speed, 0).circle(5 * size, 0, size, 0, 0));
    assertThat(advance(world, 4 * (size / speed))).hasSize(1);
    assertThat(world.vx(0)).isCloseTo(0, within(1e-31 * speed));
    assertThat(world.vx(1)).isEqualTo(speed);
  }

  /** A circle beyond the range of doubles has infinite coordinates, and hits nothing. */
  @Test
  void beyondTheRangeOfDoublesPlacesAreInfinite() {
    assertThat(0 * (0 + 1e300 * 1e300)).as("what a naive product leaves").isNaN();

    World world = world(Scene.builder().line(5, -1, 5, 1).circle(0, 9, 2, 1e300, 0));
    assertThat(advance(world, 1e10)).isEmpty();
    assertThat(world.x(0)).isInfinite();
    assertThat(world.y(0)).isEqualTo(9);
    assertThat(advance(world, 2e10)).isEmpty();
    assertThat(world.x(0)).isInfinite();
    world.setPosition(0, 0, 0);
    world.setVelocity(0, 1, 0);
    world.step(1);
    assertThat(world.x(0)).as("called back").isEqualTo(1);
  }

  /** The difference of two speeds is beyond the range of doubles, the velocities after are not. */
  @Test
  void theFastestPairSwapsItsVelocities() {
    double most = Double.MAX_VALUE;
    assertThat(most - -most).as("the naive relative speed").isInfinite();

    World world = world(Scene.builder().circle(0, 0, 1, most, 0).circle(4, 0, 1, -most, 0));
    List<Impact> hits = advance(world, 1e-307);
    assertThat(hits).hasSize(1);
    assertThat(hits.get(0).approachSpeed()).as("as documented").isInfinite();
    assertThat(world.vx(0)).isEqualTo(-most);
    assertThat(world.vx(1)).isEqualTo(most);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-300, 1, 1e150, 1e300, 8e307})
  void spheresSwapTheirVelocities(double speed) {
    double[] v = {speed, 0, 0, -speed, 0, 0};
    SweptSphere.respond(
        new SweptSphere(-1e300, 0, 0, 0, v[0], v[1], v[2]),
        1,
        new SweptSphere(1e300, 0, 0, 0, v[3], v[4], v[5]),
        1,
        1,
        v);
    assertThat(v).containsExactly(-speed, 0, 0, speed, 0, 0);
  }

  @Test
  void aReboundFasterThanDoublesCanTellStops() {
    World world = world(among(new Line(0, -9, 0, 9)).restitution(1e10).circle(5, 0, 1, -1e300, 0));
    assertThat(advance(world, 1)).hasSize(1);
    assertThat(world.x(0)).isCloseTo(1, within(1e-15));
    assertThat(Math.hypot(world.vx(0), world.vy(0))).isZero();
  }

  /** The relative velocity is no double; its part along the normal, 60 degrees aside, is one. */
  @Test
  void anApproachIsToldIfItIsADouble() {
    double aside = Math.sqrt(1.5);
    Circle first = new Circle(0, 0, 1);
    Circle second = new Circle(10 - aside, 10 + aside, 1);
    Vec2 v = new Vec2(1e308, 1e308);
    Impact hit =
        new SweptCircle(first, v)
            .cast(new SweptCircle(second, new Vec2(-1e308, -1e308)), 1)
            .orElseThrow();
    assertThat(hit.approachSpeed() / 1e308).isCloseTo(Math.sqrt(2), within(1e-12));
  }

  /** It touches at 0.6 of its radius from the middle: of the way, no digit tells where. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p-40, 0x1p-100, 0x1p-300, 0x1p-900})
  void theNormalOfASpeckIsAccurate(double radius) {
    Circle circle = new Circle(1, 0.6 * radius, radius / 2);
    Circle speck = new Circle(0, 0, radius / 2);
    Impact hit = new SweptCircle(circle, new Vec2(-1, 0)).cast(speck, 1).orElseThrow();
    assertThat(hit.normal().x()).isCloseTo(0.8, within(1e-15));
    assertThat(hit.normal().y()).isCloseTo(0.6, within(1e-15));
  }

  /** Two circles with radii that add up to 1, and a way that is far longer. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p130, 0x1p300, 0x1p900})
  void theNormalAfterALongWayIsAccurate(double way) {
    Circle circle = new Circle(way, 0.6, 0.5);
    Impact hit =
        new SweptCircle(circle, new Vec2(-1, 0)).cast(new Circle(0, 0, 0.5), way).orElseThrow();
    assertThat(hit.normal().x()).isCloseTo(0.8, within(1e-15));
    assertThat(hit.normal().y()).isCloseTo(0.6, within(1e-15));
  }

  /**
   * The same scene, moved by 2^30: the centre at the impact is rounded to 2^-22, its offset from
   * the peg is not. The normal of rounded coordinates would err by up to 2^-23 / 10.
   */
  @Test
  void theNormalIsAsAccurateFarFromTheOrigin() {
    double far = 0x1p30;
    double worst = 0;
    for (int k = 1; k < 64; k++) {
      Circle circle = new Circle(-32, k / 8.0, 9);
      Circle moved = new Circle(far - 32, far + k / 8.0, 9);
      Circle peg = new Circle(0, 0, 1);
      Vec2 v = new Vec2(3, 0.125);
      Impact near =
          Resolver.of(List.of(peg))
              .trace(new SweptCircle(circle, v), 1, 20, Integer.MAX_VALUE)
              .impacts()
              .get(0);
      Trajectory way =
          Resolver.of(List.of(new Circle(far, far, 1)))
              .trace(new SweptCircle(moved, v), 1, 20, Integer.MAX_VALUE);
      Impact there = way.impacts().get(0);
      assertThat(there.time()).isEqualTo(near.time());
      Vec2 centre = way.points().get(1);
      worst = Math.max(worst, Math.abs((centre.x() - far) / 10 - near.normal().x()));
      assertThat(there.normal().x()).isCloseTo(near.normal().x(), within(0x1p-50));
      assertThat(there.normal().y()).isCloseTo(near.normal().y(), within(0x1p-50));
    }
    assertThat(worst).as("naive: of the rounded centre").isGreaterThan(0x1p-28);
  }
}
