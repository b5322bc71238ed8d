// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.RoundingMode;

/**
 * A real number of which is known that it is within an error of {@code units 2^-bits}. Each
 * operation rounds to that many bits and adds what it may have lost to the error, so that a
 * decision made on such numbers is proved, or refused with {@link DoubtException}. Numbers that
 * work together have the same bits. Dyadic numbers stay exact, with an error of 0, as long as the
 * bits hold them.
 *
 * <p>Source: ball arithmetic as in F. Johansson, Arb: efficient arbitrary-precision midpoint-radius
 * interval arithmetic, IEEE Transactions on Computers 66 (2017).
 */
final class Ball {

  /** A number this close to zero, in bits, that cannot be told from zero is taken as zero. */
  private static final int TIE_BITS = 300;

  private static final int TOP = 64;

  private final BigInteger units;

  /** In units of the last bit. */
  private final Magnitude error;

  private final int bits;

  private Ball(BigInteger units, Magnitude error, int bits) {
    this.units = units;
    this.error = error;
    this.bits = bits;
  }

  private static Ball of(BigInteger units, Magnitude lost, boolean exact, int bits) {
    return new Ball(units, exact ? lost : lost.plus(Magnitude.ONE), bits);
  }

  static Ball of(double value, int bits) {
    if (value == 0) {
      return new Ball(BigInteger.ZERO, Magnitude.ZERO, bits);
    }
    int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - 52;
    BigInteger mantissa = BigInteger.valueOf((long) Math.scalb(value, -exponent));
    int shift = exponent + bits;
    boolean exact = mantissa.getLowestSetBit() + shift >= 0;
    return of(mantissa.shiftLeft(shift), Magnitude.ZERO, exact, bits);
  }

  Ball plus(Ball b) {
    return new Ball(units.add(b.units), error.plus(b.error), bits);
  }

  Ball minus(Ball b) {
    return new Ball(units.subtract(b.units), error.plus(b.error), bits);
  }

  Ball negate() {
    return new Ball(units.negate(), error, bits);
  }

  Ball abs() {
    return sign() < 0 ? negate() : this;
  }

  /** {@code |ab - AB| <= |a| eb + |b| ea + ea eb}. */
  Ball times(Ball b) {
    BigInteger product = units.multiply(b.units);
    boolean exact = product.getLowestSetBit() >= bits || product.signum() == 0;
    Magnitude lost = size().plus(error).times(b.error).plus(b.size().times(error));
    return of(product.shiftRight(bits), lost.shift(-bits), exact, bits);
  }

  /** {@code |a/b - A/B| <= (ea + |a/b| eb) / (|b| - eb)}. */
  Ball over(Ball b) {
    Magnitude size = b.size();
    double part = b.error.ratio(size) * (1 + 0x1p-40);
    if (!(part < 1 - 0x1p-40)) {
      throw new DoubtException();
    }
    BigInteger[] q = units.shiftLeft(bits).divideAndRemainder(b.units);
    Magnitude lost = Magnitude.of(q[0]).times(b.error).plus(error.shift(bits));
    Magnitude least = size.times((1 - part) * (1 - 0x1p-40));
    return of(q[0], lost.over(least), q[1].signum() == 0, bits);
  }

  /**
   * {@code |sqrt(a) - sqrt(A)| <= ea / (sqrt(a) + sqrt(a - ea)) <= ea / (sqrt(a) (2 - ea / a))}.
   */
  Ball sqrt() {
    if (sign() == 0) {
      return new Ball(BigInteger.ZERO, Magnitude.ZERO, bits);
    }
    BigInteger[] root = SquareRoot.withRemainder(units.shiftLeft(bits));
    double part = error.ratio(size());
    Magnitude least = Magnitude.of(root[0]).times((2 - part) * (1 - 0x1p-40));
    return of(root[0], error.over(least).shift(bits), root[1].signum() == 0, bits);
  }

  /** The number in the middle of this ball, without an error. */
  Ball middle() {
    return new Ball(units, Magnitude.ZERO, bits);
  }

  /** 2^exponent units of the last bit, exactly. */
  Ball step(int exponent) {
    return new Ball(BigInteger.ONE.shiftLeft(exponent), Magnitude.ZERO, bits);
  }

  /** This number with a further error of 2^exponent units of the last bit. */
  Ball widened(int exponent) {
    return new Ball(units, error.plus(new Magnitude(1, exponent)), bits);
  }

  Ball half() {
    return of(units.shiftRight(1), error.shift(-1), !units.testBit(0), bits);
  }

  /** A whole number in the same bits. */
  Ball whole(int value) {
    return of(value, bits);
  }

  int bits() {
    return bits;
  }

  /** -1 or 1 where that is certain; 0 for zero and for what is in doubt. */
  int certainSign() {
    return error.m() == 0 || error.isLessThan(size()) ? units.signum() : 0;
  }

  /** -1, 0 or 1; zero if it is exact, or so near that only an exact tie explains it. */
  int sign() {
    if (error.m() == 0 || error.isLessThan(size())) {
      return units.signum();
    }
    if (isTie()) {
      return 0;
    }
    throw new DoubtException();
  }

  int compareTo(Ball b) {
    return minus(b).sign();
  }

  /** The nearest double or a neighbour of it, for what needs no proof. */
  double head() {
    return nearest(units);
  }

  /** The nearest double, proved: both ends of the ball round to it. */
  double rounded() {
    BigInteger width = error.ceiling();
    double low = nearest(units.subtract(width));
    if (low == nearest(units.add(width))) {
      return low;
    }
    if (isTie()) {
      return nearest(tied());
    }
    throw new DoubtException();
  }

  /** The nearest number of so many decimals, proved: both ends of the ball round to it. */
  BigDecimal rounded(int decimals) {
    BigInteger width = error.ceiling();
    BigDecimal low = nearest(units.subtract(width), decimals);
    if (low.compareTo(nearest(units.add(width), decimals)) == 0) {
      return low;
    }
    throw new DoubtException();
  }

  private BigDecimal nearest(BigInteger m, int decimals) {
    BigDecimal unit = new BigDecimal(BigInteger.ONE.shiftLeft(bits));
    return new BigDecimal(m).divide(unit, decimals, RoundingMode.HALF_EVEN);
  }

  /** Without the bits of a tie that are noise: so the even one of two doubles is taken. */
  private BigInteger tied() {
    int noise = bits - TIE_BITS + 2;
    return units.add(BigInteger.ONE.shiftLeft(noise - 1)).shiftRight(noise).shiftLeft(noise);
  }

  /** The rest beside the nearest double. */
  double tail() {
    return minus(of(rounded(), bits)).head();
  }

  /** The error as a double; 0 below their range. */
  double error() {
    return error.shift(-bits).toDouble();
  }

  /** The base-10 logarithm of an upper bound of the absolute value; -infinity for zero. */
  double log10() {
    Magnitude most = size().plus(error);
    return Math.log10(most.m()) + (most.e() - bits) * Math.log10(2);
  }

  private Magnitude size() {
    return Magnitude.of(units);
  }

  private boolean isTie() {
    return error.e() + 1 - bits <= -TIE_BITS;
  }

  /** The double nearest to {@code m 2^-bits}: a bit that stands for all those cut off decides. */
  private double nearest(BigInteger m) {
    int surplus = Math.max(0, m.bitLength() - TOP);
    BigInteger top = m.shiftRight(surplus);
    boolean cut = surplus > 0 && m.getLowestSetBit() < surplus;
    // + 0 turns -0 into 0.
    return Math.scalb((cut ? top.setBit(0) : top).doubleValue(), surplus - bits) + 0.0;
  }
}
