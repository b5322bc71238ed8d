// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DyadicTest {

  @ParameterizedTest
  @ValueSource(
      doubles = {
        0,
        1,
        3,
        0.1,
        Double.MIN_VALUE,
        3 * Double.MIN_VALUE,
        0x0.fffffffffffffp-1022,
        Double.MIN_NORMAL,
        0x1.8p-1022,
        0x1p-1021,
        0x1p1023,
        0x1.8p1023,
        Double.MAX_VALUE
      })
  void ofADoubleIsThatDouble(double x) {
    assertThat(Dyadic.of(x).floor()).isEqualTo(x);
    assertThat(Dyadic.of(-x).negate().floor()).isEqualTo(x);
    assertThat(Dyadic.difference(x, x).sign()).isZero();
    assertThat(Dyadic.of(x).minus(Dyadic.of(Math.nextUp(Math.min(x, 1)))).sign())
        .isEqualTo(x > 1 ? 1 : -1);
  }

  @Test
  void theFloorIsTheDoubleBelow() {
    Dyadic bit = Dyadic.of(Double.MIN_VALUE).half();
    assertThat(bit.floor()).isZero();
    assertThat(Dyadic.of(1).minus(bit).floor()).isEqualTo(Math.nextDown(1.0));
    assertThat(Dyadic.of(1).plus(bit).floor()).isEqualTo(1);
    assertThat(Dyadic.of(Double.MAX_VALUE).plus(Dyadic.of(Double.MAX_VALUE)).floor())
        .isEqualTo(Double.MAX_VALUE);
  }

  /** q b <= a < (q + 2^-127 q) b, whatever the lengths of a and b. */
  @Test
  void quotientsAndRootsHaveAsManyBitsAsAskedFor() {
    Random random = new Random(3);
    for (int i = 0; i < 300; i++) {
      Dyadic a = power(random.nextDouble() + 0.1, 1 + i % 7);
      Dyadic b = power(random.nextDouble() + 0.1, 1 + i / 7 % 7);
      Dyadic q = a.over(b, 128);
      Dyadic rest = a.minus(q.times(b));
      assertThat(rest.sign()).isNotNegative();
      assertThat(rest.minus(tiny(a)).sign()).isNegative();
      Dyadic root = a.sqrt(128);
      Dyadic left = a.minus(root.square());
      assertThat(left.sign()).isNotNegative();
      assertThat(left.minus(tiny(a)).sign()).isNegative();
    }
  }

  private static Dyadic power(double x, int n) {
    Dyadic product = Dyadic.of(x);
    for (int i = 1; i < n; i++) {
      product = product.times(Dyadic.of(x));
    }
    return product;
  }

  private static Dyadic tiny(Dyadic a) {
    return a.times(Dyadic.of(0x1p-126));
  }
}
