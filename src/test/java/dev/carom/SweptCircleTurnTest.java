// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Casts against a line that turns, with answers in closed form. */
class SweptCircleTurnTest {
  private static final double ANGLE = Math.toRadians(50);
  private static final double ARRIVAL = 0.025;
  private static final Line FLIPPER = new Line(0, 0, 8, 0);

  /** When a turn has come to an angle, and its rate then. */
  private static double timeAt(double angle) {
    double part = Math.tan(angle / 2);
    double q1 = (Math.cos(ANGLE / 2) - 1) / ARRIVAL;
    double q2 = Math.sin(ANGLE / 2) / ARRIVAL;
    return part / (q2 - q1 * part);
  }

  private static double rateAt(double t) {
    double x = 1 + (Math.cos(ANGLE / 2) - 1) * t / ARRIVAL;
    double y = Math.sin(ANGLE / 2) * t / ARRIVAL;
    return 2 * Math.sin(ANGLE / 2) / ARRIVAL / (x * x + y * y);
  }

  /** The line is a radius from a ball at rest when the sine of the angle between is 1 / sqrt 40. */
  @Test
  void aFlipperStrikesABallAtRest() {
    Impact impact =
        new SweptCircle(6, 2, 1, 0, 0).cast(FLIPPER, Vec2.ZERO, ANGLE, ARRIVAL, 1).get();

    double angle = Math.atan2(2, 6) - Math.asin(1 / Math.sqrt(40));
    double t = timeAt(angle);
    assertThat(impact.time()).isCloseTo(t, within(1e-16));
    assertThat(impact.feature()).isEqualTo(Feature.SIDE);
    assertThat(impact.nx()).isCloseTo(-Math.sin(angle), within(1e-15));
    assertThat(impact.ny()).isCloseTo(Math.cos(angle), within(1e-15));
    assertThat(impact.x()).isCloseTo(6 + Math.sin(angle), within(1e-14));
    assertThat(impact.y()).isCloseTo(2 - Math.cos(angle), within(1e-14));
    assertThat(impact.approachSpeed()).isCloseTo(rateAt(t) * Math.sqrt(39), within(1e-12));
  }

  /** A ball just beyond the tip is struck by that. */
  @Test
  void theTipStrikesABall() {
    Impact impact =
        new SweptCircle(8.5, 2, 1, 0, 0).cast(FLIPPER, Vec2.ZERO, ANGLE, ARRIVAL, 1).get();

    // The distance of (8.5, 2) from the tip at radius 8 is 1. The arc cosine loses a digit or two.
    double far = 8.5 * 8.5 + 4;
    double angle = Math.atan2(2, 8.5) - Math.acos((far + 64 - 1) / (2 * 8 * Math.sqrt(far)));
    assertThat(impact.time()).isCloseTo(timeAt(angle), within(1e-16));
    assertThat(impact.feature()).isEqualTo(Feature.END);
    assertThat(impact.x()).isCloseTo(8 * Math.cos(angle), within(1e-13));
    assertThat(impact.y()).isCloseTo(8 * Math.sin(angle), within(1e-13));
  }

  /** Turned the other way, it never comes. */
  @Test
  void aFlipperThatGoesAwayStrikesNothing() {
    SweptCircle ball = new SweptCircle(6, 2, 1, 0, 0);
    assertThat(ball.cast(FLIPPER, Vec2.ZERO, -ANGLE, ARRIVAL, 1)).isEmpty();
    assertThat(ball.cast(FLIPPER, Vec2.ZERO, ANGLE, ARRIVAL, 0.004)).isEmpty();
  }

  /** A ball that the line misses by far hits it when it rests. */
  @Test
  void theLineRestsAfterItsArrival() {
    double x = 4 * Math.cos(ANGLE);
    double y = 4 * Math.sin(ANGLE);
    Vec2 normal = new Vec2(-Math.sin(ANGLE), Math.cos(ANGLE));
    SweptCircle ball =
        new SweptCircle(
            x + 11 * normal.x(), y + 11 * normal.y(), 1, -20 * normal.x(), -20 * normal.y());

    Impact impact = ball.cast(FLIPPER, Vec2.ZERO, ANGLE, ARRIVAL, 1).get();

    assertThat(impact.time()).isCloseTo(0.5, within(1e-14));
    assertThat(impact.approachSpeed()).isCloseTo(20, within(1e-12));
    assertThat(ball.cast(FLIPPER, Vec2.ZERO, ANGLE, ARRIVAL, 0.49)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -0.0})
  void aLineThatDoesNotTurnRests(double angle) {
    SweptCircle ball = new SweptCircle(4, 11, 1, 0, -20);
    assertThat(ball.cast(FLIPPER, Vec2.ZERO, angle, 2, 3)).isEqualTo(ball.cast(FLIPPER, 3));
    SweptCircle falling = ball.withAcceleration(0, -5);
    assertThat(falling.cast(FLIPPER, Vec2.ZERO, angle, 2, 3)).isEqualTo(falling.cast(FLIPPER, 3));
  }

  /** On a line that turns towards it, a ball in touch with its speed is supported. */
  @Test
  void aBallThatRidesALineIsSupported() {
    double rate = 2 * StrictMath.sin(0.25);
    SweptCircle ball = new SweptCircle(4, 1, 1, 0, 4 * rate);
    Impact impact = ball.cast(FLIPPER, Vec2.ZERO, 0.5, 1, 1).get();
    assertThat(impact.time()).isZero();
    assertThat(impact.approachSpeed()).isZero();
    // Outwards fast enough, it leaves: the second derivative of the gap is -(r w^2 + 2 w u).
    SweptCircle leaving = new SweptCircle(4, 1, 1, -4 * rate, 4 * rate);
    assertThat(leaving.cast(FLIPPER, Vec2.ZERO, 0.5, 1, 0.1)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "1.6, 1, angle is 1.6, expected at most a quarter turn",
    "NaN, 1, angle is NaN",
    "1, 0, arrival is 0.0, expected a finite time above 0",
    "1, -1, arrival is -1.0",
    "1, Infinity, arrival is Infinity",
    "1, NaN, arrival is NaN",
    "1, 1e-310, arrival is 1.0E-310",
  })
  void badNumbersAreRefused(double angle, double arrival, String message) {
    SweptCircle ball = new SweptCircle(6, 2, 1, 0, 0);
    assertThatThrownBy(() -> ball.cast(FLIPPER, Vec2.ZERO, angle, arrival, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(message);
  }
}
