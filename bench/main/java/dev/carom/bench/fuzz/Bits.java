// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import java.util.SplittableRandom;

/**
 * Doubles of every pattern of bits: any at all, the edges of the range, whole numbers, powers of
 * two, and neighbours of the number drawn before. Numbers of one query share a regime as a rule, so
 * that they have to do with each other.
 */
final class Bits {

  private static final double[] EDGES = {
    0.0,
    -0.0,
    Double.MIN_VALUE,
    Double.MIN_NORMAL,
    Math.nextDown(Double.MIN_NORMAL),
    Double.MAX_VALUE,
    0x1p1023,
    0x1p-1022,
    0x1p511,
    0x1p512,
    0x1p-511,
    0x1p-537,
    1,
    Math.nextUp(1.0),
    Math.nextDown(1.0),
    0x1p53
  };

  private final SplittableRandom random;
  private int regime;
  private int exponent;
  private double last;

  Bits(long seed) {
    random = new SplittableRandom(seed);
  }

  /** A new query, and its regime. */
  void begin() {
    regime = random.nextInt(6);
    exponent = random.nextInt(8) == 0 ? random.nextInt(-1074, 1020) : 0;
  }

  boolean chance(int oneIn) {
    return random.nextInt(oneIn) == 0;
  }

  int below(int bound) {
    return random.nextInt(bound);
  }

  /** Any finite number. */
  double any() {
    last = finite(regime == 5 ? pattern(random.nextInt(5)) : pattern(regime));
    return last;
  }

  /** One that is not negative. */
  double length() {
    return Math.abs(any());
  }

  /** The end of a window. */
  double window() {
    return switch (random.nextInt(4)) {
      case 0 -> Double.POSITIVE_INFINITY;
      case 1 -> 0;
      default -> length();
    };
  }

  private double pattern(int kind) {
    return switch (kind) {
      case 0 -> Double.longBitsToDouble(random.nextLong());
      case 1 -> (random.nextBoolean() ? 1 : -1) * EDGES[random.nextInt(EDGES.length)];
      case 2 -> neighbour(Math.scalb((double) random.nextInt(-8, 9), exponent));
      case 3 ->
          random.nextBoolean()
              ? neighbour(last)
              : Math.scalb((double) random.nextInt(-8, 9), exponent);
      default -> Math.scalb(random.nextDouble() * 200 - 100, exponent);
    };
  }

  private double neighbour(double value) {
    return switch (random.nextInt(6)) {
      case 0 -> Math.nextUp(value);
      case 1 -> Math.nextDown(value);
      default -> value;
    };
  }

  /** Without the highest bit of the exponent, if it is not finite. */
  private static double finite(double value) {
    return Double.isFinite(value)
        ? value
        : Double.longBitsToDouble(Double.doubleToRawLongBits(value) & ~(1L << 62));
  }
}
