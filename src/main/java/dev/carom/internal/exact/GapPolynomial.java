// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A polynomial in time, of degree 9 at most, whose signs and roots are certain.
 *
 * <p>It has one of two forms. The coefficients of the first form are rounded doubles. Beside each
 * stands its size: the sum of the absolute values of the terms that made it. The coefficients of
 * the second form are sums of doubles without rounding. A sign is told only where the value exceeds
 * a bound of its error; in the second form every tie is recognised, too.
 *
 * <p>The error of a rounded coefficient, in units of its size and of {@code u = 2^-53}: a
 * difference of two numbers of the question has 1 u, a product 1 u more than its factors together,
 * a sum 1 u more than its summands. In the gap of a side ({@link Gaps}) the height has 4 u, its
 * square, of which a coefficient is a sum of three, 11 u, {@code r^2 w.w} has 6 u: 12 u in all. In
 * that of an end an offset has 1 u, its square 5 u: 7 u in all. The bounds here take 14 u.
 *
 * <p>Of an obstacle that turns ({@link TurningGaps}) c^2 and n have 2 u, the line W times c^2 5 u.
 * With an offset, in a sum of six, that has 9 u, the constant times n 7 u, the height 11 u, its
 * square, with five terms, 25 u, and {@code r^2 w.w n^2} less. So the gap of a side has 26 u, and
 * that of an end 14 u: n 2 u, a square of the distance 7 u, a product of the two 12 u. The rate has
 * 7 u more: of {@code g' n} 1 u is that of a derivative, 2 u those of n, 4 u a product, a sum of
 * three and a difference, and a second difference has 1 u. It is 34 u in all, and the bounds take
 * 38 u.
 *
 * <p>Not safe for use by several threads.
 */
public final class GapPolynomial implements Ring<GapPolynomial> {

  private static final Expansion HALF = Expansion.sum(0.5, 0);

  /** The sign is open. */
  public static final int UNKNOWN = 2;

  /** The most coefficients. */
  private static final int MOST = 10;

  private static final double U = 0x1p-53;

  /**
   * A Bernstein coefficient on an interval from low to high, of the terms at high, is {@code
   * PLACE_BOUND + n STEP_BOUND} for the degree n: the powers of low, those of the width and the
   * conversion, a division and n sums, take 2 u each for a degree, of which one is the rounding of
   * the width; a coefficient has 14 u; the terms are computed, too.
   */
  private static final double PLACE_BOUND = 16 * U;

  private static final double STEP_BOUND = 9 * U;

  /** A rounded coefficient, of its terms. */
  private static final double COEFFICIENT_BOUND = 16 * U;

  /** What both bounds have besides if the obstacle turns. */
  private static final double TURN_BOUND = 24 * U;

  /**
   * The value in double-double, of the terms, in {@code u^2}: a coefficient has 64, a product and a
   * sum 5 and 4 for each degree: 145 for degree 9.
   */
  private static final double VALUE_BOUND = 160 * U * U;

  /**
   * More than the underflow of 128 operations, 2^-1067, times a power of the time if that is above
   * 1. A product with a subnormal number would take much longer.
   */
  private static final double TINY = 0x1p-1000;

  /** The least size of terms that are not 0: its rounding is more than what underflows. */
  private static final double LEAST_SIZE = 0x1p-900;

  /** Above this, half an ulp of a time is a double. */
  private static final double EARLIEST = 0x1p-1000;

  /** Corrections of a time by Newton's method, or halvings. More cost time only. */
  private static final int CORRECTIONS = 80;

  /**
   * A step, of the time, at which the search with rounded coefficients ends: its next one would be
   * the square of it, or rounding. A smaller one costs time, a greater one later corrections.
   */
  private static final double LAST_STEP = 0x1p-40;

  /** Doubles beside a time that are tried. */
  private static final int NEIGHBORS = 6;

  /** Polynomials without rounding. */
  public static final Numbers<GapPolynomial> EXACT =
      new Numbers<>() {
        @Override
        public GapPolynomial motion(double p, double q, double v, double u, double g) {
          Expansion bend = HALF.times(Expansion.sum(g, 0));
          return exact(Expansion.difference(p, q), Expansion.difference(v, u), bend);
        }

        @Override
        public GapPolynomial line(double p, double q, double v) {
          return exact(Expansion.difference(p, q), Expansion.sum(v, 0));
        }

        @Override
        public GapPolynomial difference(double p, double q) {
          return exact(Expansion.difference(p, q));
        }
      };

  /**
   * Polynomials of which each coefficient is rounded once. Those of one question are used again by
   * the next one.
   */
  public static final class Pool implements Numbers<GapPolynomial> {
    private final List<GapPolynomial> all = new ArrayList<>();
    private int used;

    /** What bounds have besides. */
    private double bound;

    /** Takes all polynomials back, for a question about an obstacle that turns or not. */
    public void reset(boolean turns) {
      used = 0;
      bound = turns ? TURN_BOUND : 0;
    }

    @Override
    public GapPolynomial motion(double p, double q, double v, double u, double g) {
      double bend = g != 0 && 0.5 * g == 0 ? g : 0.5 * g; // not 0 if the half underflows
      return zero(3).set(0, p - q).set(1, v - u).set(2, bend);
    }

    @Override
    public GapPolynomial line(double p, double q, double v) {
      return zero(2).set(0, p - q).set(1, v);
    }

    @Override
    public GapPolynomial difference(double p, double q) {
      return zero(1).set(0, p - q);
    }

    private GapPolynomial zero(int length) {
      if (used == all.size()) {
        all.add(new GapPolynomial(this, null, MOST));
      }
      return all.get(used++).clear(length);
    }
  }

  /** Where polynomials on the rung of rounded coefficients come from; null on the other rung. */
  private final Pool pool;

  /** The coefficients without rounding; null on the other rung. */
  private final Expansion[] exact;

  private int length;

  /** What the bounds have besides. */
  private double bound;

  /** The rounded coefficients, the constant one first, and the sums of their absolute terms. */
  private final double[] c;

  private final double[] size;

  /** Whether nothing has underflowed or overflowed in those without rounding. */
  private boolean isSafe = true;

  // Found when they are first asked for.
  private BoundedNumber[] values;
  private GapPolynomial derivative;
  private final double[] bernstein;

  /** Whether the last question for a sign found no Bernstein coefficient above its bound. */
  private boolean isLost;

  /** Whether that question found their signs to change once, to that below 0. */
  private boolean fallsOnce;

  private GapPolynomial(Pool pool, Expansion[] exact, int capacity) {
    this.pool = pool;
    this.exact = exact;
    length = capacity;
    c = new double[capacity];
    size = new double[capacity];
    bernstein = new double[capacity];
  }

  public static GapPolynomial exact(Expansion... coefficients) {
    return new GapPolynomial(null, coefficients, coefficients.length);
  }

  private GapPolynomial clear(int newLength) {
    length = newLength;
    bound = pool.bound;
    derivative = null;
    Arrays.fill(c, 0, newLength, 0);
    Arrays.fill(size, 0, newLength, 0);
    return this;
  }

  private GapPolynomial set(int i, double value) {
    double terms = Math.abs(value);
    c[i] = value;
    size[i] = terms == 0 ? 0 : Math.max(terms, LEAST_SIZE);
    return this;
  }

  // The ring.

  @Override
  public GapPolynomial plus(GapPolynomial that) {
    return plus(1, that);
  }

  @Override
  public GapPolynomial minus(GapPolynomial that) {
    return plus(-1, that);
  }

  private GapPolynomial plus(int sign, GapPolynomial that) {
    GapPolynomial sum = zero(Math.max(length, that.length));
    sum.add(1, this);
    sum.add(sign, that);
    return sum;
  }

  private void add(int sign, GapPolynomial that) {
    for (int i = 0; i < that.length; i++) {
      if (exact != null) {
        exact[i].add(sign, that.exact[i]);
      } else {
        c[i] += sign * that.c[i];
        size[i] += that.size[i];
      }
    }
  }

  @Override
  public GapPolynomial times(GapPolynomial that) {
    GapPolynomial product = zero(length + that.length - 1);
    boolean isSquare = that == this; // so that most products are there twice
    for (int i = 0; i < length; i++) {
      for (int j = isSquare ? i : 0; j < that.length; j++) {
        product.add(isSquare && i < j ? 2 : 1, i, j, this, that);
      }
    }
    return product;
  }

  private void add(int factor, int i, int j, GapPolynomial a, GapPolynomial b) {
    if (exact != null) {
      exact[i + j].add(factor, a.exact[i], b.exact[j]);
    } else if (a.size[i] != 0 && b.size[j] != 0) {
      c[i + j] += factor * (a.c[i] * b.c[j]);
      size[i + j] += Math.max(factor * (a.size[i] * b.size[j]), LEAST_SIZE);
    }
  }

  private GapPolynomial zero(int newLength) {
    if (exact == null) {
      return pool.zero(newLength);
    }
    Expansion[] sums = new Expansion[newLength];
    Arrays.setAll(sums, i -> new Expansion());
    return exact(sums);
  }

  public GapPolynomial derivative() {
    if (derivative == null) {
      GapPolynomial d = zero(Math.max(1, length - 1));
      for (int i = 1; i < length; i++) {
        if (exact != null) {
          d.exact[i - 1].add(1, exact[i], Expansion.sum(i, 0));
        } else {
          d.c[i - 1] = i * c[i];
          d.size[i - 1] = i * size[i];
        }
      }
      derivative = d;
    }
    return derivative;
  }

  /** The constant term. */
  public GapPolynomial constant() {
    GapPolynomial constant = zero(1);
    if (exact != null) {
      constant.exact[0] = exact[0];
    } else {
      constant.c[0] = c[0];
      constant.size[0] = size[0];
    }
    return constant;
  }

  /** This polynomial, times 1 or -1. */
  public GapPolynomial signed(int sign) {
    return sign > 0 ? this : zero(1).minus(this);
  }

  /**
   * This polynomial less its value at 0. A slope there that is certain to be below 0 counts as 0.
   */
  public GapPolynomial counted() {
    GapPolynomial gap = zero(length);
    for (int i = 1; i < length; i++) {
      if (i > 1 || coefficientSign(1) >= 0) {
        if (exact != null) {
          gap.exact[i] = exact[i];
        } else {
          gap.c[i] = c[i];
          gap.size[i] = size[i];
        }
      }
    }
    return gap;
  }

  /** This polynomial without its constant term, over the variable. */
  public GapPolynomial overTime() {
    return exact(Arrays.copyOfRange(exact, 1, length));
  }

  // Signs.

  public boolean isExact() {
    return exact != null;
  }

  /** Whether this is the polynomial 0, for certain. */
  public boolean isZero() {
    for (int i = 0; i < length; i++) {
      if (coefficientSign(i) != 0) {
        return false;
      }
    }
    return true;
  }

  /** The sign of a coefficient. */
  private int coefficientSign(int i) {
    if (exact != null) {
      return exact[i].isExact() ? exact[i].sign() : UNKNOWN;
    }
    return size[i] == 0 ? 0 : certain(c[i], (COEFFICIENT_BOUND + bound) * size[i]);
  }

  private int certain(double value, double bound) {
    return !isSafe ? UNKNOWN : value > bound ? 1 : value < -bound ? -1 : UNKNOWN;
  }

  /** The first sign after time 0, where the first coefficients may be 0. */
  public int signAfterStart() {
    int sign = 0;
    for (int i = 0; i < length && sign == 0; i++) {
      sign = coefficientSign(i);
    }
    return sign;
  }

  /** The last sign before time 0; 0 if it is not known. */
  public int signBeforeStart() {
    int sign = 0;
    for (int i = 0; i < length && sign == 0; i++) {
      sign = (i % 2 == 0 ? 1 : -1) * coefficientSign(i);
    }
    return Math.abs(sign) == UNKNOWN ? 0 : sign;
  }

  /** The sign at time 0. */
  public int signAtStart() {
    return coefficientSign(0);
  }

  /** Rounds the coefficients without rounding, when they are first needed. */
  private void prepare() {
    if (exact == null || values != null) {
      return;
    }
    values = new BoundedNumber[length];
    for (int i = 0; i < length; i++) {
      isSafe &= exact[i].isExact();
      values[i] = exact[i].value();
      c[i] = values[i].head();
      size[i] = Math.abs(c[i]);
    }
  }

  /**
   * The one sign in an interval, time 0 excluded; 0 if it changes there, or is in doubt. It is that
   * of the Bernstein coefficients: the polynomial is a mean of them. At time 0 the first one that
   * is not 0 is a coefficient of the polynomial times a positive number.
   */
  public int sign(double low, double high) {
    prepare();
    int n = length - 1;
    double bound = bernstein(low, high);
    int first = 0;
    int sign = 0;
    if (low == 0) {
      while (first <= n && sign == 0) {
        sign = coefficientSign(first++);
      }
    }
    boolean isOne = sign != UNKNOWN;
    int last = sign;
    isLost = true;
    fallsOnce = true;
    for (int j = first; j <= n; j++) {
      int here = certain(bernstein[j], bound);
      isLost &= here == UNKNOWN;
      sign = sign == 0 ? here : sign;
      isOne &= here == sign && here != UNKNOWN;
      fallsOnce &= here == -1 || (here == 1 && last != -1);
      last = here;
    }
    fallsOnce &= sign == 1 && last == -1;
    return isOne ? sign : 0;
  }

  /**
   * Whether the polynomial in the interval of the last {@link #sign} is certain to have one root,
   * at which it falls: the Bernstein coefficients change their sign once (Descartes' rule).
   */
  public boolean fallsOnce() {
    return fallsOnce;
  }

  /** Whether the last {@link #sign} is in doubt, and is so in each part of the interval. */
  public boolean isLost() {
    return isLost;
  }

  /**
   * Computes the Bernstein coefficients on an interval: with {@code f(low + width x) = sum a[i]
   * x^i} they are {@code b[j] = sum C(j, i) a[i] / C(n, i)}. Returns a bound of their errors.
   */
  private double bernstein(double low, double high) {
    int n = length - 1;
    double width = high - low;
    double[] a = bernstein;
    System.arraycopy(c, 0, a, 0, length);
    for (int i = 0; i < n && low != 0; i++) {
      for (int j = n - 1; j >= i; j--) {
        a[j] += a[j + 1] * low;
      }
    }
    double binomial = 1; // C(n, i)
    for (int i = 1; i <= n; i++) {
      for (int j = i; j <= n; j++) {
        a[j] *= width;
      }
      binomial = binomial * (n + 1 - i) / i;
      a[i] /= binomial;
    }
    for (int i = 1; i <= n; i++) {
      for (int j = n; j >= i; j--) {
        a[j] += a[j - 1];
      }
    }
    return bound(high);
  }

  /**
   * The sign at {@code t + rest}, with a rest of an ulp at most; {@link #UNKNOWN} in doubt. It is 0
   * only for a true root.
   */
  public int signAt(double t, double rest) {
    prepare();
    int sign = rest == 0 || t > EARLIEST ? roundedSign(t) : UNKNOWN;
    if (sign != UNKNOWN || exact == null || !isSafe) {
      return sign;
    }
    BoundedNumber value = value(t, rest);
    sign = certain(value.head(), VALUE_BOUND * value.terms());
    return sign != UNKNOWN ? sign : exactSign(t, rest);
  }

  private int roundedSign(double t) {
    prepare();
    return certain(value(t), bound(t));
  }

  private int exactSign(double t, double rest) {
    Expansion time = Expansion.sum(t, rest);
    Expansion value = new Expansion();
    for (int i = length - 1; i >= 0; i--) {
      value = value.times(time).plus(exact[i]);
    }
    return value.isExact() ? value.sign() : UNKNOWN;
  }

  private double terms(double t) {
    double terms = 0;
    for (int i = length - 1; i >= 0; i--) {
      terms = terms * t + size[i];
    }
    return terms;
  }

  /** A bound of the rounding of a value, or of a Bernstein coefficient on an interval up to t. */
  private double bound(double t) {
    return (PLACE_BOUND + bound + length * STEP_BOUND) * terms(t) + TINY * power(t);
  }

  /** The n-th power of the time, or 1: what underflow is multiplied with. */
  private double power(double t) {
    double power = 1;
    for (int i = 1; i < length; i++) {
      power *= Math.max(1, t);
    }
    return power;
  }

  private double value(double t) {
    double value = 0;
    for (int i = length - 1; i >= 0; i--) {
      value = value * t + c[i];
    }
    return value;
  }

  /** The value at {@code t + rest}, in double-double. */
  private BoundedNumber value(double t, double rest) {
    BoundedNumber time = BoundedNumber.of(t, rest);
    BoundedNumber value = values[length - 1];
    for (int i = length - 2; i >= 0; i--) {
      value = value.times(time).plus(values[i]);
    }
    return value;
  }

  private double slope(double t) {
    double slope = 0;
    for (int i = length - 1; i > 0; i--) {
      slope = slope * t + i * c[i];
    }
    return slope;
  }

  /**
   * The sign where the slope is 0, within a width of t; {@link #UNKNOWN} in doubt. The bend has one
   * sign there. So the value lies between that at t and the tangent at t: they differ by the width
   * times the slope at most.
   */
  public int signAtTurn(double t, double width) {
    prepare();
    double rounding = bound(t);
    double slope = Math.abs(slope(t)) + rounding * length / t;
    if (exact == null) {
      return certain(value(t), rounding + width * slope);
    }
    BoundedNumber value = value(t, 0);
    int sign = certain(value.head(), VALUE_BOUND * value.terms() + width * slope);
    boolean isTie = sign == UNKNOWN && derivative().signAt(t, 0) == 0 && signAt(t, 0) == 0;
    return isTie ? 0 : sign;
  }

  /**
   * The same of a gap with a rate of its own, that is monotone and 0 within a width of t. From t on
   * it changes by no more than the width times the rate at t, times a factor.
   */
  public int signAtTurn(double t, double width, GapPolynomial rate, double factor) {
    prepare();
    rate.prepare();
    double change = factor * width * (Math.abs(rate.value(t)) + rate.bound(t));
    if (exact == null) {
      return certain(value(t), bound(t) + change);
    }
    BoundedNumber value = value(t, 0);
    int sign = certain(value.head(), VALUE_BOUND * value.terms() + change);
    boolean isTie = sign == UNKNOWN && rate.signAt(t, 0) == 0 && signAt(t, 0) == 0;
    return isTie ? 0 : sign;
  }

  /** The sign at all times that are rounded to t; {@link #UNKNOWN} in doubt. */
  public int signNear(double t) {
    return isZero() ? 0 : t > EARLIEST ? roundedSign(t) : UNKNOWN;
  }

  /** Whether t is a root at which this polynomial falls, and the only root that is rounded to t. */
  public boolean fallsAt(double t) {
    return signAt(t, 0) == 0 && derivative().signNear(t) == -1;
  }

  /** The part of a window from 0 in which the first two terms that are not 0 are alike in size. */
  public double scale() {
    prepare();
    for (int i = 0; i + 1 < length; i++) {
      if (c[i] != 0) {
        return 2 * Math.abs(c[i] / c[i + 1]);
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  // Roots.

  /**
   * The double nearest to the only root in an interval, a tie to the even one; NaN in doubt. The
   * coefficients must be without rounding.
   *
   * @param before the sign before the root
   */
  public double nearestRoot(int before, double low, double high) {
    prepare();
    double t = root(before, low, high);
    for (int i = 0; i < NEIGHBORS && t > EARLIEST; i++) {
      int down = t <= low ? before : signAt(t, 0.5 * (Math.nextDown(t) - t));
      int up = t >= high ? -before : signAt(t, 0.5 * Math.ulp(t));
      if (down == UNKNOWN || up == UNKNOWN) {
        return Double.NaN;
      }
      boolean isEven = (Double.doubleToRawLongBits(t) & 1) == 0;
      if (down == before ? up == -before || (up == 0 && isEven) : down == 0 && isEven) {
        return t;
      }
      t = down == before ? Math.nextUp(t) : Math.nextDown(t);
    }
    return Double.NaN;
  }

  /**
   * The correctly rounded time at which the gap of a straight flight falls to 0, see {@link
   * #fallWithin}. It is a line or a convex parabola {@code c + b t + a t^2}, with its first root
   * before {@code -2 c / b} and before its vertex.
   */
  public double fallOfConvex(double T) {
    return fallWithin(Math.min(scale(), 0.5 * derivative().scale()), T);
  }

  /**
   * The correctly rounded time at which a gap that falls up to a time falls to 0, {@code +infinity}
   * if that is later than T; 0 if it is not above 0 at the start. NaN in doubt, and if it is not
   * certain to be below 0 at that time.
   */
  public double fallWithin(double high, double T) {
    if (signAtStart() != 1) {
      return signAtStart() == UNKNOWN ? Double.NaN : 0;
    }
    double time = signAt(high, 0) == -1 ? nearestRoot(1, 0, high) : Double.NaN;
    int atEnd = time == T ? signAt(T, 0) : 0;
    return time > T || atEnd == 1 ? Double.POSITIVE_INFINITY : atEnd == UNKNOWN ? Double.NaN : time;
  }

  /**
   * About the only root in an interval, by Newton's method: in doubles, and if without rounding, in
   * double-double from there on.
   */
  public double root(int before, double low, double high) {
    double t = root(before, low, high, 0.5 * (low + high), false);
    return exact == null ? t : root(before, low, high, t, true);
  }

  private double root(int before, double low, double high, double start, boolean isPrecise) {
    double from = low;
    double to = high;
    double t = start;
    for (int i = 0; i < CORRECTIONS; i++) {
      double value = before * (isPrecise ? value(t, 0).head() : value(t));
      if (value > 0) {
        from = t;
      } else {
        to = t;
      }
      double next = t - value / (before * slope(t));
      next = next >= from && next <= to ? next : 0.5 * (from + to);
      if (Math.abs(next - t) <= (isPrecise ? 0.5 * Math.ulp(t) : LAST_STEP * t)) {
        return next;
      }
      t = next;
    }
    return t;
  }
}
