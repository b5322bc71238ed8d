// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A polynomial in one variable with exact coefficients. It finds its positive roots without
 * rounding.
 *
 * <p>Method: a polynomial without multiple roots has at most as many roots in an interval as the
 * coefficients of its Bernstein form on that interval change sign, and exactly one for one change
 * (Descartes' rule of signs). Intervals with more changes are split. Multiple roots go by division
 * by gcd(f, f'). Source: G. E. Collins and A. G. Akritas, Polynomial real root isolation using
 * Descartes' rule of signs, SYMSAC 1976.
 */
public final class Polynomial implements Ring<Polynomial> {

  public static final Numbers<Polynomial> EXACT =
      new Numbers<>() {
        @Override
        public Polynomial motion(double p, double q, double v, double u, double g) {
          return of(Dyadic.difference(p, q), Dyadic.difference(v, u), Dyadic.of(g).half());
        }

        @Override
        public Polynomial line(double p, double q, double v) {
          return of(Dyadic.difference(p, q), Dyadic.of(v));
        }

        @Override
        public Polynomial difference(double p, double q) {
          return of(Dyadic.difference(p, q));
        }
      };

  /** The coefficients from the constant one on; the last one is not 0. Empty for 0. */
  private final Dyadic[] c;

  private Polynomial(Dyadic... c) {
    int length = c.length;
    while (length > 0 && c[length - 1].sign() == 0) {
      length--;
    }
    this.c = Arrays.copyOf(c, length);
  }

  /** The polynomial with these coefficients, the constant one first. */
  public static Polynomial of(Dyadic... coefficients) {
    return new Polynomial(coefficients);
  }

  /** The degree; -1 for the polynomial 0. */
  public int degree() {
    return c.length - 1;
  }

  public boolean isZero() {
    return c.length == 0;
  }

  @Override
  public Polynomial plus(Polynomial that) {
    return minus(new Polynomial().minus(that));
  }

  @Override
  public Polynomial minus(Polynomial that) {
    Dyadic[] sum = new Dyadic[Math.max(c.length, that.c.length)];
    for (int i = 0; i < sum.length; i++) {
      sum[i] = at(i).minus(that.at(i));
    }
    return new Polynomial(sum);
  }

  @Override
  public Polynomial times(Polynomial that) {
    if (isZero() || that.isZero()) {
      return new Polynomial();
    }
    Dyadic[] product = new Dyadic[c.length + that.c.length - 1];
    Arrays.fill(product, Dyadic.ZERO);
    for (int i = 0; i < c.length; i++) {
      for (int j = 0; j < that.c.length; j++) {
        product[i + j] = product[i + j].plus(c[i].times(that.c[j]));
      }
    }
    return new Polynomial(product);
  }

  /** This polynomial, times 1 or -1. */
  public Polynomial signed(int sign) {
    return sign > 0 ? this : new Polynomial().minus(this);
  }

  public Polynomial derivative() {
    Dyadic[] d = new Dyadic[Math.max(0, c.length - 1)];
    for (int i = 0; i < d.length; i++) {
      d[i] = c[i + 1].times(Dyadic.of(i + 1));
    }
    return new Polynomial(d);
  }

  /** This polynomial without its constant term, over the variable. */
  public Polynomial withoutRootAtZero() {
    return new Polynomial(Arrays.copyOfRange(c, Math.min(1, c.length), c.length));
  }

  /** The constant term. */
  public Polynomial constant() {
    return of(at(0));
  }

  /** The sign just after 0. */
  public int firstSign() {
    return Arrays.stream(c).mapToInt(Dyadic::sign).filter(sign -> sign != 0).findFirst().orElse(0);
  }

  /** This polynomial less its value at 0. Its slope there counts as 0 if it is negative. */
  public Polynomial fromStart() {
    Dyadic[] gap = c.clone();
    for (int i = 0; i < Math.min(2, gap.length); i++) {
      gap[i] = i == 1 && gap[i].sign() > 0 ? gap[i] : Dyadic.ZERO;
    }
    return new Polynomial(gap);
  }

  /** The value at t. */
  Dyadic value(Dyadic t) {
    Dyadic value = Dyadic.ZERO;
    for (int i = c.length - 1; i >= 0; i--) {
      value = value.times(t).plus(c[i]);
    }
    return value;
  }

  /** The sum of the absolute values of the terms at t > 0. */
  Dyadic terms(Dyadic t) {
    Dyadic terms = Dyadic.ZERO;
    for (int i = c.length - 1; i >= 0; i--) {
      terms = terms.times(t).plus(c[i].abs());
    }
    return terms;
  }

  public int sign(Dyadic t) {
    return value(t).sign();
  }

  /**
   * The greatest common divisor, up to a factor. Each remainder is divided by what its coefficients
   * have in common: their lengths would else grow with a power of the degree. Most polynomials have
   * no common divisor, which their {@link Residues} tell in a hundredth of the time.
   */
  Polynomial gcd(Polynomial that) {
    if (Residues.areCoprime(c, that.c)) {
      return of(Dyadic.of(1));
    }
    Polynomial a = this;
    Polynomial b = that;
    while (!b.isZero()) {
      Polynomial rest = a.remainder(b).reduced();
      a = b;
      b = rest;
    }
    return a.reduced();
  }

  /** The polynomial with the same roots, each of them simple. */
  Polynomial squareFree() {
    if (degree() < 2) {
      return this;
    }
    Polynomial divisor = gcd(derivative());
    return divisor.degree() < 1 ? this : quotient(divisor).reduced();
  }

  /** The positive roots, ascending; only those before a limit, if there is one. */
  public List<RealRoot> positiveRoots(RealRoot limit) {
    List<RealRoot> roots = new ArrayList<>();
    Polynomial f = this;
    while (!f.isZero() && f.c[0].sign() == 0) {
      f = f.withoutRootAtZero();
    }
    if (f.degree() > 0) {
      f = f.squareFree();
      Dyadic low = Dyadic.powerOfTwo(f.leastExponent());
      Dyadic high = Dyadic.powerOfTwo(f.mostExponent());
      f.isolate(low, limit == null ? high : limit.least(high), roots);
    }
    return roots;
  }

  /** Adds the roots between low and high, both excluded, in order. */
  private void isolate(Dyadic low, Dyadic high, List<RealRoot> roots) {
    if (low.minus(high).sign() >= 0) {
      return;
    }
    int[] signs = bernsteinSigns(low, high);
    int changes = changes(signs);
    if (changes == 1) {
      roots.add(new RealRoot(this, first(signs), low, high));
    } else if (changes > 1) {
      Dyadic middle = Dyadic.between(low, high);
      isolate(low, middle, roots);
      if (sign(middle) == 0) {
        roots.add(new RealRoot(this, 0, middle, middle));
      }
      isolate(middle, high, roots);
    }
  }

  /**
   * Whether there is a root between low and high, both excluded, where there can be one only. Then
   * the parity of the changes of sign is that of the number of roots.
   */
  boolean hasOneRoot(Dyadic low, Dyadic high) {
    return degree() > 0 && changes(bernsteinSigns(low, high)) % 2 == 1;
  }

  /**
   * The one sign of this polynomial in the closed interval from low to high; 0 if its Bernstein
   * form leaves open whether it has a root there.
   */
  int signThroughout(Dyadic low, Dyadic high) {
    int[] signs = bernsteinSigns(low, high);
    boolean same = Arrays.stream(signs).allMatch(sign -> sign == signs[0]);
    return same ? signs[0] : 0;
  }

  /**
   * The signs of the Bernstein coefficients b. With {@code f(low + (high - low) x) = g(x)}, the
   * polynomial {@code (1 + y)^n g(1 / (1 + y))} has the coefficients {@code C(n, k) b_(n - k)}.
   */
  private int[] bernsteinSigns(Dyadic low, Dyadic high) {
    Dyadic[] g = shifted(c, low);
    Dyadic width = high.minus(low);
    Dyadic power = width;
    for (int i = 1; i < g.length; i++) {
      g[i] = g[i].times(power);
      power = power.times(width);
    }
    Dyadic[] b = reversed(shifted(reversed(g), Dyadic.of(1)));
    return Arrays.stream(b).mapToInt(Dyadic::sign).toArray();
  }

  /** The coefficients of f(x + by) in x, from those of f. */
  private static Dyadic[] shifted(Dyadic[] f, Dyadic by) {
    Dyadic[] a = f.clone();
    for (int i = 0; i < a.length; i++) {
      for (int j = a.length - 2; j >= i; j--) {
        a[j] = a[j].plus(a[j + 1].times(by));
      }
    }
    return a;
  }

  private static Dyadic[] reversed(Dyadic[] a) {
    Dyadic[] reversed = new Dyadic[a.length];
    Arrays.setAll(reversed, i -> a[a.length - 1 - i]);
    return reversed;
  }

  private static int first(int[] signs) {
    return Arrays.stream(signs).filter(sign -> sign != 0).findFirst().orElse(0);
  }

  private static int changes(int[] signs) {
    int changes = 0;
    int last = 0;
    for (int sign : signs) {
      changes += sign * last < 0 ? 1 : 0;
      last = sign != 0 ? sign : last;
    }
    return changes;
  }

  /**
   * A k such that all roots are below 2^k in size: Fujiwara's bound is 2 max |c_i / c_n|^(1 / (n -
   * i)), and a quotient is below 2^(1 + the difference of the magnitudes).
   */
  private int mostExponent() {
    int n = degree();
    int most = Integer.MIN_VALUE;
    for (int i = 0; i < n; i++) {
      if (c[i].sign() != 0) {
        int quotient = c[i].magnitude() + 1 - c[n].magnitude();
        most = Math.max(most, 2 + Math.floorDiv(quotient, n - i));
      }
    }
    return most;
  }

  /** A k such that all roots are above 2^k in size; the constant term must not be 0. */
  private int leastExponent() {
    return -new Polynomial(reversed(c)).mostExponent();
  }

  /** A positive multiple of the remainder of the division by that one. */
  private Polynomial remainder(Polynomial that) {
    Dyadic[] rest = c.clone();
    divide(rest, null, that);
    return new Polynomial(rest);
  }

  /** A multiple of the quotient by a divisor. */
  private Polynomial quotient(Polynomial divisor) {
    Dyadic[] quotient = new Dyadic[degree() - divisor.degree() + 1];
    Arrays.fill(quotient, Dyadic.ZERO);
    divide(c.clone(), quotient, divisor);
    return new Polynomial(quotient);
  }

  /** Division without fractions: each step multiplies by the divisor's leading coefficient. */
  private static void divide(Dyadic[] rest, Dyadic[] quotient, Polynomial divisor) {
    int n = divisor.degree();
    Dyadic lead = divisor.c[n];
    for (int k = rest.length - 1; k >= n; k--) {
      Dyadic factor = rest[k];
      for (int i = 0; i < k; i++) {
        rest[i] = rest[i].times(lead);
      }
      for (int i = 0; i < n; i++) {
        rest[k - n + i] = rest[k - n + i].minus(factor.times(divisor.c[i]));
      }
      rest[k] = Dyadic.ZERO;
      if (quotient != null) {
        for (int i = k - n + 1; i < quotient.length; i++) {
          quotient[i] = quotient[i].times(lead);
        }
        quotient[k - n] = factor;
      }
    }
  }

  /** This polynomial over the common divisor of its coefficients. */
  private Polynomial reduced() {
    Dyadic divisor = Dyadic.ZERO;
    for (Dyadic coefficient : c) {
      divisor = divisor.gcd(coefficient);
    }
    Dyadic[] reduced = new Dyadic[c.length];
    for (int i = 0; i < c.length; i++) {
      reduced[i] = c[i].exactQuotient(divisor);
    }
    return new Polynomial(reduced);
  }

  Dyadic at(int i) {
    return i < c.length ? c[i] : Dyadic.ZERO;
  }
}
