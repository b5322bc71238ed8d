// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * A point e + v t beside the segment from the origin to w, at rational times, for {@link
 * BisectionCheck}. With t = n / m the position times m is e m + v n, so all values are exact
 * fractions of dyadic numbers.
 */
record Approach(Vector e, Vector w, Vector v) {

  /** An exact fraction, the denominator positive. */
  record Fraction(Dyadic above, Dyadic below) {
    int compareTo(Fraction other) {
      return above.times(other.below).compareTo(other.above.times(below));
    }
  }

  /** The position times m. */
  Vector position(Instant t) {
    return e.times(t.m()).plus(v.times(t.n()));
  }

  /** The feature nearest to the point: where its projection falls. */
  Part nearest(Instant t) {
    Dyadic along = w.dot(position(t));
    if (along.signum() <= 0) {
      return Part.START;
    }
    return along.compareTo(w.squared().times(t.m())) >= 0 ? Part.END : Part.SIDE;
  }

  /** The square of the distance. */
  Fraction squaredDistance(Instant t) {
    Vector q = position(t);
    Dyadic mm = t.m().square();
    return switch (nearest(t)) {
      case START -> new Fraction(q.squared(), mm);
      case END -> new Fraction(q.minus(w.times(t.m())).squared(), mm);
      default -> new Fraction(w.cross(q).square(), w.squared().times(mm));
    };
  }

  /** A vector from the nearest point of the segment to the point, of any positive length. */
  Vector offset(Instant t) {
    Vector q = position(t);
    return switch (nearest(t)) {
      case START -> q;
      case END -> q.minus(w.times(t.m()));
      default -> q.times(w.squared()).minus(w.times(w.dot(q)));
    };
  }

  /** The first time t >= 0 of least distance. */
  Instant closest() {
    Vector f = e.minus(w);
    List<Instant> times = new ArrayList<>(List.of(Instant.ZERO));
    if (!v.isZero()) {
      times.add(Instant.ratio(e.dot(v).negate(), v.squared()));
      times.add(Instant.ratio(f.dot(v).negate(), v.squared()));
    }
    if (w.cross(v).signum() != 0) {
      times.add(Instant.ratio(w.cross(e).negate(), w.cross(v)));
    }
    Comparator<Instant> byDistance = (s, t) -> squaredDistance(s).compareTo(squaredDistance(t));
    return times.stream()
        .filter(t -> t.n().signum() >= 0)
        .min(byDistance.thenComparing(Comparator.naturalOrder()))
        .orElseThrow();
  }

  /** The times in 0..end, both excluded, at which the projection passes an end, in order. */
  List<Instant> passages(Instant end) {
    Dyadic speed = w.dot(v);
    if (speed.signum() == 0) {
      return List.of();
    }
    Dyadic toStart = w.dot(e).negate();
    return List.of(toStart, toStart.plus(w.squared())).stream()
        .map(n -> Instant.ratio(n, speed))
        .filter(t -> t.n().signum() > 0 && t.compareTo(end) < 0)
        .sorted()
        .toList();
  }
}
