// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class PolynomialTest {

  private static final Polynomial T_LESS_1 = polynomial(-1, 1);
  private static final Polynomial T_LESS_2 = polynomial(-2, 1);
  private static final Polynomial T_PLUS_3 = polynomial(3, 1);
  private static final Polynomial NO_ROOT = polynomial(1, 0, 1);

  static Polynomial polynomial(double... c) {
    return Polynomial.of(Arrays.stream(c).mapToObj(Dyadic::of).toArray(Dyadic[]::new));
  }

  private static List<Double> roots(Polynomial f) {
    return f.positiveRoots(null).stream().map(RealRoot::nearest).toList();
  }

  @Test
  void leadingZerosDoNotCount() {
    assertThat(polynomial(3, 2, 0, 0).degree()).isEqualTo(1);
    assertThat(polynomial(0, 0).isZero()).isTrue();
    assertThat(polynomial().degree()).isEqualTo(-1);
  }

  @Test
  void positiveRootsAreFoundInOrderAndOnce() {
    assertThat(roots(T_LESS_2.times(T_LESS_1))).containsExactly(1.0, 2.0);
    assertThat(roots(T_LESS_1.times(T_LESS_1).times(T_LESS_2))).containsExactly(1.0, 2.0);
    assertThat(roots(T_LESS_1.times(T_LESS_1).times(T_LESS_1).times(T_LESS_1)))
        .containsExactly(1.0);
    assertThat(roots(T_LESS_1.times(T_PLUS_3).times(NO_ROOT))).containsExactly(1.0);
    assertThat(roots(NO_ROOT)).isEmpty();
    assertThat(roots(polynomial())).isEmpty();
    assertThat(roots(polynomial(5))).isEmpty();
  }

  @Test
  void rootsAtZeroAreNotPositive() {
    assertThat(roots(polynomial(0, 0, -2, 1))).containsExactly(2.0);
    assertThat(roots(polynomial(0, 0, 0, 0, 7))).isEmpty();
  }

  @Test
  void onlyRootsBeforeTheLimitAreLookedFor() {
    Polynomial f = T_LESS_1.times(T_LESS_2);
    assertThat(f.positiveRoots(RealRoot.after(1.0)).stream().map(RealRoot::nearest))
        .containsExactly(1.0);
    assertThat(f.positiveRoots(RealRoot.after(0.0))).isEmpty();
  }

  /** A quartic from its roots, some of them within a few ulps of each other, of any magnitude. */
  @Test
  void rootsOfRandomQuarticsAreTheirs() {
    Random random = new Random(4);
    for (int i = 0; i < 200; i++) {
      double a = Math.scalb(1 + random.nextDouble(), random.nextInt(-300, 300));
      double b = Math.nextUp(a);
      double c = a * (1 + random.nextDouble());
      Polynomial f =
          polynomial(-a, 1).times(polynomial(-b, 1)).times(polynomial(-c, 1)).times(T_PLUS_3);
      assertThat(roots(f)).containsExactlyElementsOf(c == b ? List.of(a, b) : List.of(a, b, c));
    }
  }

  @Test
  void theCommonDivisorHasTheCommonRoots() {
    Polynomial f = T_LESS_1.times(T_LESS_1).times(T_PLUS_3);
    Polynomial g = T_LESS_1.times(T_LESS_2).times(NO_ROOT);
    assertThat(roots(f.gcd(g))).containsExactly(1.0);
    assertThat(f.gcd(g).degree()).isEqualTo(1);
    assertThat(T_LESS_2.gcd(T_PLUS_3).degree()).isZero();
    assertThat(f.gcd(polynomial()).degree()).isEqualTo(3);
  }

  @Test
  void theSquareFreePartHasEachRootOnce() {
    Polynomial f = T_LESS_1.times(T_LESS_1).times(T_LESS_2).times(T_LESS_2);
    assertThat(f.squareFree().degree()).isEqualTo(2);
    assertThat(roots(f.squareFree())).containsExactly(1.0, 2.0);
    assertThat(f.squareFree().derivative().degree()).isEqualTo(1);
  }

  @Test
  void oneSignThroughoutAnIntervalIsSeen() {
    Polynomial f = T_LESS_1.times(T_LESS_2);
    assertThat(f.signThroughout(Dyadic.of(3), Dyadic.of(4))).isPositive();
    assertThat(f.signThroughout(Dyadic.of(1.25), Dyadic.of(1.5))).isNegative();
    assertThat(f.signThroughout(Dyadic.of(0.5), Dyadic.of(1.5))).isZero();
    assertThat(f.signThroughout(Dyadic.of(1), Dyadic.of(1.5))).isZero();
  }
}
