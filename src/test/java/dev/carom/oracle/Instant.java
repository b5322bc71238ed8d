// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.math.BigDecimal;
import java.math.MathContext;

/** A rational time n / m, m > 0, of the second method. */
record Instant(Dyadic n, Dyadic m) implements Comparable<Instant> {
  static final Instant ZERO = new Instant(Dyadic.ZERO, Dyadic.ONE);

  /** n / m for any m that is not 0. */
  static Instant ratio(Dyadic n, Dyadic m) {
    return m.signum() > 0 ? new Instant(n, m) : new Instant(n.negate(), m.negate());
  }

  @Override
  public int compareTo(Instant other) {
    return n.times(other.m).compareTo(other.n.times(m));
  }

  /** A time strictly between two different ones: half way. */
  Instant between(Instant other) {
    return new Instant(n.times(other.m).plus(other.n.times(m)), m.times(other.m).shift(1));
  }

  BigDecimal digits(MathContext context) {
    return n.toBigDecimal(context).divide(m.toBigDecimal(context), context);
  }
}
