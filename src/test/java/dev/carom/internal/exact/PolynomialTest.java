// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class PolynomialTest {

  private static Polynomial of(double... coefficients) {
    return Polynomial.of(Arrays.stream(coefficients).mapToObj(Dyadic::of).toArray(Dyadic[]::new));
  }

  @Test
  void aCommonRootIsFoundWhateverThePrime() {
    Polynomial root = of(1, Residues.PRIME); // a constant modulo the prime
    assertThat(root.times(of(-1, 1)).gcd(root.times(of(-2, 1))).degree()).isOne();
    assertThat(of(-1, 1).times(of(-2, 1)).gcd(of(-1, 1).times(of(3, 1))).degree()).isOne();
    assertThat(of(0.75, -1).times(of(-2, 1)).gcd(of(0.75, -1)).degree()).isOne();
  }

  @Test
  void polynomialsThatAreAlikeModuloThePrimeHaveNoCommonRoot() {
    assertThat(of(-1, 1).gcd(of(-1 - Residues.PRIME, 1)).degree()).isZero();
    assertThat(of(1, 1).gcd(of(Residues.PRIME)).degree()).isZero();
  }

  @Test
  void aPolynomialWithoutMultipleRootsIsRecognisedQuickly() {
    Random random = new Random(1);
    Polynomial f = of(random.doubles(9).toArray());
    f = f.times(of(random.doubles(2).toArray()));
    ExactBudget work = ExactBudget.ofThread();
    long before = work.bits();
    assertThat(f.squareFree()).isSameAs(f);
    assertThat(work.impactsSince(before)).isLessThan(30); // 465 by the remainders
  }
}
