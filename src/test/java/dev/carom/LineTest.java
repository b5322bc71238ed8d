// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LineTest {

  private static final Line LINE = new Line(1, 1, 5, 1);

  @Test
  void endsAreThePointsItWasMadeOf() {
    Line line = new Line(new Vec2(1, 2), new Vec2(3, 4));
    assertThat(line).isEqualTo(new Line(1, 2, 3, 4));
    assertThat(line.start()).isEqualTo(new Vec2(1, 2));
    assertThat(line.end()).isEqualTo(new Vec2(3, 4));
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesWhatIsNotFinite(double bad) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Line(bad, 0, 1, 1))
        .withMessage("ax is " + bad + ": expected a finite number");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Line(0, bad, 1, 1))
        .withMessage("ay is " + bad + ": expected a finite number");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Line(0, 0, bad, 1))
        .withMessage("bx is " + bad + ": expected a finite number");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Line(0, 0, 1, bad))
        .withMessage("by is " + bad + ": expected a finite number");
  }

  @Test
  void length() {
    assertThat(new Line(1, 1, 4, 5).length()).isEqualTo(5);
    assertThat(new Line(4, 5, 1, 1).length()).isEqualTo(5);
    assertThat(new Line(1, 1, 1, 1).length()).isZero();
    assertThat(new Line(0, 0, 0x3p1000, 0x4p1000).length()).isEqualTo(0x5p1000);
  }

  /**
   *
   *
   * <pre>
   *      p    p    p
   *   p  a---------b  p
   *      p    p    p
   * </pre>
   */
  @ParameterizedTest
  @CsvSource({
    "2, 7,  2, 1", // above the inside
    "2, -7,  2, 1", // below it
    "3, 1,  3, 1", // on it
    "1, 9,  1, 1", // above the start
    "5, 9,  5, 1", // above the end
    "0, 1,  1, 1", // before the start
    "6, 1,  5, 1", // beyond the end
    "-3, 4,  1, 1",
    "99, -4,  5, 1",
  })
  void closestPointStaysOnTheSegment(double x, double y, double atX, double atY) {
    assertThat(LINE.closestPoint(new Vec2(x, y))).isEqualTo(new Vec2(atX, atY));
  }

  @ParameterizedTest
  @CsvSource({"2, 7,  2, 1", "1, 9,  1, 1", "0, 1,  0, 1", "-3, 4,  -3, 1", "99, -4,  99, 1"})
  void closestPointInfiniteGoesOnBeyondTheEnds(double x, double y, double atX, double atY) {
    assertThat(LINE.closestPointInfinite(new Vec2(x, y))).isEqualTo(new Vec2(atX, atY));
  }

  @Test
  void aFootBeyondTheDoublesIsRefused() {
    double max = Double.MAX_VALUE;
    Line diagonal = new Line(0, 0, 1, 1);
    assertThat(diagonal.closestPointInfinite(new Vec2(max, max))).isEqualTo(new Vec2(max, max));
    Line slanted = new Line(0, 0, 2, 1);
    assertThatThrownBy(() -> slanted.closestPointInfinite(new Vec2(max, max)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("p is Vec2[");
  }

  /** The foot is 1e320 lengths of the line away: no double counts them. */
  @Test
  void theFootMayBeFarFromATinyLine() {
    Line level = new Line(0, 0, 1e-310, 0);
    assertThat(level.closestPointInfinite(new Vec2(1e10, 5))).isEqualTo(new Vec2(1e10, 0));
    Line diagonal = new Line(1, 1, 1 + 0x1p-52, 1 + 0x1p-52);
    assertThat(diagonal.closestPointInfinite(new Vec2(1e300, 0)).x())
        .isCloseTo(5e299, within(1e285));
    Line tiny = new Line(0, 0, 3e-310, 4e-310);
    Vec2 foot = tiny.closestPointInfinite(new Vec2(3e100, 4e100));
    assertThat(foot.x()).isCloseTo(3e100, within(1e86));
    assertThat(foot.y()).isCloseTo(4e100, within(1e86));
  }

  /** The difference of the point and the start overflows; that of the ends does not. */
  @Test
  void aPointMayBeFurtherFromTheStartThanDoublesReach() {
    Line falling = new Line(0, 1e308, 1e308, 0);
    Vec2 p = new Vec2(1.7e308, -1.7e308);
    assertThat(falling.closestPoint(p)).isEqualTo(new Vec2(1e308, 0));
    assertThatThrownBy(() -> falling.closestPointInfinite(p))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aLineOfLengthZeroGivesItsStart() {
    Line point = new Line(2, 3, 2, 3);
    assertThat(point.closestPoint(new Vec2(7, -8))).isEqualTo(new Vec2(2, 3));
    assertThat(point.closestPointInfinite(new Vec2(7, -8))).isEqualTo(new Vec2(2, 3));
    assertThat(point.closestPoint(new Vec2(2, 3))).isEqualTo(new Vec2(2, 3));
  }

  /** The difference of its ends overflows; everything else is as for a line of 8 x 4. */
  @ParameterizedTest
  @CsvSource({"-4, -2", "-4.5, -3", "0, 0", "2, 1", "3, -1", "4, 2", "6, 5", "-1, 2", "5, -3"})
  void closestPointOfALineLongerThanTheLargestDouble(double x, double y) {
    double scale = 0x1p1020 * 2.5;
    Line small = new Line(-4, -2, 4, 2);
    Line large = new Line(-4 * scale, -2 * scale, 4 * scale, 2 * scale);
    Vec2 p = new Vec2(x * Math.min(scale, Double.MAX_VALUE / 10), y * (Double.MAX_VALUE / 10));
    Vec2 q = new Vec2(p.x() / scale, p.y() / scale);
    near(large.closestPoint(p), small.closestPoint(q), scale);
    near(large.closestPointInfinite(p), small.closestPointInfinite(q), scale);
  }

  private static void near(Vec2 actual, Vec2 expected, double scale) {
    assertThat(actual.x() / scale).isCloseTo(expected.x(), within(1e-14));
    assertThat(actual.y() / scale).isCloseTo(expected.y(), within(1e-14));
  }

  @Test
  void theFootIsPerpendicularAndTheClosestPointIsTheNearest() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 1_000; i++) {
      Line line = new Line(any(random), any(random), any(random), any(random));
      Vec2 p = new Vec2(any(random), any(random));
      Vec2 foot = line.closestPointInfinite(p);
      double dot =
          (p.x() - foot.x()) * (line.bx() - line.ax())
              + (p.y() - foot.y()) * (line.by() - line.ay());
      assertThat(dot).isCloseTo(0, within(1e-9));
      double nearest = distance(p, line.closestPoint(p));
      for (double s = 0; s <= 1; s += 0.125) {
        double x = line.ax() + s * (line.bx() - line.ax());
        double y = line.ay() + s * (line.by() - line.ay());
        assertThat(nearest).isLessThanOrEqualTo(distance(p, new Vec2(x, y)) + 1e-12);
      }
    }
  }

  @Test
  void mirrorsAreExactAndSwappedEndsChangeNothingButRounding() {
    SplittableRandom random = new SplittableRandom(2);
    for (int i = 0; i < 1_000; i++) {
      Line line = new Line(any(random), any(random), any(random), any(random));
      Vec2 p = new Vec2(any(random), any(random));
      Vec2 closest = line.closestPoint(p);
      Line mirrored = new Line(-line.ax(), line.ay(), -line.bx(), line.by());
      assertThat(mirrored.closestPoint(new Vec2(-p.x(), p.y())))
          .isEqualTo(new Vec2(-closest.x(), closest.y()));
      Line swapped = new Line(line.bx(), line.by(), line.ax(), line.ay());
      assertThat(distance(swapped.closestPoint(p), closest)).isLessThan(1e-12);
    }
  }

  private static double any(SplittableRandom random) {
    return random.nextDouble(-100, 100);
  }

  private static double distance(Vec2 p, Vec2 q) {
    return new Vec2(p.x() - q.x(), p.y() - q.y()).length();
  }

  /** Coordinates are among the least doubles; an odd one cannot be halved. */
  @Test
  void closestPointOfTheShortestLines() {
    double least = Double.MIN_VALUE;
    Line line = new Line(least, least, 3 * least, 3 * least);
    assertThat(line.closestPoint(new Vec2(2 * least, 2 * least)))
        .isEqualTo(new Vec2(2 * least, 2 * least));
    assertThat(line.closestPoint(new Vec2(0, least))).isEqualTo(new Vec2(least, least));
  }
}
