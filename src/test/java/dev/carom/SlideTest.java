// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles that slide and roll without friction under gravity: slopes, tables, joints, pegs. */
class SlideTest {

  @Test
  void aBallSlidesDownASlope() {
    double r = 2;
    // It touches the slope from its left, above.
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 40, 30)
                .circle(32 - 0.6 * r, 24 + 0.8 * r, r, 0, 0)
                .restitution(0)
                .build());
    assertThat(rows(world, 1)).isEqualTo(1);
    assertThat(world.impacts().outcome(0)).isEqualTo(Outcome.SETTLED);
    // The acceleration along it is g sin a = 6: 3 units of length in a second.
    assertThat(world.x(0)).isCloseTo(32 - 0.6 * r - 3 * 0.8, within(1e-13));
    assertThat(world.y(0)).isCloseTo(24 + 0.8 * r - 3 * 0.6, within(1e-13));
    assertThat(Math.hypot(world.vx(0), world.vy(0))).isCloseTo(6, within(1e-13));
  }

  /** Gravity presses it by less than rounding tells, and it came back and back. */
  @Test
  void aBallWithoutBounceFallsAlongALineThatIsNearlyVertical() {
    Random random = new Random(1);
    double ulp = Math.ulp(21.6);
    for (int i = 0; i < 20; i++) {
      double x = 21.6 + random.nextInt(4) * ulp;
      World world =
          new World(
              Scene.builder()
                  .gravity(0, -50)
                  .line(x, -20, 21.6 - random.nextInt(4) * ulp, -60)
                  .restitution(0)
                  .circle(17 * random.nextDouble(), -30, 3.5, 50, 5 * random.nextDouble())
                  .collide(i % 2 == 0)
                  .build());
      double vy = world.vy(0);
      assertThat(world.advanceTo(0.5, 100)).isTrue();
      assertThat(world.y(0)).isCloseTo(-30 + 0.5 * vy - 50 * 0.125, within(1e-12));
      assertThat(world.x(0)).isCloseTo(21.6 - 3.5, within(1e-13));
    }
  }

  @Test
  void aBallRollsOffATableAndFalls() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 10, 0)
                .circle(5, 1, 1, 4, 0)
                .restitution(0)
                .build());
    world.advanceTo(1); // it leaves the edge at 1.25
    assertThat(world.y(0)).isEqualTo(1);
    // v^2 / r = 16 is more than g = 10: it flies off.
    world.advanceTo(2);
    assertThat(world.x(0)).isCloseTo(13, within(1e-13));
    assertThat(world.y(0)).isCloseTo(1 - 5 * 0.75 * 0.75, within(1e-13));
  }

  @Test
  void theEndOfASlideIsNoImpact() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(0, 0, 10, 0)
                .line(5, -20, 40, -20)
                .circle(5, 1, 1, 4, 0)
                .restitution(0)
                .build());
    assertThat(world.advanceToImpact(10)).isTrue();
    assertThat(world.now()).isZero();
    assertThat(world.advanceToImpact(10)).isTrue();
    assertThat(world.now()).isCloseTo(1.25 + 2, within(1e-12));
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.advanceToImpact(4)).isFalse();
  }

  /** The end of a slide does not count as an impact, nor end the path after the last one. */
  @Test
  void theEndOfASlideDoesNotEndAPath() {
    Resolver resolver = Scene.builder().gravity(0, -10).line(0, 0, 10, -1).build().resolver();
    for (int impacts : new int[] {2, 3}) {
      Trajectory path = resolver.trace(new SweptCircle(1, 3, 1, 0, 0, 0, -10), 0, 100, impacts);
      assertThat(path.impacts()).hasSize(1);
      assertThat(path.complete()).isTrue();
      assertThat(path.duration()).isEqualTo(100);
      assertThat(path.at(100).y()).isLessThan(-1000);
    }
  }

  /**
   * Lines in one place lead a circle as one does: it slides along all of them, and off their end.
   */
  @Test
  void linesInOnePlaceLeadACircleAsOneDoes() {
    Random random = new Random(4);
    for (int k = 0; k < 300; k++) {
      double x = 1 + random.nextInt(20);
      double y = -1 - random.nextInt(20);
      double share = random.nextInt(10) / 10.0;
      double length = Math.hypot(x, y);
      Circle start = new Circle(0.3 * x - y / length, 0.3 * y + x / length, 0.5);
      SceneBuilder one = Scene.builder().gravity(0, -10).line(0, 0, x, y).restitution(0);
      SceneBuilder several = Scene.builder().gravity(0, -10).line(0, 0, x, y).restitution(0);
      several.line(share * x, share * y, x, y).restitution(0);
      if (random.nextBoolean()) {
        several.line(0, 0, x, y).restitution(0);
      }
      World expected = new World(one.circle(start.x(), start.y(), 0.5, 0, 0).build());
      Resolver resolver = several.build().resolver();
      World world = new World(several.circle(start.x(), start.y(), 0.5, 0, 0).build());
      expected.advanceTo(20);
      world.advanceTo(20);
      assertThat(world.x(0)).isCloseTo(expected.x(0), withinPercentage(0.1));
      assertThat(world.impacts().size()).isLessThan(expected.impacts().size() + 10);
      Trajectory path =
          resolver.trace(new SweptCircle(start, Vec2.ZERO).withAcceleration(0, -10), 1, 20, 100);
      assertThat(path.complete()).isTrue();
      assertThat(path.at(20).x()).isCloseTo(expected.x(0), withinPercentage(0.1));
    }
  }

  /** Above an end, too fast to roll round it: it flies off, and does not meet the end for ever. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 2.2, 2.3, 5})
  void aFastCircleFliesOffTheEndThatItStandsOn(double speed) {
    for (double e : new double[] {0, 0.5, 1}) {
      World world =
          new World(
              Scene.builder()
                  .gravity(0, -10)
                  .line(0, 0, 2, 0)
                  .line(2, 0, 4, 0)
                  .circle(2, 0.5, 0.5, -speed, 0)
                  .restitution(e)
                  .build());
      world.advanceTo(1);
      assertThat(world.x(0)).isLessThan(2 - 0.9 * speed);
    }
  }

  /**
   * Lines that end in one place up to rounding do not hand the circle to each other without end.
   */
  @Test
  void linesThatEndInOnePlaceLetACircleGo() {
    double x = 0.4112362163282839;
    double y = -0.8072526941035818;
    Resolver resolver =
        Scene.builder()
            .gravity(0, -10)
            .line(-7.627487071597178, -0.6103514754229682, x, y)
            .restitution(0)
            .line(-5.59589146650096, -0.6601135627820988, 0.41123621632826257, -0.8072526941035814)
            .restitution(0)
            .line(-7.627487071597178, -0.6103514754229682, 0.4112362163282837, -0.8072526941035816)
            .restitution(0)
            .build()
            .resolver();
    Trajectory path = resolver.trace(new SweptCircle(-1.68, 1.244, 0.5, 0, 0, 0, -10), 0, 100, 100);
    assertThat(path.complete()).isTrue();
    assertThat(path.points().size()).isLessThan(60);
  }

  /** It slides down a one-way line, over its end, and falls. */
  @Test
  void aSlideOverTheEndOfAOneWayLineEnds() {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -0.05)
                .line(37.0736870438307, 29.673872064985886, 64.89725657887169, 19.673872064985886)
                .restitution(0)
                .oneWay()
                .circle(
                    38.370167761321746,
                    31.750252046047443,
                    2.392511739997577,
                    -0.7834496936715969,
                    0.2815777079518574)
                .build());
    world.advanceTo(100);
    assertThat(world.y(0)).isLessThan(0);
  }
}
