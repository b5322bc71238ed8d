// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;

/**
 * An exact number {@code m 2^e}. Every finite double is one, and sums, differences and products of
 * them are again: no operation here rounds, except the three that take a number of bits or digits.
 */
public final class Dyadic implements Comparable<Dyadic> {
  /** The number 0. */
  public static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);

  /** The number 1. */
  public static final Dyadic ONE = new Dyadic(BigInteger.ONE, 0);

  private final BigInteger m;
  private final int e;

  private Dyadic(BigInteger m, int e) {
    this.m = m;
    this.e = e;
  }

  /** The exact value of a finite double. */
  public static Dyadic of(double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("not finite: " + value);
    }
    if (value == 0) {
      return ZERO;
    }
    long bits = Double.doubleToRawLongBits(value);
    int biased = (int) (bits >>> 52) & 0x7ff;
    long fraction = bits & 0xf_ffff_ffff_ffffL;
    long mantissa = biased == 0 ? fraction : fraction | 1L << 52;
    int zeros = Long.numberOfTrailingZeros(mantissa);
    long odd = mantissa >> zeros;
    return new Dyadic(
        BigInteger.valueOf(bits < 0 ? -odd : odd), Math.max(biased, 1) - 1075 + zeros);
  }

  /** The number {@code 2^exponent}. */
  public static Dyadic powerOfTwo(int exponent) {
    return new Dyadic(BigInteger.ONE, exponent);
  }

  public Dyadic plus(Dyadic other) {
    if (m.signum() == 0) {
      return other;
    }
    if (other.m.signum() == 0) {
      return this;
    }
    int low = Math.min(e, other.e);
    return new Dyadic(m.shiftLeft(e - low).add(other.m.shiftLeft(other.e - low)), low);
  }

  public Dyadic minus(Dyadic other) {
    return plus(other.negate());
  }

  public Dyadic times(Dyadic other) {
    return new Dyadic(m.multiply(other.m), e + other.e);
  }

  public Dyadic square() {
    return times(this);
  }

  public Dyadic negate() {
    return new Dyadic(m.negate(), e);
  }

  public Dyadic abs() {
    return m.signum() < 0 ? negate() : this;
  }

  /** This number times {@code 2^bits}. */
  public Dyadic shift(int bits) {
    return new Dyadic(m, e + bits);
  }

  /** The greatest multiple of a power of two that is not above this number. */
  Dyadic floor(Dyadic power) {
    int k = power.magnitude() - 1;
    return e >= k ? this : new Dyadic(m.shiftRight(k - e), k);
  }

  public int signum() {
    return m.signum();
  }

  /** The k with {@code 2^(k-1) <= |this| < 2^k}; meaningless for 0. */
  public int magnitude() {
    return m.abs().bitLength() + e; // of -8 alone, bitLength would be 3
  }

  @Override
  public int compareTo(Dyadic other) {
    int sign = signum();
    if (sign != other.signum() || sign == 0) {
      return Integer.compare(sign, other.signum());
    }
    if (magnitude() != other.magnitude()) {
      return sign * Integer.compare(magnitude(), other.magnitude());
    }
    return minus(other).signum();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Dyadic d && compareTo(d) == 0;
  }

  @Override
  public int hashCode() {
    return signum() == 0 ? 0 : m.shiftRight(m.getLowestSetBit()).hashCode();
  }

  /** The leading bits of this number, cut off: relative error below {@code 2^(1-bits)}. */
  private Dyadic leading(int bits) {
    int surplus = m.bitLength() - bits;
    return surplus <= 0 ? this : new Dyadic(m.shiftRight(surplus), e + surplus);
  }

  /** {@code sqrt(this)}, relative error below {@code 2^(2-bits)}; this must not be negative. */
  public Dyadic sqrt(int bits) {
    Dyadic head = leading(2 * bits + 2);
    int up = Math.max(0, 2 * bits + 2 - head.m.bitLength());
    up += (head.e - up) & 1;
    return new Dyadic(head.m.shiftLeft(up).sqrt(), (head.e - up) / 2);
  }

  /** {@code this / divisor}, relative error below {@code 2^(3-bits)}; the divisor must not be 0. */
  public Dyadic over(Dyadic divisor, int bits) {
    Dyadic below = divisor.leading(bits + 2);
    Dyadic above = leading(2 * bits + 4);
    int up = Math.max(0, 2 * bits + 4 - above.m.bitLength());
    return new Dyadic(above.m.shiftLeft(up).divide(below.m), above.e - up - below.e);
  }

  /** The numbers over the greatest common divisor of their mantissas. */
  static Dyadic[] primitive(Dyadic... numbers) {
    BigInteger divisor = BigInteger.ZERO;
    for (Dyadic number : numbers) {
      divisor = divisor.gcd(number.m);
    }
    Dyadic[] parts = new Dyadic[numbers.length];
    for (int i = 0; i < parts.length; i++) {
      parts[i] = new Dyadic(numbers[i].m.divide(divisor), numbers[i].e);
    }
    return parts;
  }

  /** A double next to this number: of its leading 62 bits; infinite beyond the range of doubles. */
  public double near() {
    Dyadic head = leading(62);
    return Math.scalb((double) head.m.longValue(), head.e);
  }

  /** This number to the digits of a context. */
  public BigDecimal toBigDecimal(MathContext digits) {
    BigDecimal power = BigDecimal.valueOf(2).pow(Math.abs(e), digits);
    BigDecimal mantissa = new BigDecimal(m);
    return e < 0 ? mantissa.divide(power, digits) : mantissa.multiply(power, digits);
  }

  @Override
  public String toString() {
    return toBigDecimal(new MathContext(25)).toString();
  }
}
