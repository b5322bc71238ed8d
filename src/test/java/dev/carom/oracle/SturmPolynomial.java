// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A polynomial over exact numbers, and its roots. They are isolated between those of the derivative
 * (M. Rolle, 1691). The signs of other polynomials at them follow in the last resort from the signs
 * of remainders in Sturm sequences (A. Tarski, A Decision Method for Elementary Algebra and
 * Geometry, 1948). No root is divided out. Doubles decide a sign only where bounds prove it.
 */
final class SturmPolynomial {
  static final SturmPolynomial ZERO = new SturmPolynomial();

  private final Dyadic[] c;
  private SturmPolynomial derivative;
  private Enclosure enclosure;
  private List<SturmRoot> roots;

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

  /** Always the same object, so that {@link SturmRoot#sign} knows it again. */
  SturmPolynomial derivative() {
    if (derivative == null) {
      Dyadic[] d = new Dyadic[Math.max(0, c.length - 1)];
      Arrays.setAll(d, i -> c[i + 1].times(Dyadic.of(i + 1)));
      derivative = new SturmPolynomial(d);
    }
    return derivative;
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
    return zeros == 0 ? this : new SturmPolynomial(Arrays.copyOfRange(c, zeros, c.length));
  }

  Dyadic value(Dyadic t) {
    Dyadic value = Dyadic.ZERO;
    for (int i = c.length - 1; i >= 0; i--) {
      value = value.times(t).plus(c[i]);
    }
    return value;
  }

  /** The sign at t >= 0. */
  int sign(Dyadic t) {
    int sign = enclosure().sign(t);
    return sign == 0 ? value(t).signum() : sign;
  }

  /** The sign from one number >= 0 to another; 0 if plain doubles leave it open. */
  int signBetween(Dyadic low, Dyadic high) {
    return enclosure().sign(low, high);
  }

  private Enclosure enclosure() {
    if (enclosure == null) {
      enclosure = new Enclosure(c);
    }
    return enclosure;
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
    return rest.negate().primitive();
  }

  /** This polynomial over a common divisor: numbers would else grow with a power of the degree. */
  private SturmPolynomial primitive() {
    return new SturmPolynomial(Dyadic.primitive(c));
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
      int sign = f.sign(t);
      variations += sign * last < 0 ? 1 : 0;
      last = sign == 0 ? last : sign;
    }
    return variations;
  }

  /** The sum of the signs of q at the roots between two numbers that are none. */
  int signs(SturmPolynomial q, Dyadic low, Dyadic high) {
    List<SturmPolynomial> mixed = chain(this, derivative().times(q));
    return variations(mixed, low) - variations(mixed, high);
  }

  /**
   * Its positive roots in ascending order, each by itself; that many as there are different ones.
   */
  List<SturmRoot> positiveRoots() {
    if (roots == null) {
      SturmPolynomial f = withoutZeroRoots();
      roots = f.changes() == 0 ? List.of() : f.isolate();
    }
    return roots;
  }

  /**
   * How often the sign changes from one coefficient to the next. There are no more positive roots,
   * and one if it changes once (Descartes' rule of signs).
   */
  private int changes() {
    int[] signs = Arrays.stream(c).mapToInt(Dyadic::signum).filter(sign -> sign != 0).toArray();
    return (int) IntStream.range(1, signs.length).filter(i -> signs[i] != signs[i - 1]).count();
  }

  /** A k: all roots are below 2^k, or their reciprocals. Cauchy's bound is 1 + max |c_i / c_n|. */
  private int reach(boolean reciprocal) {
    Dyadic lead = c[reciprocal ? 0 : degree()];
    int largest =
        Arrays.stream(c).filter(x -> x.signum() != 0).mapToInt(Dyadic::magnitude).max().orElse(0);
    return Math.max(1, largest - lead.magnitude() + 2);
  }

  /**
   * Between two neighbouring roots of its derivative the polynomial is monotone: it has a root
   * there if its signs at them differ. A root that it shares with the derivative is a multiple one.
   */
  private List<SturmRoot> isolate() {
    List<SturmRoot> found = new ArrayList<>();
    List<SturmRoot> turns = changes() > 1 ? derivative().positiveRoots() : List.of();
    Dyadic low = Dyadic.powerOfTwo(-reach(true));
    int before = c[0].signum();
    for (SturmRoot turn : turns) {
      int sign = turn.sign(this);
      if (sign == 0) {
        found.add(turn.of(this));
      } else {
        turn.narrow(this, sign);
        if (sign != before) {
          found.add(new SturmRoot(this, low, turn.low()));
        }
      }
      low = turn.high();
      before = sign(low);
    }
    if (c[degree()].signum() != before) {
      found.add(new SturmRoot(this, low, Dyadic.powerOfTwo(reach(false))));
    }
    return found;
  }
}
