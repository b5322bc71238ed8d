// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.math.BigInteger;

/**
 * An upper bound {@code m 2^e} of a number that is not negative, 1 <= m < 2, or 0 with m = 0: a
 * double without bounds to its exponent. Each operation rounds up.
 */
record Magnitude(double m, int e) {

  static final Magnitude ZERO = new Magnitude(0, 0);

  static final Magnitude ONE = new Magnitude(1, 0);

  /** Covers the few roundings of one operation, each 2^-53. */
  private static final double UP = 1 + 0x1p-49;

  /** How many bits of an integer are looked at. */
  private static final int TOP = 64;

  /** A bound of {@code m 2^e}, a little above it, for any m that is not negative. */
  private static Magnitude up(double m, int e) {
    if (m == 0) {
      return ZERO;
    }
    int exponent = Math.getExponent(m);
    return new Magnitude(Math.scalb(m, -exponent) * UP, e + exponent);
  }

  static Magnitude of(BigInteger n) {
    int surplus = Math.max(0, n.bitLength() - TOP);
    return up(Math.abs(n.shiftRight(surplus).doubleValue()), surplus);
  }

  Magnitude plus(Magnitude b) {
    if (m == 0 || b.m == 0) {
      return m == 0 ? b : this;
    }
    return e >= b.e ? up(m + Math.scalb(b.m, b.e - e), e) : b.plus(this);
  }

  Magnitude times(Magnitude b) {
    return up(m * b.m, e + b.e);
  }

  Magnitude over(Magnitude b) {
    return up(m / b.m, e - b.e);
  }

  /** Times a factor, from 2^-1000 on. */
  Magnitude times(double factor) {
    return up(m * factor, e);
  }

  Magnitude shift(int bits) {
    return m == 0 ? ZERO : new Magnitude(m, e + bits);
  }

  /** This divided by a number, in plain doubles: 0 or infinity beyond their range. */
  double ratio(Magnitude b) {
    return m == 0 ? 0 : Math.scalb(m / b.m, e - b.e);
  }

  /** Whether every number it bounds is less than one that has this bound: by more than rounding. */
  boolean isLessThan(Magnitude b) {
    return m == 0 ? b.m > 0 : ratio(b) < 1 / (UP * UP * UP);
  }

  /** The least integer that is not less, or somewhat more. */
  BigInteger ceiling() {
    BigInteger mantissa = BigInteger.valueOf((long) Math.ceil(Math.scalb(m, 60)));
    BigInteger floor = mantissa.shiftLeft(e - 60);
    return m == 0 ? BigInteger.ZERO : floor.add(BigInteger.ONE);
  }

  double toDouble() {
    return Math.scalb(m, e);
  }
}
