// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.math.BigInteger;

/**
 * An exact dyadic number {@code m 2^e}. Every finite double is one, and so are sums, differences
 * and products of dyadic numbers. So the signs of polynomials in doubles are decided here without
 * rounding.
 */
public final class Dyadic implements Ring<Dyadic> {

  public static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);

  private final BigInteger m;
  private final int e;

  private Dyadic(BigInteger m, int e) {
    this.m = m;
    this.e = e;
    ExactBudget.add(m.bitLength());
  }

  /** The value of a finite double. */
  public static Dyadic of(double x) {
    if (x == 0) {
      return ZERO;
    }
    int exponent = Math.max(Math.getExponent(x), Double.MIN_EXPONENT) - 52;
    long bits = Double.doubleToRawLongBits(x);
    long fraction = bits & 0xfffffffffffffL;
    long integer = Math.getExponent(x) < Double.MIN_EXPONENT ? fraction : fraction | 1L << 52;
    int zeros = Long.numberOfTrailingZeros(integer);
    integer >>= zeros;
    return new Dyadic(BigInteger.valueOf(x < 0 ? -integer : integer), exponent + zeros);
  }

  /** 2^k. */
  static Dyadic powerOfTwo(int k) {
    return new Dyadic(BigInteger.ONE, k);
  }

  /**
   * A number of few bits between two positive ones: about their arithmetic mean if they are within
   * a factor of 4, else about the geometric one.
   */
  static Dyadic between(Dyadic from, Dyadic to) {
    int bottom = from.magnitude();
    int top = to.magnitude();
    return top - bottom > 2 ? powerOfTwo((bottom + top + 1) >> 1) : from.plus(to).half();
  }

  /** a - b, without rounding. */
  public static Dyadic difference(double a, double b) {
    return of(a).minus(of(b));
  }

  @Override
  public Dyadic plus(Dyadic that) {
    if (e <= that.e) {
      return new Dyadic(m.add(that.m.shiftLeft(that.e - e)), e);
    }
    return that.plus(this);
  }

  @Override
  public Dyadic minus(Dyadic that) {
    return plus(that.negate());
  }

  @Override
  public Dyadic times(Dyadic that) {
    ExactBudget.addProduct(m.bitLength(), that.m.bitLength());
    return new Dyadic(m.multiply(that.m), e + that.e);
  }

  Dyadic square() {
    return times(this);
  }

  Dyadic negate() {
    return new Dyadic(m.negate(), e);
  }

  public Dyadic abs() {
    return m.signum() < 0 ? negate() : this;
  }

  Dyadic half() {
    return new Dyadic(m, e - 1);
  }

  public int sign() {
    return m.signum();
  }

  /** floor(log2 |this|) of a number other than zero. */
  int magnitude() {
    return m.abs().bitLength() - 1 + e;
  }

  /** The residue by {@link Residues#PRIME}, by which a power of two has the period 31. */
  long residue() {
    ExactBudget.add(m.bitLength());
    long power = 1L << Math.floorMod(e, 31);
    return m.mod(BigInteger.valueOf(Residues.PRIME)).longValue() * power % Residues.PRIME;
  }

  /** The square root of a number at or above zero, rounded down, to at least {@code bits} bits. */
  Dyadic sqrt(int bits) {
    int shift = 2 * bits - m.bitLength(); // what is beyond so many bits is left out
    if ((e - shift & 1) != 0) {
      shift++;
    }
    BigInteger shifted = m.shiftLeft(shift);
    ExactBudget.addSquared(shifted.bitLength());
    return new Dyadic(shifted.sqrt(), (e - shift) / 2);
  }

  /** this / that for positive numbers, rounded down, to at least {@code bits} bits. */
  Dyadic over(Dyadic that, int bits) {
    int shift = Math.max(0, bits + 1 + that.m.bitLength() - m.bitLength());
    BigInteger shifted = m.shiftLeft(shift);
    ExactBudget.addSquared(shifted.bitLength());
    return new Dyadic(shifted.divide(that.m), e - shift - that.e);
  }

  /** A number that divides both, so that the quotients are odd parts times powers of two. */
  Dyadic gcd(Dyadic that) {
    return new Dyadic(m.gcd(that.m), 0);
  }

  /** The quotient by a divisor of this number's odd part, without rounding. */
  Dyadic exactQuotient(Dyadic divisor) {
    return new Dyadic(m.divide(divisor.m), e - divisor.e);
  }

  /**
   * The largest double at or below this number, which must not be negative; {@link
   * Double#MAX_VALUE} for everything beyond.
   */
  double floor() {
    if (m.signum() == 0) {
      return 0;
    }
    int top = magnitude();
    if (top > Double.MAX_EXPONENT) {
      return Double.MAX_VALUE;
    }
    int unit = Math.max(top, Double.MIN_EXPONENT) - 52;
    long integer = m.shiftLeft(e - unit).longValueExact();
    // At most 53 bits times a power of two in range, so this is exact. Two steps, as 2^unit may
    // underflow.
    return Math.scalb((double) integer, unit);
  }
}
