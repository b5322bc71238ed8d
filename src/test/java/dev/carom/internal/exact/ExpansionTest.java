// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Sums of doubles without rounding, held to decimals of any length. */
class ExpansionTest {
  private static final int TRIALS = 20_000;

  private final SplittableRandom random = new SplittableRandom(1);

  /** Of any size between 2^-60 and 2^60; often near the one before, so that sums cancel. */
  private double draw(double before) {
    double any = Math.scalb(random.nextDouble() - 0.5, random.nextInt(-60, 61));
    return switch (random.nextInt(4)) {
      case 0 -> -before;
      case 1 -> before == 0 ? any : -Math.nextUp(before);
      case 2 -> random.nextInt(-9, 10);
      default -> any;
    };
  }

  private static BigDecimal exact(double x) {
    return new BigDecimal(x);
  }

  @Test
  void productsOfSumsKeepEveryDigit() {
    for (int i = 0; i < TRIALS; i++) {
      double[] x = new double[8];
      double[] y = new double[8];
      BigDecimal[] truth = new BigDecimal[8];
      Expansion[] sums = new Expansion[8];
      for (int k = 0; k < x.length; k++) {
        x[k] = draw(k == 0 ? 1 : x[k - 1]);
        y[k] = draw(x[k]);
        sums[k] = k % 2 == 0 ? Expansion.difference(x[k], y[k]) : Expansion.sum(x[k], y[k]);
        BigDecimal other = exact(y[k]);
        truth[k] = k % 2 == 0 ? exact(x[k]).subtract(other) : exact(x[k]).add(other);
        assertValue(sums[k], truth[k]);
      }
      Expansion cross = sums[0].times(sums[3]).minus(sums[1].times(sums[2]));
      Expansion dot = sums[4].times(sums[6]).plus(sums[5].times(sums[7]));
      BigDecimal crossed = truth[0].multiply(truth[3]).subtract(truth[1].multiply(truth[2]));
      BigDecimal dotted = truth[4].multiply(truth[6]).add(truth[5].multiply(truth[7]));
      assertValue(cross, crossed);
      assertValue(dot, dotted);
      BigDecimal both = crossed.multiply(crossed).subtract(crossed.multiply(dotted));
      assertValue(cross.times(cross).minus(cross.times(dot)), both);
    }
  }

  /** Its sign is that of the truth, and its value is within 64 u^2 of it. */
  private static void assertValue(Expansion sum, BigDecimal truth) {
    assertThat(sum.isExact()).isTrue();
    assertThat(sum.sign()).isEqualTo(truth.signum());
    BoundedNumber value = sum.value();
    BigDecimal error = exact(value.head()).add(exact(value.tail())).subtract(truth).abs();
    assertThat(error).isLessThanOrEqualTo(truth.abs().multiply(exact(64 * 0x1p-106)));
    assertThat(value.head() + value.tail()).isEqualTo(value.head());
  }

  @Test
  void whatUnderflowsOrOverflowsIsNotExact() {
    Expansion small = Expansion.difference(1, 1e-200);
    Expansion large = Expansion.sum(1e300, 0);
    assertThat(small.isExact()).isTrue();
    assertThat(small.times(small).isExact()).isFalse();
    assertThat(large.times(large).isExact()).isFalse();
    assertThat(Expansion.sum(1e308, 1e308).isExact()).isFalse();
    assertThat(Expansion.difference(Double.NaN, 1).isExact()).isFalse();
  }

  @Test
  void doubleDoublesErrWithinTheirBounds() {
    double u2 = 0x1p-106;
    for (int i = 0; i < TRIALS; i++) {
      BoundedNumber a = BoundedNumber.of(draw(1), 0x1p-54 * random.nextDouble());
      BoundedNumber b = BoundedNumber.of(draw(a.head()), a.tail() * random.nextDouble());
      if (a.head() == 0 || b.head() == 0) {
        continue;
      }
      BigDecimal x = exact(a.head()).add(exact(a.tail()));
      BigDecimal y = exact(b.head()).add(exact(b.tail()));
      assertWithin(4 * u2, a.plus(b), x.add(y));
      assertWithin(5 * u2, a.times(b), x.multiply(y));
    }
  }

  private static void assertWithin(double bound, BoundedNumber value, BigDecimal truth) {
    BigDecimal error = exact(value.head()).add(exact(value.tail())).subtract(truth).abs();
    assertThat(error).isLessThanOrEqualTo(truth.abs().multiply(exact(bound)));
  }
}
