// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** One circle among obstacles, without a world: what it hits first, its way, and one reflection. */
class ResolverTest {

  private static final double FOREVER = Double.POSITIVE_INFINITY;
  private static final Line FLOOR = new Line(-100, 0, 100, 0);
  private static final Vec2 DOWN = new Vec2(0, -1);

  @Test
  @Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void aCastForEverEndsWithOrWithoutAnImpact() {
    Resolver resolver = Resolver.of(List.of(FLOOR));
    Circle circle = new Circle(0, 10, 1);
    assertThat(resolver.cast(new SweptCircle(circle, DOWN), FOREVER).orElseThrow().time())
        .isEqualTo(9);
    assertThat(resolver.cast(new SweptCircle(circle, new Vec2(0, 1)), FOREVER)).isEmpty();
  }

  @Test
  void theWayEndsUnfinishedWhereTheBudgetIsSpent() {
    Resolver resolver = Resolver.of(List.of(new Bounds(0, 0, 3, 3)));
    Trajectory way =
        resolver.trace(
            new SweptCircle(new Circle(1, 1.5, 1), new Vec2(1, 0)), 1, 1e6, Integer.MAX_VALUE);
    assertThat(way.complete()).isFalse();
    assertThat(way.impacts()).hasSize(Questions.IMPACTS_PER_TRACE);
    assertThat(way.duration()).isEqualTo(Questions.IMPACTS_PER_TRACE);
    assertThat(way.end()).isEqualTo(new Vec2(1, 1.5));
    SweptCircle circle = new SweptCircle(1, 1.5, 1, 1, 0);
    assertThat(resolver.trace(circle, 1, 1e3, Integer.MAX_VALUE).complete()).isTrue();
  }

  /** From 2^55 radii the rounded centre can be anywhere in the peg: its own, or beyond. */
  @ParameterizedTest
  @CsvSource({"0x1p55, -0x1p53, 5", "0x1p60, -0x1p60, 2", "-0x1p200, 0x1p199, 3"})
  void aWayFromFarOffTurnsBackAtWhatItHitsHeadOn(double x, double vx, double duration) {
    for (Obstacle o : List.of(new Circle(0, 0, 1), new Circle(0, 0, 0))) {
      Trajectory way =
          Resolver.of(List.of(o))
              .trace(
                  new SweptCircle(new Circle(x, 0, 1), new Vec2(vx, 0)),
                  1,
                  duration,
                  Integer.MAX_VALUE);
      assertThat(way.impacts()).hasSize(1);
      assertThat(way.impacts().get(0).normal()).isEqualTo(new Vec2(Math.signum(x), 0));
      assertThat(way.complete()).isTrue();
      assertThat(Math.signum(way.end().x())).isEqualTo(Math.signum(x));
      assertThat(way.end().y()).isZero();
    }
  }

  @Test
  void aWayThatLeavesTheRangeOfDoublesEndsAtItsEdge() {
    Resolver resolver = Resolver.of(List.of(FLOOR));
    Trajectory way =
        resolver.trace(
            new SweptCircle(new Circle(0, 10, 1), new Vec2(1e300, -1e300)),
            1,
            1e300,
            Integer.MAX_VALUE);
    assertThat(way.impacts()).hasSize(1);
    assertThat(way.end()).isEqualTo(new Vec2(Double.MAX_VALUE, Double.MAX_VALUE));
    assertThat(way.points()).hasSize(3);
  }

  /** The offset is lost in the rounding of the centre: the normal is the detector's. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-18, 1e-100, 1e-300})
  void aRadiusFarBelowTheRoundingOfPlacesTurnsByTheDetectorsNormal(double radius) {
    Resolver resolver = Resolver.of(List.of(new Circle(1, 0, 0)));
    Trajectory way =
        resolver.trace(
            new SweptCircle(new Circle(0, 0, radius), new Vec2(1, 0)), 1, 3, Integer.MAX_VALUE);
    assertThat(way.impacts()).hasSize(1);
    assertThat(way.impacts().get(0).normal()).isEqualTo(new Vec2(-1, 0));
    assertThat(way.velocityAt(3)).isEqualTo(new Vec2(-1, 0));
  }

  // Reflections.

  @Test
  void reflectsAgainstTheNormalOnly() {
    Vec2 v = new Vec2(3, -4);
    assertThat(v.reflect(new Vec2(0, 2), 1)).isEqualTo(new Vec2(3, 4));
    assertThat(v.reflect(new Vec2(0, 2), 0.5)).isEqualTo(new Vec2(3, 2));
    assertThat(v.reflect(new Vec2(0, 2), 0)).isEqualTo(new Vec2(3, 0));
    assertThat(v.reflect(new Vec2(0, -2), 1)).as("leaving").isEqualTo(v);
    assertThat(v.reflect(new Vec2(4, 3), 1)).as("along").isEqualTo(v);
  }

  /** v.n and n.n leave the range of doubles in all of these but the first. */
  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "1, 1e-200",
    "1, 1e200",
    "1e-300, 1e-300",
    "1e300, 1e300",
    "1e-300, 1e300",
    "1e150, 1"
  })
  void reflectsAtAnySize(double speed, double length) {
    Vec2 v = new Vec2(0, -speed).reflect(new Vec2(length, length), 1);
    assertThat(v.x()).isCloseTo(speed, within(1e-15 * speed));
    assertThat(v.y()).isCloseTo(0, within(1e-15 * speed));
  }

  @Test
  void refusesWhatCannotBeReflected() {
    Vec2 up = new Vec2(0, 1);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> DOWN.reflect(Vec2.ZERO, 1))
        .withMessageContaining("normal is Vec2[x=0.0, y=0.0]");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> DOWN.reflect(up, Double.NaN))
        .withMessageContaining("restitution is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Vec2(0, -1e300).reflect(up, 1e300))
        .withMessageContaining("restitution is 1.0E300");
  }

  @Test
  void theLargestVelocityCanBeTurnedRound() {
    double most = Double.MAX_VALUE;
    assertThat(new Vec2(-most, 0).reflect(new Vec2(1, 0), 1)).isEqualTo(new Vec2(most, 0));
    assertThat(new Vec2(0, most).reflect(new Vec2(0, -1), 1)).isEqualTo(new Vec2(0, -most));
  }

  /** And so it is far away: 10^-9 beside a coordinate of 10^6. */
  @Test
  void farAwayItTurnsByTheDetectorsNormalToo() {
    Circle end = new Circle(1e6, 3e5, 0);
    Circle circle = new Circle(999_990, 3e5 + 6e-10, 1e-9);
    Vec2 velocity = new Vec2(1, 0);
    Vec2 truth = new SweptCircle(circle, velocity).cast(end, 20).orElseThrow().normal();
    assertThat(truth.y()).isBetween(0.5, 0.7);
    Trajectory way =
        Resolver.of(List.of(end))
            .trace(new SweptCircle(circle, velocity), 1, 20, Integer.MAX_VALUE);
    Vec2 normal = way.impacts().get(0).normal();
    assertThat(normal.x()).isCloseTo(truth.x(), within(1e-15));
    assertThat(normal.y()).isCloseTo(truth.y(), within(1e-15));
  }

  /** Impacts so soon that exact numbers tell when, on a slope of a thousand bits. */
  @Test
  void exactWorkIsPartOfTheBudget() {
    Resolver resolver = Resolver.of(List.of(new Line(0, 0, 8, 0x1p-1000), new Bounds(0, -9, 9, 4)));
    Trajectory way =
        resolver.trace(
            new SweptCircle(new Circle(4, 2, 1), new Vec2(0, -0x1p260)),
            1,
            12_000 * 0x1p-259,
            Integer.MAX_VALUE);
    assertThat(way.complete()).isFalse();
    assertThat(way.impacts()).hasSizeBetween(10, 12_000);
  }
}
