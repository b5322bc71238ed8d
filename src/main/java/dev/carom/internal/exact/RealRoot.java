// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * A positive real root of a polynomial, by an interval that contains it and no other root. Each
 * question narrows the interval only as far as its answer needs.
 */
public final class RealRoot {

  /** Halvings before the question whether two roots are the same is asked in exact algebra. */
  private static final int HALVINGS = 16;

  /** Bits of a vector before it is rounded. */
  private static final int BITS = 64;

  private final Polynomial f;

  /** The sign of f before the root, within the interval. */
  private final int before;

  private Dyadic low;
  private Dyadic high;

  /** The root between low and high, both excluded; or low itself, if they are equal. */
  RealRoot(Polynomial f, int before, Dyadic low, Dyadic high) {
    this.f = f;
    this.before = before;
    this.low = low;
    this.high = high;
  }

  /** The root that is a given number. */
  public static RealRoot at(Dyadic t) {
    return new RealRoot(null, 0, t, t);
  }

  /**
   * The time at which the gap of a straight flight falls to 0: its least root, or 0 if it is not
   * above 0 at the start.
   */
  public static RealRoot ofStraight(Polynomial gap) {
    return gap.sign(Dyadic.ZERO) <= 0
        ? ExactParabola.START
        : gap.positiveRoots(null).stream().findFirst().orElseThrow(ArithmeticException::new);
  }

  /** A power of two after a time. */
  static RealRoot after(double time) {
    return at(Dyadic.powerOfTwo(Math.getExponent(Math.max(time, Double.MIN_NORMAL)) + 1));
  }

  private boolean isExact() {
    return low == high;
  }

  /** The sign of this root less m. */
  public int compare(Dyadic m) {
    int aboveLow = m.minus(low).sign();
    if (isExact()) {
      return -aboveLow;
    }
    if (aboveLow <= 0) {
      return 1;
    }
    if (m.minus(high).sign() >= 0) {
      return -1;
    }
    int sign = f.sign(m);
    if (sign == before) {
      low = m;
    } else {
      high = m;
      low = sign == 0 ? m : low;
    }
    return sign == 0 ? 0 : sign == before ? 1 : -1;
  }

  /** The sign of this root less another one. */
  public int compare(RealRoot that) {
    for (int i = 0; ; i++) {
      if (that.isExact()) {
        return compare(that.low);
      }
      if (isExact()) {
        return -that.compare(low);
      }
      if (high.minus(that.low).sign() <= 0) {
        return -1;
      }
      if (low.minus(that.high).sign() >= 0) {
        return 1;
      }
      if (i == HALVINGS && isSame(that)) {
        return 0;
      }
      halve();
      that.halve();
    }
  }

  /** The order of two times of impact that are rounded alike: a decision. */
  public int order(RealRoot that) {
    PrecisionCounter.DOUBTFUL_DECISIONS.add();
    PrecisionCounter.EXACT_DECISIONS.add();
    return compare(that);
  }

  /** Whether the common divisor has a root where the intervals meet: it is this one and that. */
  private boolean isSame(RealRoot that) {
    Dyadic from = low.minus(that.low).sign() < 0 ? that.low : low;
    Dyadic to = high.minus(that.high).sign() < 0 ? high : that.high;
    return f.gcd(that.f).hasOneRoot(from, to);
  }

  /** The sign of a polynomial at this root. */
  public int sign(Polynomial q) {
    for (int i = 0; ; i++) {
      if (q.degree() < 1 || isExact()) {
        return q.sign(low);
      }
      int sign = q.signThroughout(low, high);
      if (sign != 0 || (i == HALVINGS && vanishes(q))) {
        return sign;
      }
      halve();
    }
  }

  private boolean vanishes(Polynomial q) {
    return f.gcd(q).hasOneRoot(low, high);
  }

  private void halve() {
    if (!isExact()) {
      compare(Dyadic.between(low, high));
    }
  }

  /** A number between this root, or 0, and a later one. */
  Dyadic between(RealRoot later) {
    while (high.minus(later.low).sign() >= 0) {
      halve();
      later.halve();
    }
    return high.sign() == 0 ? later.low.half() : Dyadic.between(high, later.low);
  }

  /** A number after this root, or after 0. */
  Dyadic after() {
    return high.sign() == 0 ? Dyadic.of(1) : high.plus(high);
  }

  /** The lesser of this given number and another one. */
  Dyadic least(Dyadic that) {
    return low.minus(that).sign() < 0 ? low : that;
  }

  /** The correctly rounded value, a tie to the even double; infinite beyond the range. */
  public double nearest() {
    // Doubles from 0 on are in the order of their bits. The answer is the first one whose upper
    // middle is not below the root, or, if the middle is the root, that is even.
    long first = 0;
    long last = Double.doubleToRawLongBits(Double.POSITIVE_INFINITY);
    while (first < last) {
      long bits = (first + last) >>> 1;
      int sign = compare(middle(Double.longBitsToDouble(bits)));
      if (sign < 0 || (sign == 0 && (bits & 1) == 0)) {
        last = bits;
      } else {
        first = bits + 1;
      }
    }
    return Double.longBitsToDouble(first);
  }

  /** The same, {@code +infinity} if this root is later than T. */
  public double upTo(double T) {
    boolean isLate = T < Double.POSITIVE_INFINITY && compare(Dyadic.of(T)) > 0;
    return isLate ? Double.POSITIVE_INFINITY : nearest();
  }

  /** Whether the correctly rounded value is above s. */
  boolean isRoundedAbove(double s) {
    if (s < 0) {
      return true;
    }
    int sign = compare(middle(s));
    return sign > 0 || (sign == 0 && (Double.doubleToRawLongBits(s) & 1) == 1);
  }

  /**
   * The unit vector of (x, y) at this root, where it does not vanish. The root is narrowed until
   * the error of x and y, its relative width times at most twice the terms' degrees, is small
   * beside the greater of them.
   */
  UnitVector unit(Polynomial x, Polynomial y) {
    while (!isExact() && errorExponent(x, y) > -BITS) {
      halve();
    }
    return UnitVector.of(x.value(low), y.value(low));
  }

  /** The k with an error of x(low) and y(low) below 2^k of the greater one. */
  private int errorExponent(Polynomial x, Polynomial y) {
    Dyadic size = x.value(low).abs().plus(y.value(low).abs());
    Dyadic width = high.minus(low);
    Dyadic terms = x.terms(high).plus(y.terms(high));
    if (size.sign() == 0 || high.minus(low).minus(low).sign() >= 0) {
      return 0;
    }
    // |x(t) - x(low)| <= n (high - low) / low times the terms at high, with n <= 2 < 2^3 / 4, or
    // n <= 4 for what turns.
    int degree = Math.max(x.degree(), y.degree()) > 2 ? 1 : 0;
    return terms.magnitude() + width.magnitude() - low.magnitude() - size.magnitude() + 6 + degree;
  }

  /** Halfway between a double and its upper neighbour, which is 2^1024 for the largest. */
  private static Dyadic middle(double t) {
    return Dyadic.of(t).plus(Dyadic.of(Math.ulp(t)).half());
  }
}
