// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.SweptCircleAnswers.assertVector;
import static dev.carom.SweptCircleAnswers.hit;
import static dev.carom.SweptCircleAnswers.time;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The detector at the ends of the range of doubles: its answers, and the input that it refuses. */
class SweptCircleLimitsTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** From (0, 0) to (10, 0). */
  private static final Line FLOOR = new Line(0, 0, 10, 0);

  @ParameterizedTest
  @ValueSource(ints = {-900, -300, 300, 900})
  void sizeDoesNotMatter(int exponent) {
    double s = Math.scalb(1.0, exponent);
    Line line = new Line(0, 0, 10 * s, 0);
    Impact impact = hit(new Circle(16 * s, 8 * s, 5 * s), new Vec2(-3 * s, -4 * s), line);
    assertThat(impact.time()).isEqualTo(1);
    assertThat(impact.feature()).isEqualTo(Feature.END);
    assertVector(impact.normal(), new Vec2(0.6, 0.8), 1e-15);
  }

  /** The way is 2^-53 more than a double: a tie, which only exact numbers see. */
  @ParameterizedTest
  @CsvSource({"0x1p0, 0x1p0", "0x1.0000000000001p0, 0x1.0000000000002p0"})
  void aTimeHalfwayBetweenTwoDoublesIsTheEvenOne(String from, String time) {
    double x = Double.parseDouble(from);
    double t = Double.parseDouble(time);
    double to = -0x1p-53;
    assertThat(new SweptCircle(x, 0, 0, -1, 0).timeToBounds(to, -9, 9, 9, NEVER)).isEqualTo(t);
    assertThat(new SweptCircle(x, 0, 0, -1, 0).timeToCircle(new SweptCircle(to, 0, 0, 0, 0), NEVER))
        .isEqualTo(t);
    assertThat(new SweptCircle(x, 0, 0, -1, 0).timeToLine(to, -9, to, 9, NEVER)).isEqualTo(t);
    assertThat(new SweptCircle(x, 0, 0, -1, 0).timeToBounds(to, -9, 9, 9, Math.max(t, x)))
        .isEqualTo(x < t ? t : NEVER);
  }

  /** The impact is after the start, where the circle touches nothing. */
  @Test
  void theNormalAtATimeThatIsRoundedTo0() {
    Circle circle = new Circle(-1.25 * 0x1p-52, 0x1p-53, 0x1p-52);
    Impact atPoint =
        new SweptCircle(circle, new Vec2(0x1p1023, 0)).cast(new Circle(0, 0, 0), 1).orElseThrow();
    assertThat(atPoint.time()).isZero();
    assertVector(atPoint.normal(), new Vec2(-Math.sqrt(0.75), 0.5), 1e-15);
    Impact atLine = hit(new Circle(0x1p-60, 0x1p-60, 0), new Vec2(-0x1p1023, -0x1p1023), FLOOR);
    assertThat(atLine.time()).isZero();
    assertVector(atLine.normal(), new Vec2(0, 1), 1e-15);
  }

  @Test
  void aTimeBeyondTheRangeOfDoublesIsNever() {
    Circle circle = new Circle(4, 1e300, 2);
    assertThat(time(circle, new Vec2(0, -1e-300), FLOOR, Double.MAX_VALUE)).isEqualTo(NEVER);
    assertThat(time(circle, new Vec2(0, -1e-300), FLOOR, NEVER)).isEqualTo(NEVER);
    assertThat(time(circle, new Vec2(0, -1e300), FLOOR, NEVER)).isEqualTo(1);
  }

  @Test
  void numbersNearTheLargestDoubleAreNotRefused() {
    double m = Double.MAX_VALUE;
    assertThat(new SweptCircle(m, m, m, m, m).timeToLine(m, m, -m, -m, 1)).isEqualTo(NEVER);
    assertThat(new SweptCircle(m, 0, 1, -m, 0).timeToCircle(new SweptCircle(-m, 0, 1, m, 0), 2))
        .isEqualTo(1);
    assertThat(new SweptCircle(0, 0, 1, m, 0).timeToBounds(-m, -m, m, m, 2)).isEqualTo(1);
  }

  private static final SweptCircle MOVING = new SweptCircle(0, 0, 1, 1, 1);

  private static final SweptCircle FALLING = MOVING.withAcceleration(0, -1);

  private static void refused(Runnable query, String name, double value) {
    assertThatIllegalArgumentException()
        .isThrownBy(query::run)
        .withMessageStartingWith(name + " is " + value)
        .withMessageContaining("expected");
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesWhatIsNotFinite(double bad) {
    refused(() -> new SweptCircle(bad, 0, 1, 1, 1), "x", bad);
    refused(() -> new SweptCircle(0, bad, 1, 1, 1), "y", bad);
    refused(() -> new SweptCircle(0, 0, bad, 1, 1), "radius", bad);
    refused(() -> new SweptCircle(0, 0, 1, bad, 1), "vx", bad);
    refused(() -> new SweptCircle(0, 0, 1, 1, bad), "vy", bad);
    refused(() -> new SweptCircle(0, 0, 1, 1, 1, bad, 1), "gx", bad);
    refused(() -> new SweptCircle(0, 0, 1, 1, 1, 1, bad), "gy", bad);
    refused(() -> MOVING.withVelocity(bad, 1), "vx", bad);
    refused(() -> MOVING.withVelocity(1, bad), "vy", bad);
    refused(() -> MOVING.withAcceleration(bad, 1), "gx", bad);
    refused(() -> MOVING.withAcceleration(1, bad), "gy", bad);
    refused(() -> MOVING.at(bad), "t", bad);
    for (SweptCircle circle : List.of(MOVING, FALLING)) {
      refused(() -> circle.timeToLine(bad, 0, 1, 1, 1), "ax", bad);
      refused(() -> circle.timeToLine(0, bad, 1, 1, 1), "ay", bad);
      refused(() -> circle.timeToLine(0, 0, bad, 1, 1), "bx", bad);
      refused(() -> circle.timeToLine(0, 0, 1, bad, 1), "by", bad);
      refused(() -> circle.timeToLine(0, 0, 1, 1, bad, 0, 1), "ux", bad);
      refused(() -> circle.timeToLine(0, 0, 1, 1, 0, bad, 1), "uy", bad);
      refused(() -> circle.timeToPeg(bad, 0, 1, 1), "cx", bad);
      refused(() -> circle.timeToPeg(0, bad, 1, 1), "cy", bad);
      refused(() -> circle.timeToPeg(0, 0, bad, 1), "pegRadius", bad);
    }
  }

  @Test
  void refusesBoundsThatAreNoNumbers() {
    double bad = Double.NaN;
    for (SweptCircle circle : List.of(MOVING, FALLING)) {
      refused(() -> circle.timeToBounds(bad, 0, 1, 1, 1), "xmin", bad);
      refused(() -> circle.timeToBounds(0, bad, 1, 1, 1), "ymin", bad);
      refused(() -> circle.timeToBounds(0, 0, bad, 1, 1), "xmax", bad);
      refused(() -> circle.timeToBounds(0, 0, 1, bad, 1), "ymax", bad);
    }
  }

  @Test
  void refusesBoundsThatEndBeforeTheyBegin() {
    double infinite = Double.POSITIVE_INFINITY;
    for (SweptCircle circle : List.of(MOVING, FALLING)) {
      refused(() -> circle.timeToBounds(infinite, 0, infinite, 1, 1), "xmax", infinite);
      refused(() -> circle.timeToBounds(0, -infinite, 1, -infinite, 1), "ymax", -infinite);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.5, Double.NaN})
  void refusesNegativeRadiiAndWindows(double bad) {
    refused(() -> new SweptCircle(0, 0, bad, 1, 1), "radius", bad);
    for (SweptCircle circle : List.of(MOVING, FALLING)) {
      refused(() -> circle.timeToPeg(0, 0, bad, 1), "pegRadius", bad);
      refused(() -> circle.timeToBounds(2, 0, 1, 1, 1), "xmax", 1);
      refused(() -> circle.timeToBounds(0, 2, 1, 1, 1), "ymax", 1);
      refused(() -> circle.timeToLine(0, 0, 1, 1, bad), "maxTime", bad);
      refused(() -> circle.timeToLine(0, 0, 1, 1, 0, 0, bad), "maxTime", bad);
      refused(() -> circle.timeToPeg(0, 0, 1, bad), "maxTime", bad);
      refused(() -> circle.timeToBounds(0, 0, 1, 1, bad), "maxTime", bad);
      refused(() -> circle.timeToCircle(MOVING, bad), "maxTime", bad);
      refused(() -> circle.cast(FLOOR, bad), "maxTime", bad);
      refused(() -> circle.cast(new Bounds(0, 0, 1, 1), bad), "maxTime", bad);
      refused(() -> circle.cast(FLOOR, Vec2.ZERO, bad), "maxTime", bad);
      refused(() -> circle.cast(MOVING, bad), "maxTime", bad);
    }
  }

  /** The pair runs out of the range of doubles before it meets: its point is at the edge of it. */
  @Test
  void aContactPointBeyondTheRangeOfDoublesIsTheLargestOne() {
    Impact impact =
        new SweptCircle(-0x1.c17p1021, -0x1.524p1021, 0x1.a8p1014, 0x1.08p1014, 0x1.84p1015)
            .cast(
                new SweptCircle(0x1.868p1018, -0x1.6fp1017, 0, 0x1.9p1013, 0x1.7p1015),
                0x1.93e5939a08ceap99)
            .orElseThrow();
    assertThat(impact.time()).isEqualTo(1000);
    assertThat(impact.point().y()).isEqualTo(Double.MAX_VALUE);
  }
}
