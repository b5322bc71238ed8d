// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A polynomial over exact numbers, with Sturm sequences: the number of real roots in an interval,
 * and the signs of other polynomials at them, follow from the signs of remainders (A. Tarski, A
 * Decision Method for Elementary Algebra and Geometry, 1948). No root is divided out and no digits
 * decide.
 */
final class SturmPolynomial {
  static final SturmPolynomial ZERO = new SturmPolynomial();

  private final Dyadic[] c;
  private List<SturmPolynomial> chain;

  /** From the constant coefficient on. */
  SturmPolynomial(Dyadic... c) {
    int n = c.length;
    while (n > 0 && c[n - 1].signum() == 0) {
      n--;
    }
    this.c = Arrays.copyOf(c, n);
  }

  int degree() {
    return c.length - 1;
  }

  boolean isZero() {
    return c.length == 0;
  }

  private Dyadic at(int i) {
    return i < c.length ? c[i] : Dyadic.ZERO;
  }

  SturmPolynomial plus(SturmPolynomial other) {
    Dyadic[] sum = new Dyadic[Math.max(c.length, other.c.length)];
    Arrays.setAll(sum, i -> at(i).plus(other.at(i)));
    return new SturmPolynomial(sum);
  }

  SturmPolynomial times(Dyadic factor) {
    return new SturmPolynomial(Arrays.stream(c).map(x -> x.times(factor)).toArray(Dyadic[]::new));
  }

  SturmPolynomial negate() {
    return times(Dyadic.ONE.negate());
  }

  SturmPolynomial times(SturmPolynomial other) {
    SturmPolynomial product = ZERO;
    for (int i = 0; i < c.length; i++) {
      Dyadic[] shifted = new Dyadic[i + other.c.length];
      Arrays.fill(shifted, Dyadic.ZERO);
      for (int j = 0; j < other.c.length; j++) {
        shifted[i + j] = c[i].times(other.c[j]);
      }
      product = product.plus(new SturmPolynomial(shifted));
    }
    return product;
  }

  SturmPolynomial derivative() {
    Dyadic[] d = new Dyadic[Math.max(0, c.length - 1)];
    Arrays.setAll(d, i -> c[i + 1].times(Dyadic.of(i + 1)));
    return new SturmPolynomial(d);
  }

  /** This polynomial less its value at 0. A negative slope there counts as 0. */
  SturmPolynomial fromZero() {
    Dyadic[] d = c.clone();
    for (int i = 0; i < d.length && i < 2; i++) {
      d[i] = i == 0 || d[i].signum() < 0 ? Dyadic.ZERO : d[i];
    }
    return new SturmPolynomial(d);
  }

  /** The polynomial over the highest power of t that divides it: the roots other than 0 stay. */
  SturmPolynomial withoutZeroRoots() {
    int zeros = 0;
    while (zeros < c.length && c[zeros].signum() == 0) {
      zeros++;
    }
    return new SturmPolynomial(Arrays.copyOfRange(c, zeros, c.length));
  }

  Dyadic value(Dyadic t) {
    Dyadic value = Dyadic.ZERO;
    for (int i = c.length - 1; i >= 0; i--) {
      value = value.times(t).plus(c[i]);
    }
    return value;
  }

  /** The sum of the absolute values of the terms at t >= 0. */
  Dyadic terms(Dyadic t) {
    return new SturmPolynomial(Arrays.stream(c).map(Dyadic::abs).toArray(Dyadic[]::new)).value(t);
  }

  /** A positive multiple of the remainder, with the other sign. */
  private SturmPolynomial negatedRemainder(SturmPolynomial divisor) {
    SturmPolynomial rest = this;
    Dyadic lead = divisor.c[divisor.degree()];
    while (rest.degree() >= divisor.degree()) {
      Dyadic[] factor = new Dyadic[rest.degree() - divisor.degree() + 1];
      Arrays.fill(factor, Dyadic.ZERO);
      factor[factor.length - 1] = rest.c[rest.degree()].negate();
      SturmPolynomial scaled = rest.times(lead).plus(divisor.times(new SturmPolynomial(factor)));
      rest = lead.signum() < 0 ? scaled.negate() : scaled;
    }
    return rest.negate();
  }

  private static List<SturmPolynomial> chain(SturmPolynomial f, SturmPolynomial g) {
    List<SturmPolynomial> chain = new ArrayList<>(List.of(f));
    SturmPolynomial next = g;
    while (!next.isZero()) {
      chain.add(next);
      next = chain.get(chain.size() - 2).negatedRemainder(next);
    }
    return chain;
  }

  private static int variations(List<SturmPolynomial> chain, Dyadic t) {
    int last = 0;
    int variations = 0;
    for (SturmPolynomial f : chain) {
      int sign = f.value(t).signum();
      variations += sign * last < 0 ? 1 : 0;
      last = sign == 0 ? last : sign;
    }
    return variations;
  }

  /** The number of different roots between two numbers that are none. */
  int roots(Dyadic low, Dyadic high) {
    if (chain == null) {
      chain = chain(this, derivative());
    }
    return variations(chain, low) - variations(chain, high);
  }

  /** The sum of the signs of q at the roots between two numbers that are none. */
  int signs(SturmPolynomial q, Dyadic low, Dyadic high) {
    List<SturmPolynomial> mixed = chain(this, derivative().times(q));
    return variations(mixed, low) - variations(mixed, high);
  }

  /** Its positive roots, each by itself; that many as there are different ones. */
  List<SturmRoot> positiveRoots() {
    List<SturmRoot> found = new ArrayList<>();
    SturmPolynomial f = withoutZeroRoots();
    if (f.degree() > 0) {
      f.isolate(Dyadic.powerOfTwo(-f.reach(true)), Dyadic.powerOfTwo(f.reach(false)), found);
    }
    return found;
  }

  /** A k: all roots are below 2^k, or their reciprocals. Cauchy's bound is 1 + max |c_i / c_n|. */
  private int reach(boolean reciprocal) {
    Dyadic lead = c[reciprocal ? 0 : degree()];
    int largest =
        Arrays.stream(c).filter(x -> x.signum() != 0).mapToInt(Dyadic::magnitude).max().orElse(0);
    return Math.max(1, largest - lead.magnitude() + 2);
  }

  private void isolate(Dyadic low, Dyadic high, List<SturmRoot> found) {
    int count = roots(low, high);
    if (count == 1) {
      found.add(new SturmRoot(this, low, high));
    } else if (count > 1) {
      Dyadic middle = SturmRoot.noRoot(this, low, high);
      isolate(low, middle, found);
      isolate(middle, high, found);
    }
  }
}
