// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** The search for the first root in plain doubles: what it tells, and what it leaves open. */
class GapRootTest {

  /** The size m0 of coefficients of order 1. */
  private static final double SIZE = 8;

  private static double first(double c0, double c1, double c2, double c3, double c4, double T) {
    return GapRoot.first(c0, c1, c2, c3, c4, SIZE, SIZE, SIZE, 0, T);
  }

  @Test
  void findsTheFirstOfSeveralRoots() {
    // (t - 1) (t - 2) (t - 3) (t - 4)
    assertThat(first(24, -50, 35, -10, 1, 9)).isCloseTo(1, within(1e-12));
    // (t - 2) (t + 1) (t^2 + 1), with the other sign before
    assertThat(first(2, 1, 1, 1, -1, 9)).isCloseTo(2, within(1e-12));
  }

  @Test
  void findsTheNextRootAfterAStart() {
    double t = GapRoot.first(24, -50, 35, -10, 1, SIZE, SIZE, SIZE, 2.5, 9);
    assertThat(t).isCloseTo(3, within(1e-12));
    assertThat(GapRoot.first(24, -50, 35, -10, 1, SIZE, SIZE, SIZE, 5, 9)).isEqualTo(GapRoot.NEVER);
  }

  @Test
  void aPolynomialWithoutARootInTheWindowNeverFalls() {
    assertThat(first(1, 1, 1, 1, 1, 100)).isEqualTo(GapRoot.NEVER);
    assertThat(first(24, -50, 35, -10, 1, 0.9)).isEqualTo(GapRoot.NEVER);
    assertThat(first(2, -2, 1, 0, 0, 9)).isEqualTo(GapRoot.NEVER);
  }

  @Test
  void aGrazeAndItsNeighboursAreLeftOpen() {
    // (t - 1)^2, and 1e-18 off
    assertThat(first(1, -2, 1, 0, 0, 9)).isNaN();
    assertThat(first(1 + 0x1p-52, -2, 1, 0, 0, 9)).isNaN();
    assertThat(first(1 - 0x1p-52, -2, 1, 0, 0, 9)).isNaN();
    assertThat(first(1 + 0x1p-30, -2, 1, 0, 0, 9)).isEqualTo(GapRoot.NEVER);
    assertThat(first(1 - 0x1p-30, -2, 1, 0, 0, 9)).isCloseTo(1 - 0x1p-15, within(1e-9));
  }

  @Test
  void aRootAtTheEndOfTheWindowIsLeftOpen() {
    assertThat(first(1, -1, 0, 0, 0, 1)).isNaN();
    assertThat(first(1, -1, 0, 0, 0, 1 - 0x1p-30)).isEqualTo(GapRoot.NEVER);
    assertThat(first(1, -1, 0, 0, 0, 1 + 0x1p-30)).isNaN();
    assertThat(first(1, -1, 0, 0, 0, 1 + 0x1p-10)).isEqualTo(1);
  }

  @Test
  void numbersBeyondTheRangeOfTheBoundsAreLeftOpen() {
    assertThat(first(1, -1, 0, 0, 0, 0x1p151)).isNaN();
    assertThat(first(1, Double.NaN, 0, 0, 0, 1)).isNaN();
    assertThat(first(1, 1, 1, 1, Double.POSITIVE_INFINITY, 1)).isNaN();
  }

  private static double leaves(double c0, double c1, double c2, double T) {
    return GapRoot.leaves(c0, c1, c2, 0, 0, SIZE, SIZE, SIZE, T);
  }

  @Test
  void leavesTellsATimeAboveZero() {
    // -1 + 4 t - t^2 rises until 2.
    double t = leaves(-1, 4, -1, 9);
    assertThat(t).isBetween(0.3, 2.0);
    assertThat(-1 + 4 * t - t * t).isPositive();
    assertThat(leaves(0, 1, 0, 9)).isEqualTo(9);
  }

  @Test
  void leavesTellsThatTheWindowEndsBefore() {
    assertThat(leaves(-5, 1, 0, 4)).isEqualTo(GapRoot.NEVER);
    assertThat(leaves(0, 1, 0, 0)).isEqualTo(GapRoot.NEVER);
  }

  @Test
  void leavesTellsNothingOfWhatTurnsBackOrDoesNotRise() {
    assertThat(leaves(-1, 1, -1, 9)).isNaN();
    assertThat(leaves(-1, 0, 1, 9)).isNaN();
    assertThat(leaves(-1, -1, 1, 9)).isNaN();
  }

  @Test
  void theReachEndsTheWindow() {
    // t^2 > 2 t + 3 from 3 on
    assertThat(GapRoot.reach(3, 2, 1, 9)).isBetween(3.0, 3.01);
    assertThat(GapRoot.reach(3, 2, 1, 2)).isEqualTo(2);
    assertThat(GapRoot.reach(3, 2, 0, 9)).isEqualTo(9);
    assertThat(GapRoot.reach(3, 2, -1, 9)).isEqualTo(9);
    assertThat(GapRoot.reach(0, 0, 0, 9)).isEqualTo(9);
  }

  @Test
  void theNearestDoubleIsToldOnlyIfTheSignsAtBothMiddlesAreCertain() {
    // f = 1 - t
    assertThat(GapRoot.nearest(1 + 0x1p-50, -0x1p-50, -1, 1)).isEqualTo(1);
    assertThat(GapRoot.nearest(1, -0x1p-54, -1, 1)).isNaN(); // at a middle
    assertThat(GapRoot.nearest(1, -0x1.1p-54, -1, 1)).isEqualTo(1 - 0x1p-53);
    assertThat(GapRoot.nearest(1 + 0x1p-20, -0x1p-20, -1, 1)).isNaN(); // too far away
    assertThat(GapRoot.nearest(1, 0, 1, 1)).isNaN(); // rises
    assertThat(GapRoot.nearest(1, 0, -1, 0x1p151)).isNaN();
  }
}
