// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.SweptCircleAnswers.assertVector;
import static dev.carom.SweptCircleAnswers.hit;
import static dev.carom.SweptCircleAnswers.time;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

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
    assertThat(SweptCircle.bounds(x, 0, 0, -1, 0, to, -9, 9, 9, NEVER)).isEqualTo(t);
    assertThat(SweptCircle.pair(x, 0, 0, -1, 0, to, 0, 0, 0, 0, NEVER)).isEqualTo(t);
    assertThat(SweptCircle.line(x, 0, 0, -1, 0, to, -9, to, 9, NEVER)).isEqualTo(t);
    assertThat(SweptCircle.bounds(x, 0, 0, -1, 0, to, -9, 9, 9, Math.max(t, x)))
        .isEqualTo(x < t ? t : NEVER);
  }

  /** The impact is after the start, where the circle touches nothing. */
  @Test
  void theNormalAtATimeThatIsRoundedTo0() {
    Circle circle = new Circle(-1.25 * 0x1p-52, 0x1p-53, 0x1p-52);
    Impact atPoint =
        SweptCircle.cast(circle, new Vec2(0x1p1023, 0), new Circle(0, 0, 0), 1).orElseThrow();
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
    assertThat(SweptCircle.line(m, m, m, m, m, m, m, -m, -m, 1)).isEqualTo(NEVER);
    assertThat(SweptCircle.pair(m, 0, 1, -m, 0, -m, 0, 1, m, 0, 2)).isEqualTo(1);
    assertThat(SweptCircle.bounds(0, 0, 1, m, 0, -m, -m, m, m, 2)).isEqualTo(1);
  }

  private static void refused(Runnable query, String name, double value) {
    assertThatIllegalArgumentException()
        .isThrownBy(query::run)
        .withMessageStartingWith(name + " is " + value)
        .withMessageContaining("expected");
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesWhatIsNotFinite(double bad) {
    refused(() -> SweptCircle.line(bad, 0, 1, 1, 1, 0, 0, 1, 1, 1), "px", bad);
    refused(() -> SweptCircle.line(0, bad, 1, 1, 1, 0, 0, 1, 1, 1), "py", bad);
    refused(() -> SweptCircle.line(0, 0, bad, 1, 1, 0, 0, 1, 1, 1), "r", bad);
    refused(() -> SweptCircle.line(0, 0, 1, bad, 1, 0, 0, 1, 1, 1), "vx", bad);
    refused(() -> SweptCircle.line(0, 0, 1, 1, bad, 0, 0, 1, 1, 1), "vy", bad);
    refused(() -> SweptCircle.line(0, 0, 1, 1, 1, bad, 0, 1, 1, 1), "ax", bad);
    refused(() -> SweptCircle.line(0, 0, 1, 1, 1, 0, bad, 1, 1, 1), "ay", bad);
    refused(() -> SweptCircle.line(0, 0, 1, 1, 1, 0, 0, bad, 1, 1), "bx", bad);
    refused(() -> SweptCircle.line(0, 0, 1, 1, 1, 0, 0, 1, bad, 1), "by", bad);
    refused(() -> SweptCircle.peg(0, bad, 1, 1, 1, 0, 0, 1, 1), "py", bad);
    refused(() -> SweptCircle.peg(0, 0, 1, 1, 1, bad, 0, 1, 1), "cx", bad);
    refused(() -> SweptCircle.peg(0, 0, 1, 1, 1, 0, bad, 1, 1), "cy", bad);
    refused(() -> SweptCircle.peg(0, 0, 1, 1, 1, 0, 0, bad, 1), "R", bad);
    refused(() -> SweptCircle.pair(0, 0, 1, 1, 1, 0, 0, 1, bad, 1, 1), "vx2", bad);
    refused(() -> SweptCircle.pair(0, bad, 1, 1, 1, 0, 0, 1, 1, 1, 1), "y1", bad);
    refused(() -> SweptCircle.pair(0, 0, 1, 1, bad, 0, 0, 1, 1, 1, 1), "vy1", bad);
    refused(() -> SweptCircle.pair(0, 0, bad, 1, 1, 0, 0, 1, 1, 1, 1), "r1", bad);
    refused(() -> SweptCircle.bounds(0, 0, 1, 1, 1, bad, 0, 1, 1, 1), "xmin", bad);
    refused(() -> SweptCircle.bounds(0, 0, bad, 1, 1, 0, 0, 1, 1, 1), "r", bad);
  }

  @Test
  void refusesNegativeRadiiAndWindows() {
    refused(() -> SweptCircle.line(0, 0, -1, 1, 1, 0, 0, 1, 1, 1), "r", -1);
    refused(() -> SweptCircle.peg(0, 0, 1, 1, 1, 0, 0, -2, 1), "R", -2);
    refused(() -> SweptCircle.line(0, 0, 1, 1, 1, 0, 0, 1, 1, -0.5), "maxTime", -0.5);
    refused(() -> SweptCircle.line(0, 0, 1, 1, 1, 0, 0, 1, 1, Double.NaN), "maxTime", Double.NaN);
    refused(() -> SweptCircle.peg(0, 0, 1, 1, 1, 0, 0, 1, -0.5), "maxTime", -0.5);
    refused(() -> SweptCircle.pair(0, 0, 1, 1, 1, 0, 0, 1, 1, 1, -0.5), "maxTime", -0.5);
    refused(() -> SweptCircle.pair(0, 0, -1, 1, 1, 0, 0, 3, 1, 1, 1), "r1", -1);
    refused(() -> SweptCircle.pair(0, 0, 3, 1, 1, 0, 0, -1, 1, 1, 1), "r2", -1);
    refused(() -> SweptCircle.bounds(0, 0, 1, 1, 1, 0, 0, 1, 1, -0.5), "maxTime", -0.5);
    refused(() -> SweptCircle.bounds(0, 0, 1, 1, 1, 2, 0, 1, 1, 1), "xmax", 1);
    Circle c = new Circle(0, 0, 1);
    refused(() -> SweptCircle.cast(c, Vec2.ZERO, FLOOR, -0.5), "maxTime", -0.5);
    refused(() -> SweptCircle.cast(c, Vec2.ZERO, c, Vec2.ZERO, Double.NaN), "maxTime", Double.NaN);
  }

  /** The pair runs out of the range of doubles before it meets: its point is at the edge of it. */
  @Test
  void aContactPointBeyondTheRangeOfDoublesIsTheLargestOne() {
    Impact impact =
        SweptCircle.cast(
                new Circle(-0x1.c17p1021, -0x1.524p1021, 0x1.a8p1014),
                new Vec2(0x1.08p1014, 0x1.84p1015),
                new Circle(0x1.868p1018, -0x1.6fp1017, 0),
                new Vec2(0x1.9p1013, 0x1.7p1015),
                0x1.93e5939a08ceap99)
            .orElseThrow();
    assertThat(impact.time()).isEqualTo(1000);
    assertThat(impact.point().y()).isEqualTo(Double.MAX_VALUE);
  }
}
