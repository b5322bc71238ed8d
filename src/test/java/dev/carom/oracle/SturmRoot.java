// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** The only root of a polynomial between two positive numbers that are none. */
final class SturmRoot {
  /** Bits after which two roots that are not apart yet may be the same. */
  private static final int SAME_BITS = 80;

  private final SturmPolynomial f;
  private final boolean changesSign;
  private Dyadic low;
  private Dyadic high;

  SturmRoot(SturmPolynomial f, Dyadic low, Dyadic high) {
    this.f = f;
    this.low = low;
    this.high = high;
    changesSign = f.value(low).signum() != f.value(high).signum();
  }

  /**
   * A number between two others at which f is not 0: about the middle, by exponent if far apart.
   */
  static Dyadic noRoot(SturmPolynomial f, Dyadic low, Dyadic high) {
    boolean far = high.magnitude() - low.magnitude() > 3;
    Dyadic middle =
        far
            ? Dyadic.powerOfTwo(Math.floorDiv(high.magnitude() + low.magnitude(), 2))
            : low.plus(high).shift(-1);
    while (f.value(middle).signum() == 0) {
      middle = low.plus(middle.times(Dyadic.of(3))).shift(-2);
    }
    return middle;
  }

  private boolean isBefore(Dyadic m) {
    return changesSign ? f.value(m).signum() == f.value(high).signum() : f.roots(low, m) == 1;
  }

  private void halve() {
    Dyadic middle = noRoot(f, low, high);
    if (isBefore(middle)) {
      high = middle;
    } else {
      low = middle;
    }
  }

  /** Narrows the interval to a relative width of 2^-bits. */
  SturmRoot narrow(int bits) {
    while (high.minus(low).magnitude() > low.magnitude() - bits) {
      halve();
    }
    return this;
  }

  Dyadic low() {
    return low;
  }

  Dyadic high() {
    return high;
  }

  /** The sign of q at this root: by its slope if the value is well off 0, else by Tarski. */
  int sign(SturmPolynomial q) {
    for (int bits = 10; bits <= 90; bits += 40) {
      narrow(bits);
      Dyadic change = high.minus(low).times(q.derivative().terms(high));
      Dyadic value = q.value(low);
      if (value.abs().compareTo(change) > 0) {
        return value.signum();
      }
    }
    return f.signs(q, low, high);
  }

  /** The sign of this root less m. */
  int compareTo(Dyadic m) {
    if (m.compareTo(low) <= 0) {
      return 1;
    }
    if (m.compareTo(high) >= 0) {
      return -1;
    }
    return f.value(m).signum() == 0 ? 0 : isBefore(m) ? -1 : 1;
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
    return compareTo(other.low) > 0 && compareTo(other.high) < 0 && sign(other.f) == 0;
  }
}
