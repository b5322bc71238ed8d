// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The only root of a polynomial between two positive numbers that are none.
 *
 * <p>It is kept as a root of f, too, which changes its sign there: the polynomial itself, or a
 * derivative of it if it does not.
 */
final class SturmRoot {
  /** Bits after which two roots that are not apart yet may be the same. */
  private static final int SAME_BITS = 80;

  private final SturmPolynomial of;
  private final SturmPolynomial f;
  private final int signAbove;
  private Dyadic low;
  private Dyadic high;
  private int bits;
  private int chordBits = 16;

  private SturmRoot(SturmPolynomial of, SturmPolynomial f, Dyadic low, Dyadic high) {
    this.of = of;
    this.f = f;
    set(low, high);
    signAbove = f.sign(high);
  }

  /** The root at which a polynomial changes its sign, and the only one, between two numbers. */
  SturmRoot(SturmPolynomial f, Dyadic low, Dyadic high) {
    this(f, f, low, high);
  }

  /** The same, as a root of another polynomial, which need not change its sign. */
  SturmRoot of(SturmPolynomial other) {
    return new SturmRoot(other, f, low, high);
  }

  /** The relative width of the interval is below 2^-bits. */
  private void set(Dyadic newLow, Dyadic newHigh) {
    low = newLow;
    high = newHigh;
    bits = low.magnitude() - high.minus(low).magnitude();
  }

  /** Halves the interval about the middle, by exponent if its ends are far apart. */
  private void halve() {
    boolean far = high.magnitude() - low.magnitude() > 3;
    Dyadic middle =
        far
            ? Dyadic.powerOfTwo(Math.floorDiv(high.magnitude() + low.magnitude(), 2))
            : low.plus(high).shift(-1);
    int sign = f.sign(middle);
    if (sign == 0) {
      set(low.plus(middle).shift(-1), high.plus(middle).shift(-1));
    } else {
      set(sign == signAbove ? low : middle, sign == signAbove ? middle : high);
    }
  }

  /** Narrows the interval to a relative width of 2^-enough. */
  SturmRoot narrow(int enough) {
    while (bits < enough) {
      if (bits < chordBits) {
        halve();
      } else {
        tryChord();
      }
    }
    return this;
  }

  /** Narrows the interval until a polynomial has a given sign, that at this root, at its ends. */
  void narrow(SturmPolynomial q, int sign) {
    while (q.sign(low) != sign || q.sign(high) != sign) {
      halve();
    }
  }

  /**
   * Tries a narrow interval around the place where the chord of f crosses 0. From so many bits on
   * that f is nearly straight, this gains half as many bits (after J. Abbott, Quadratic interval
   * refinement for real roots, 2006).
   */
  private void tryChord() {
    int gain = bits / 2;
    Dyadic atLow = f.value(low);
    Dyadic part = atLow.over(atLow.minus(f.value(high)), gain + 4);
    Dyadic step = Dyadic.powerOfTwo(high.minus(low).magnitude() - gain - 2);
    Dyadic guess = low.plus(high.minus(low).times(part)).floor(step);
    Dyadic from = guess.minus(step);
    Dyadic to = guess.plus(step).plus(step);
    boolean isInside = from.compareTo(low) > 0 && to.compareTo(high) < 0;
    if (isInside && f.sign(from) == -signAbove && f.sign(to) == signAbove) {
      set(from, to);
    } else {
      chordBits = bits + gain;
    }
  }

  Dyadic low() {
    return low;
  }

  Dyadic high() {
    return high;
  }

  /** The sign of q at this root: by its slope if the value is well off 0, else by Tarski. */
  int sign(SturmPolynomial q) {
    if (q == of || q == f) {
      return 0;
    }
    for (int bits = 10; bits <= 90; bits += 40) {
      narrow(bits);
      int sign = q.signBetween(low, high);
      if (sign != 0) {
        return sign;
      }
      Dyadic change = high.minus(low).times(q.derivative().terms(high));
      Dyadic value = q.value(low);
      if (value.abs().compareTo(change) > 0) {
        return value.signum();
      }
    }
    return of.signs(q, low, high);
  }

  /** The sign of this root less m. */
  int compareTo(Dyadic m) {
    if (m.compareTo(low) <= 0) {
      return 1;
    }
    if (m.compareTo(high) >= 0) {
      return -1;
    }
    return -signAbove * f.sign(m);
  }

  /** The correctly rounded root, of two equally near doubles the even one. */
  double nearest() {
    return Nearest.of(narrow(70).low().near(), this::compareTo);
  }

  /** Whether this root is after another one, as far as a few bits tell. */
  boolean isClearlyAfter(SturmRoot other) {
    return narrow(6).low.compareTo(other.narrow(6).high) >= 0;
  }

  /**
   * Whether this root is before another one. Both are narrowed until their intervals are apart, or
   * they are the same in exact algebra.
   */
  boolean isBefore(SturmRoot other) {
    for (int bits = 5; ; bits *= 2) {
      narrow(bits);
      other.narrow(bits);
      if (high.compareTo(other.low) <= 0 || low.compareTo(other.high) >= 0) {
        return high.compareTo(other.low) <= 0;
      }
      if (bits == SAME_BITS && isSame(other)) {
        return false;
      }
    }
  }

  private boolean isSame(SturmRoot other) {
    return compareTo(other.low) > 0 && compareTo(other.high) < 0 && sign(other.of) == 0;
  }
}
