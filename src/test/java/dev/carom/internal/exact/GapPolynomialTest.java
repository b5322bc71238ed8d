// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

/** The time at which the gap of a straight flight falls to 0, from sums without rounding. */
class GapPolynomialTest {
  private static final double FOREVER = Double.POSITIVE_INFINITY;

  private static double fall(double end, double... coefficients) {
    return GapPolynomial.exact(
            DoubleStream.of(coefficients)
                .mapToObj(c -> Expansion.sum(c, 0))
                .toArray(Expansion[]::new))
        .fallOfConvex(end);
  }

  @Test
  void isTheFirstRoot() {
    assertThat(fall(FOREVER, 6, -5, 1)).isEqualTo(2);
    assertThat(fall(FOREVER, 7, -6, 1)).isEqualTo(3 - Math.sqrt(2));
    assertThat(fall(FOREVER, 3, -4)).isEqualTo(0.75);
    assertThat(fall(FOREVER, 3, -4, 0)).isEqualTo(0.75);
    assertThat(fall(FOREVER, 0x1p-60, -1, 0x1p60)).isNaN(); // a graze
    assertThat(fall(FOREVER, 0x1p-60, -1, 0x1p-60)).isEqualTo(0x1p-60);
  }

  @Test
  void isZeroWhereTheyTouch() {
    assertThat(fall(FOREVER, 0, -5, 1)).isZero();
    assertThat(fall(0, -1, -5, 1)).isZero();
  }

  /** A root halfway between two doubles is rounded to the even one. */
  @Test
  void isRoundedToTheEvenDouble() {
    double even = 1 + 0x1p-51;
    assertThat(fall(FOREVER, even + Math.nextUp(even), -2)).isEqualTo(even);
    assertThat(fall(FOREVER, Math.nextDown(even) + even, -2)).isEqualTo(even);
  }

  /** Roots at 2/3, 3/3 and 4/3 of an ulp above 1 are all rounded to the end. */
  @Test
  void isAtTheEndOnlyIfItIsNotLater() {
    double end = Math.nextUp(1.0);
    assertThat(fall(end, 3 + 0x1p-51, -3)).isEqualTo(end);
    assertThat(fall(end, end, -1)).isEqualTo(end);
    assertThat(fall(FOREVER, 3 + 0x1p-50, -3)).isEqualTo(end);
    assertThat(fall(end, 3 + 0x1p-50, -3)).isInfinite();
    assertThat(fall(1, 3 + 0x1p-51, -3)).isInfinite();
  }

  @Test
  void isOpenWhereTheGapDoesNotFallBelowZero() {
    assertThat(fall(FOREVER, 1, -2, 1)).isNaN();
    assertThat(fall(FOREVER, 2, -2, 1)).isNaN();
    assertThat(fall(FOREVER, 1, 0, 1)).isNaN();
  }
}
