// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * An exact time of impact, {@code (p - sqrt(q)) / d} with {@code q >= 0} and {@code d > 0}: the
 * form of the times at walls, lines, pegs and circles alike.
 *
 * <p>It decides which of two impacts is earlier when their rounded times are equal. Rounding is
 * monotone, so different rounded times already decide the order; only equal ones need exact times.
 */
public record ExactTime(Dyadic p, Dyadic q, Dyadic d) {

  /** Bits of a time before it is rounded. */
  private static final int BITS = 128;

  /** Time 0: the circle touches or overlaps at the start. */
  public static final ExactTime ZERO = of(0);

  /**
   * The time at which the gap {@code c + 2 b t + a t^2} of a straight flight falls to 0. That is 0
   * if the gap is not above 0 at the start, else the lesser root {@code (-b - sqrt(b^2 - a c)) /
   * a}, or {@code -c / (2 b)} for {@code a = 0}.
   *
   * @param gap one that falls to 0
   */
  public static ExactTime of(Polynomial gap) {
    Dyadic c = gap.at(0);
    Dyadic b = gap.at(1).half();
    Dyadic a = gap.at(2);
    if (c.sign() <= 0) {
      return ZERO;
    }
    return a.sign() == 0
        ? new ExactTime(c, Dyadic.ZERO, gap.at(1).negate())
        : new ExactTime(b.negate(), b.square().minus(a.times(c)), a);
  }

  /** The value of a finite double. */
  public static ExactTime of(double t) {
    return new ExactTime(Dyadic.of(t), Dyadic.ZERO, Dyadic.of(1));
  }

  /**
   * The correctly rounded value of a positive time, a tie to the even double. It is {@code (p^2 -
   * q) / ((p + sqrt(q)) d)}, in which all terms are positive.
   */
  public double nearest() {
    PrecisionCounter.EXACT_TIMES.add();
    Dyadic t =
        q.sign() == 0
            ? p.over(d, BITS)
            : p.square().minus(q).over(p.plus(q.sqrt(BITS)).times(d), BITS);
    double low = t.floor(); // the largest double at or below t, which errs in the 120th bit
    int sign = compare(Dyadic.of(low).plus(Dyadic.of(Math.ulp(low)).half()));
    boolean isEven = (Double.doubleToRawLongBits(low) & 1) == 0;
    return sign < 0 || (sign == 0 && isEven) ? low : Math.nextUp(low);
  }

  /** The sign of p - sqrt(q) - d m. */
  private int compare(Dyadic m) {
    Dyadic x = p.minus(d.times(m));
    return x.times(x.abs()).minus(q).sign(); // x |x| keeps the order, and needs no root
  }

  /** The correctly rounded value of a positive time, {@code +infinity} if it is later than T. */
  public double upTo(double T) {
    return upTo(nearest(), T);
  }

  /** The same, given the correctly rounded value t. */
  public double upTo(double t, double T) {
    return t < T || T == Double.POSITIVE_INFINITY || (t == T && compare(Dyadic.of(T)) <= 0)
        ? t
        : Double.POSITIVE_INFINITY;
  }

  /**
   * The sign of this time less another one.
   *
   * <p>Multiplied by both denominators the difference is {@code x + (sqrt(b) - sqrt(a))}. If its
   * two terms disagree in sign, their squares tell which is larger: {@code x^2 - (sqrt(b) -
   * sqrt(a))^2 = y + 2 sqrt(a b)} with {@code y = x^2 - a - b}, whose sign is found by squaring
   * once more.
   */
  public int compare(ExactTime that) {
    PrecisionCounter.DOUBTFUL_DECISIONS.add();
    PrecisionCounter.EXACT_DECISIONS.add();
    Dyadic x = p.times(that.d).minus(that.p.times(d));
    Dyadic a = q.times(that.d.square());
    Dyadic b = that.q.times(d.square());
    int rational = x.sign();
    int roots = b.minus(a).sign();
    if (rational * roots >= 0) {
      return rational != 0 ? rational : roots;
    }
    Dyadic y = x.square().minus(a.plus(b));
    return y.sign() > 0 ? rational : rational * a.times(b).minus(y.half().square()).sign();
  }
}
