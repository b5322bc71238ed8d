// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ExactBudgetTest {

  /** The cost of some work, in ordinary impacts. */
  private static long impacts(Runnable work) {
    long before = ExactBudget.ofThread().bits();
    work.run();
    return ExactBudget.ofThread().impactsSince(before);
  }

  @Test
  void numbersCountByTheirBitsAndQuotientsByTheSquareOfThem() {
    int bits = ExactBudget.BITS_PER_IMPACT;
    int own = 1024; // what a number takes beside its bits
    assertThat(impacts(() -> ExactBudget.add(3 * bits - own))).isEqualTo(3);
    assertThat(impacts(() -> ExactBudget.add(3 * bits - own - 1))).as("whole ones").isEqualTo(2);
    assertThat(impacts(() -> ExactBudget.addRelaxations(bits))).isEqualTo(64);
    assertThat(impacts(() -> ExactBudget.addProduct(bits, 511))).isZero();
    assertThat(impacts(() -> ExactBudget.addProduct(bits, 3 * 512))).isEqualTo(3);
    assertThat(impacts(() -> ExactBudget.addSquared(4 * Long.SIZE))).isZero();
    assertThat(impacts(() -> ExactBudget.addSquared(bits))).isEqualTo(bits / Long.SIZE);
  }

  @Test
  void longRootsAndQuotientsAreWork() {
    int bits = ExactBudget.BITS_PER_IMPACT;
    Dyadic three = Dyadic.of(3);
    assertThat(impacts(() -> Dyadic.of(1).over(three, bits))).isGreaterThanOrEqualTo(32);
    assertThat(impacts(() -> three.sqrt(bits))).isGreaterThanOrEqualTo(4 * 32);
    Dyadic third = Dyadic.of(1).over(three, bits);
    assertThat(impacts(() -> third.sqrt(128))).as("a short root of a long number").isOne();
  }
}
