// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * An exact time that is not negative: {@code (x + y sqrt(z)) / d} with {@code d > 0}. All moments
 * of contact have this form, because they solve linear or quadratic equations with exact
 * coefficients. Every comparison with an exact number is the sign of a {@link Surd}; digits serve
 * only to find the double to compare with, and to compare two moments.
 */
public final class Moment implements Comparable<Moment> {
  /** The time 0. */
  public static final Moment ZERO = new Moment(Surd.of(Dyadic.ZERO), Dyadic.ONE);

  private static final int BITS = 128;

  private final Surd numerator;
  private final Dyadic denominator;
  private Dyadic digits;
  private double rounded = Double.NaN;

  /** The moment {@code numerator / denominator}; the denominator must be positive. */
  public Moment(Surd numerator, Dyadic denominator) {
    if (denominator.signum() <= 0) {
      throw new IllegalArgumentException("denominator " + denominator);
    }
    this.numerator = numerator;
    this.denominator = denominator;
  }

  /** The sign of this time. */
  public int sign() {
    return numerator.sign();
  }

  /** {@code alpha + beta t}, times the (positive) denominator: a linear function of this time. */
  public Surd linear(Dyadic alpha, Dyadic beta) {
    return numerator.linear(alpha.times(denominator), beta);
  }

  /** {@code alpha + beta t} to about 120 bits. */
  public Dyadic linearDigits(Dyadic alpha, Dyadic beta) {
    return linear(alpha, beta).approximate(BITS).over(denominator, BITS);
  }

  /** The sign of {@code t - other}. */
  public int compareTo(Dyadic other) {
    return linear(other.negate(), Dyadic.ONE).sign();
  }

  /**
   * The sign of {@code t - other}: of their digits, as many as it takes until these differ. Times
   * that agree to 500 bits tie if {@link #norm} allows it.
   */
  @Override
  public int compareTo(Moment other) {
    int bits = BITS;
    int sign = compareDigits(other, bits);
    while (sign == 0) {
      bits *= 4;
      sign = compareDigits(other, bits);
      if (sign == 0 && norm(other).signum() == 0) {
        return 0;
      }
    }
    return sign;
  }

  /** The sign of {@code t - other}, 0 if so many bits leave it open. */
  private int compareDigits(Moment other, int bits) {
    Dyadic mine = digits(bits);
    Dyadic its = other.digits(bits);
    // Each of the two errs by less than 2^(7-bits) of itself.
    Dyadic difference = mine.minus(its);
    int largest = Math.max(mine.magnitude(), its.magnitude());
    return difference.magnitude() > largest + 9 - bits ? difference.signum() : 0;
  }

  /**
   * The product of {@code x +- sqrt(a) +- sqrt(b)} with all four pairs of signs, one of which is
   * {@code t - other} times both denominators: 0 if the two times tie.
   */
  private Dyadic norm(Moment other) {
    Surd mine = numerator.linear(Dyadic.ZERO, other.denominator);
    Surd its = other.numerator.linear(Dyadic.ZERO, denominator);
    Dyadic x = mine.x().minus(its.x());
    Dyadic a = mine.y().square().times(mine.z());
    Dyadic b = its.y().square().times(its.z());
    return x.square().minus(a).minus(b).square().minus(a.times(b).shift(2));
  }

  /** Whether this time is at most the given end of a window, which may be infinite. */
  public boolean within(double end) {
    return end == Double.POSITIVE_INFINITY
        ? Double.isFinite(nearest())
        : compareTo(Dyadic.of(end)) <= 0;
  }

  /** This time to about 120 bits. */
  public Dyadic digits() {
    if (digits == null) {
      digits = digits(BITS);
    }
    return digits;
  }

  private Dyadic digits(int bits) {
    return numerator.approximate(bits).over(denominator, bits);
  }

  /** The correctly rounded time: the nearest double, of two the even one; infinite beyond range. */
  public double nearest() {
    if (Double.isNaN(rounded)) {
      rounded = Nearest.of(digits().near(), this::compareTo);
    }
    return rounded;
  }

  /** {@code (candidate - t) / ulp(t)}, rounded; infinite for a candidate that is not finite. */
  public double errorInUlps(double candidate) {
    if (!Double.isFinite(candidate)) {
      return Double.POSITIVE_INFINITY;
    }
    return Dyadic.of(candidate).minus(digits()).over(Dyadic.of(ulp()), BITS).near();
  }

  /** The ulp of the greatest double that is not above t. */
  private double ulp() {
    double rounded = Math.min(nearest(), Double.MAX_VALUE);
    boolean above = compareTo(Dyadic.of(rounded)) < 0;
    return Math.ulp(above ? Math.nextDown(rounded) : rounded);
  }

  @Override
  public String toString() {
    return digits().toString();
  }
}
