// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Feature;
import dev.carom.Line;
import dev.carom.SweptCircle;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Above the end of a line: is it the side that is hit, or the end? */
class EndpointOrSideTest {

  private static Feature carom(double px, double py, double wx, double wy, double r) {
    return new SweptCircle(px, py, r, wy, -wx)
        .cast(new Line(0, 0, wx, wy), Double.MAX_VALUE)
        .orElseThrow()
        .feature();
  }

  /** By the length along the unit direction. */
  private static Feature naive(double px, double py, double wx, double wy) {
    double length = Math.hypot(wx, wy);
    return px * (wx / length) + py * (wy / length) < length ? Feature.SIDE : Feature.END;
  }

  /**
   * The centre comes down the perpendicular through the end, or one place of its x coordinate
   * beside it: w = (k, l) in whole numbers, the centre at w + m (-l, k), so that all is exact.
   */
  @Test
  void aFootOnTheEndIsTheEndAndBesideItIsNot() {
    Random random = new Random(2);
    int wrong = 0;
    for (int i = 0; i < 1000; i++) {
      double k = 1 + random.nextInt(1 << 20);
      double l = 1 + random.nextInt(1 << 20);
      double m = 2 + random.nextInt(1 << 10);
      double px = k - m * l;
      double py = l + m * k;
      double r = Math.hypot(k, l);
      double inside = px - Math.ulp(px);
      double outside = px + Math.ulp(px);
      wrong += naive(px, py, k, l) == Feature.END ? 0 : 1;
      wrong += naive(inside, py, k, l) == Feature.SIDE ? 0 : 1;
      assertThat(carom(px, py, k, l, r)).isEqualTo(Feature.END);
      assertThat(carom(inside, py, k, l, r)).isEqualTo(Feature.SIDE);
      assertThat(carom(outside, py, k, l, r)).isEqualTo(Feature.END);
    }
    assertThat(wrong).as("mistakes of the unit direction").isGreaterThan(100);
  }
}
