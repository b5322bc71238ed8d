// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.Falls;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The order of exact times of impact, beside that of the oracle, which compares their digits. */
class TimeOrderTest {

  private static final int QUERIES = 25;

  private static RealRoot time(long p, long q, long d) {
    return RealRoot.ofStraight(
        Polynomial.of(
            Dyadic.of((double) (p * p - q)), Dyadic.of(-2.0 * p * d), Dyadic.of((double) (d * d))));
  }

  /** (p - sqrt(q)) / d, twice, and the sign of their difference. */
  @ParameterizedTest
  @CsvSource({
    "2, 0, 1, 4, 0, 2, 0",
    "5, 9, 1, 2, 0, 1, 0",
    "3, 0, 1, 2, 0, 1, 1",
    "3, 2, 1, 3, 3, 1, 1",
    "3, 2, 1, 6, 8, 2, 0",
    "4, 2, 1, 3, 2, 1, 1",
    "4, 2, 1, 3, 3, 1, 1",
    "4, 3, 1, 3, 1, 1, 1",
    "5, 9, 1, 3, 1, 1, 0",
    "5, 8, 1, 3, 1, 1, 1",
    "5, 10, 1, 3, 1, 1, -1",
    "5, 9, 1, 3, 2, 1, 1",
    "7, 18, 1, 5, 5, 1, -1",
    "7, 18, 1, 5, 6, 1, 1",
    "3, 1, 2, 5, 9, 2, 0",
    "30, 18, 3, 20, 8, 2, 0",
    "30, 18, 3, 40, 0, 4, -1"
  })
  void signs(long p, long q, long d, long p2, long q2, long d2, int sign) {
    assertThat(time(p, q, d).order(time(p2, q2, d2))).isEqualTo(sign);
    assertThat(time(p2, q2, d2).order(time(p, q, d))).isEqualTo(-sign);
    assertThat(time(p, q, d).order(time(p, q, d))).isZero();
  }

  @Test
  void doublesAreTimesToo() {
    assertThat(RealRoot.at(Dyadic.ZERO).order(RealRoot.at(Dyadic.ZERO))).isZero();
    assertThat(RealRoot.at(Dyadic.ZERO).order(RealRoot.at(Dyadic.of(Double.MIN_VALUE))))
        .isEqualTo(-1);
    assertThat(RealRoot.at(Dyadic.of(1.5)).order(time(3, 0, 2))).isZero();
  }

  static Stream<Family<Query>> families() {
    return Families.all().stream().filter(family -> !family.name().startsWith("wall"));
  }

  /** Times of a query and of others nearly like it; one that is larger by a power of two ties. */
  @ParameterizedTest
  @MethodSource("families")
  void ordersTimesAsTheOracleDoes(Family<Query> family) {
    Draw draw = new Draw(family.name().hashCode());
    Random random = new Random(family.name().hashCode());
    for (int i = 0; i < QUERIES; i++) {
      Query query = family.next(draw);
      List<Query> alike = new ArrayList<>(List.of(query, family.next(draw)));
      alike.add(scaled(query, 2));
      alike.add(scaled(query, 3));
      for (int k = 0; k < 3; k++) {
        alike.add(nudged(query, random));
      }
      alike.removeIf(each -> !each.truth().hit());
      for (Query other : alike) {
        int order = alike.get(0).truth().moment().compareTo(other.truth().moment());
        RealRoot time = exactTime(alike.get(0));
        assertThat(time.order(exactTime(other))).as("%s%n%s", query, other).isEqualTo(order);
        assertThat(exactTime(other).order(time)).as("%s%n%s", other, query).isEqualTo(-order);
      }
    }
  }

  /** Lengths, speeds included, times a factor; no longer exactly, if it is not a power of two. */
  private static Query scaled(Query query, double factor) {
    double[] n = query.numbers();
    for (int i = 0; i < n.length - 1; i++) {
      n[i] *= factor;
    }
    return isFinite(n) ? forEver(query, n) : query;
  }

  private static Query nudged(Query query, Random random) {
    double[] n = query.numbers();
    int i = random.nextInt(n.length - 1);
    n[i] = Math.abs(n[i]) < Double.MAX_VALUE ? Math.nextUp(n[i]) : n[i];
    return forEver(query, n);
  }

  private static Query forEver(Query query, double... n) {
    n[n.length - 1] = Double.POSITIVE_INFINITY;
    return query.with(n);
  }

  private static boolean isFinite(double... n) {
    for (int i = 0; i < n.length - 1; i++) {
      if (!(Math.abs(n[i]) <= Double.MAX_VALUE)) {
        return false;
      }
    }
    return true;
  }

  private static RealRoot exactTime(Query query) {
    Fall fall;
    if (query instanceof SegmentQuery q) {
      fall =
          Falls.line(
              q.px(), q.py(), q.r(), q.vx(), q.vy(), 0, 0, q.ax(), q.ay(), q.bx(), q.by(), 0, 0);
    } else {
      PairQuery q = (PairQuery) query;
      fall =
          Falls.disk(
              q.x1(), q.y1(), q.r1(), q.vx1(), q.vy1(), 0, 0, q.x2(), q.y2(), q.r2(), q.vx2(),
              q.vy2());
    }
    return FallSweep.exactTime(fall, FallSweep.straightContact(fall));
  }
}
