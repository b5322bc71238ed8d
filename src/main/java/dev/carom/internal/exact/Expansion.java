// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import java.util.Arrays;

/**
 * A sum of doubles without rounding: what cancels in it leaves all its digits. Some hundred times
 * faster than {@link Dyadic} for the polynomials of a sweep.
 *
 * <p>The parts do not overlap and ascend in magnitude, zeros are left out: J. R. Shewchuk, Adaptive
 * Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, Discrete and
 * Computational Geometry 18 (1997), theorem 10. Each part is below half the last bit of the next
 * one.
 */
public final class Expansion implements Ring<Expansion> {

  /** A product of at least this much has a tail that does not underflow. */
  private static final double LEAST_PRODUCT = 0x1p-900;

  private static final int PARTS = 8;

  /**
   * The most parts of a sum. Its time grows with their square, and with as many a {@link Dyadic}
   * number is faster. Only numbers of magnitudes very far apart have so many.
   */
  private static final int MOST_PARTS = 64;

  private double[] parts = new double[PARTS];
  private int count;
  private boolean isExact = true;

  /** a - b. */
  public static Expansion difference(double a, double b) {
    double d = a - b;
    return new Expansion().add(differenceTail(a, b, d)).add(d);
  }

  /** a + b. */
  public static Expansion sum(double a, double b) {
    return new Expansion().add(a).add(b);
  }

  @Override
  public Expansion plus(Expansion that) {
    return new Expansion().add(1, this).add(1, that);
  }

  @Override
  public Expansion minus(Expansion that) {
    return new Expansion().add(1, this).add(-1, that);
  }

  @Override
  public Expansion times(Expansion that) {
    return new Expansion().add(1, this, that);
  }

  /** Adds a number. Once something is lost, nothing more is added. */
  public Expansion add(double x) {
    if (!isExact || x == 0) {
      return this;
    }
    if (count == parts.length) {
      parts = Arrays.copyOf(parts, 2 * count);
    }
    double sum = x;
    int kept = 0;
    for (int i = 0; i < count; i++) {
      double part = parts[i];
      double next = sum + part;
      double tail = sumTail(sum, part, next);
      if (tail != 0) {
        parts[kept++] = tail;
      }
      sum = next;
    }
    if (sum != 0) {
      parts[kept++] = sum;
    }
    count = kept;
    isExact = count <= MOST_PARTS;
    return this;
  }

  /** Adds a number, times a power of two of either sign. */
  public Expansion add(double factor, Expansion a) {
    isExact &= a.isExact;
    for (int i = 0; i < a.count && isExact; i++) {
      add(factor * a.parts[i]);
    }
    return this;
  }

  /** Adds a product, times a power of two of either sign. */
  public Expansion add(double factor, Expansion a, Expansion b) {
    isExact &= a.isExact && b.isExact;
    for (int i = 0; i < a.count && isExact; i++) {
      for (int j = 0; j < b.count && isExact; j++) {
        double x = factor * a.parts[i];
        double product = x * b.parts[j];
        isExact &= Math.abs(product) > LEAST_PRODUCT;
        add(productTail(x, b.parts[j], product));
        add(product);
      }
    }
    return this;
  }

  /** Whether nothing has underflowed or overflowed, and the parts are few enough. */
  public boolean isExact() {
    return isExact && Math.abs(head()) < Double.POSITIVE_INFINITY;
  }

  public int sign() {
    return count == 0 ? 0 : parts[count - 1] > 0 ? 1 : -1;
  }

  /**
   * The sum of the parts, from the least. Each is at most a quarter of the next, so that the
   * roundings add up to less than 4 u of it.
   */
  private double head() {
    double sum = 0;
    for (int i = 0; i < count; i++) {
      sum += parts[i];
    }
    return sum;
  }

  /** The value within 64 u^2 of itself: its head and that of the rest, each within 8 u. */
  BoundedNumber value() {
    double head = head();
    Expansion rest = new Expansion();
    rest.parts = Arrays.copyOf(parts, count + 1);
    rest.count = count;
    return BoundedNumber.of(head, rest.add(-head).head());
  }
}
