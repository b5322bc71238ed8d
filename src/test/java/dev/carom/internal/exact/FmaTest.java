// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The fused multiply-add of sums beside {@link Math#fma}: the same bits for all operands. */
class FmaTest {

  /** A longer run: {@code -Dfma.cases=N}. */
  private static final long CASES = Long.getLong("fma.cases", 5_000_000);

  private static final double[] EXTREMES = {
    0,
    Double.MIN_VALUE,
    3 * Double.MIN_VALUE,
    0x1.fffffffffffffp-1023,
    Double.MIN_NORMAL,
    0x1p-969,
    0x1p-900,
    0x1p-840,
    0x1.0000000000001p-840,
    0x1.0000000000001p-450,
    0x1p-450,
    0x1p-53,
    0x1p-27,
    0.5,
    0x1.fffffffffffffp-1,
    1,
    0x1.0000000000001p0,
    0x1.0000002p0,
    0x1.8p0,
    3,
    0x8000001p0,
    0x1p53,
    0x1p53 + 2,
    0x1.fffffffffffffp499,
    0x1p500,
    0x1p511,
    0x1.fffffffffffffp511,
    0x1p512,
    0x1p1000,
    0x1p1023,
    Double.MAX_VALUE,
    Double.POSITIVE_INFINITY,
    Double.NaN,
  };

  @Test
  void allTriplesOfExtremeOperands() {
    for (double a : EXTREMES) {
      for (double b : EXTREMES) {
        for (double c : EXTREMES) {
          for (int signs = 0; signs < 8; signs++) {
            compare(
                (signs & 1) == 0 ? a : -a, (signs & 2) == 0 ? b : -b, (signs & 4) == 0 ? c : -c);
          }
        }
      }
    }
  }

  /** Any bits: nearly all of these have exponents far from each other, and many overflow. */
  @Test
  void randomBits() {
    SplittableRandom random = new SplittableRandom(1);
    for (long k = 0; k < CASES / 5; k++) {
      compare(any(random), any(random), any(random));
    }
  }

  /** Ordinary sizes, and a summand from far below the product to far above it. */
  @Test
  void ordinaryOperands() {
    SplittableRandom random = new SplittableRandom(2);
    for (long k = 0; k < CASES; k++) {
      double a = ordinary(random, 60);
      double b = ordinary(random, 60);
      compare(a, b, a * b * ordinary(random, 120));
    }
  }

  /** The summand takes away the product but for some ulps, a half, or a tail of it. */
  @Test
  void cancellation() {
    SplittableRandom random = new SplittableRandom(3);
    for (long k = 0; k < CASES; k++) {
      double a = ordinary(random, 30);
      double b = ordinary(random, 30);
      double p = a * b;
      compare(a, b, -p);
      compare(a, b, -p + random.nextInt(-4, 5) * Math.ulp(p) * 0.5);
      compare(a, b, -p * (1 + random.nextInt(-4, 5) * 0.25));
    }
  }

  /** Few bits in each operand: the sum is often half way between two doubles, or next to that. */
  @Test
  void halfway() {
    SplittableRandom random = new SplittableRandom(4);
    for (long k = 0; k < CASES; k++) {
      double a = random.nextInt(-64, 65) + Math.scalb(random.nextInt(-3, 4), -random.nextInt(55));
      double b = random.nextInt(-64, 65) + Math.scalb(random.nextInt(-3, 4), -random.nextInt(55));
      double c = Math.scalb(random.nextInt(-3, 4) + 0x1p-52 * random.nextInt(-2, 3), 0);
      compare(a, b, Math.scalb(c, random.nextInt(-110, 111)));
      compare(1, a, Math.ulp(a) * random.nextInt(-2, 3) * 0.5 * b);
    }
  }

  /** Products and sums about the ends of what the sums take, and about the ends of the doubles. */
  @Test
  void endsOfTheRange() {
    SplittableRandom random = new SplittableRandom(5);
    int[] ends = {-1074, -1022, -969, -900, 500, 1000, 1023};
    for (long k = 0; k < CASES / 5; k++) {
      int end = ends[random.nextInt(ends.length)];
      int share = random.nextInt(-500, 501);
      double a = Math.scalb(ordinary(random, 3), end / 2 + share);
      double b = Math.scalb(ordinary(random, 3), end - end / 2 - share);
      compare(a, b, Math.scalb(ordinary(random, 3), end + random.nextInt(-108, 109)));
      compare(a, b, -(a * b));
    }
  }

  private static double any(SplittableRandom random) {
    return Double.longBitsToDouble(random.nextLong());
  }

  private static double ordinary(SplittableRandom random, int exponents) {
    double mantissa = random.nextBoolean() ? random.nextDouble() : random.nextInt(1, 9) * 0.125;
    double size = Math.scalb(1 + mantissa, random.nextInt(-exponents, exponents + 1));
    return random.nextBoolean() ? size : -size;
  }

  private static void compare(double a, double b, double c) {
    double expected = Math.fma(a, b, c);
    check(expected, Fma.emulated(a, b, c), a, b, c);
    check(expected, Fma.fma(a, b, c), a, b, c);
  }

  /** The same bits; one NaN is as good as another. */
  private static void check(double expected, double found, double a, double b, double c) {
    if (Double.doubleToLongBits(found) != Double.doubleToLongBits(expected)) {
      assertThat(found).as("fma(%a, %a, %a)", a, b, c).isEqualTo(expected);
      throw new AssertionError("fma(" + a + ", " + b + ", " + c + ") is " + found);
    }
  }
}
