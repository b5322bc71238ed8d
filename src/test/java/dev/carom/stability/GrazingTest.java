// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.SweptCircle;
import dev.carom.Vec2;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Past an end of a line, or along a line, at about the radius: who hits, and when. */
class GrazingTest {

  private static final double FAR = 1e8;
  private static final Vec2 RIGHT = new Vec2(1, 0);

  private static double naive(double height) {
    return Naive.pointTime(-FAR, height, 1, RIGHT);
  }

  private static double carom(double height) {
    return new SweptCircle(-FAR, height, 1, 1, 0).timeToPeg(0, 0, 0, Double.POSITIVE_INFINITY);
  }

  /** b^2 - a c is 0 for all of these: the radius is lost in the square of the distance. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-15, 1e-12, 1e-10})
  void aPassAboveThePointIsNone(double over) {
    assertThat(naive(1 + over)).as("hits what it passes").isLessThan(Naive.NEVER);

    assertThat(carom(1 + over)).isEqualTo(Double.POSITIVE_INFINITY);
  }

  @Test
  void toReachTheRadiusWithoutApproachIsNone() {
    assertThat(naive(1)).as("takes the graze for a hit").isLessThan(Naive.NEVER);

    assertThat(carom(1)).isEqualTo(Double.POSITIVE_INFINITY);
    assertThat(carom(Math.nextDown(1.0))).isLessThan(Double.POSITIVE_INFINITY);
  }

  /** It meets the point sqrt(r^2 - h^2) before it would be above it. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-10})
  void aHitBelowTheRadiusComesWhenItComes(double under) {
    double before = Math.sqrt(under * (2 - under));
    assertThat(Math.abs(naive(1 - under) - (FAR - before))).as("its error").isGreaterThan(1e-8);

    assertThat(carom(1 - under)).isCloseTo(FAR - before, within(Math.ulp(FAR)));
  }

  /** Along a slanted line at exactly the radius: whole numbers, so that it is exact. */
  @ParameterizedTest
  @CsvSource({"5, 12, 13", "8, 15, 17", "20, 21, 29", "7, 24, 25"})
  void slidingAlongALineAtExactlyTheRadiusIsNone(double wx, double wy, double w) {
    Random random = new Random(1);
    int overlaps = 0;
    for (int i = 0; i < 1000; i++) {
      // (-wy, wx) m is w m away from the line through 0.
      double m = 1 + random.nextInt(1 << 20);
      double s = -1 - random.nextInt(1 << 20);
      double px = wx * s - wy * m;
      double py = wy * s + wx * m;
      overlaps += wx / w * py - wy / w * px < w * m ? 1 : 0;
      assertThat(new SweptCircle(px, py, w * m, wx, wy).timeToLine(0, 0, wx, wy, 1e9)).isInfinite();
    }
    assertThat(overlaps).as("the unit normal finds overlaps").isPositive();
  }
}
