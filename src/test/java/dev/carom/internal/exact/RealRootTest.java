// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RealRootTest {

  private static Polynomial polynomial(double... c) {
    return Polynomial.of(Arrays.stream(c).mapToObj(Dyadic::of).toArray(Dyadic[]::new));
  }

  /** The square root of 2. */
  private static RealRoot root2() {
    return polynomial(-2, 0, 1).positiveRoots(null).get(0);
  }

  /** The same one, among others. */
  private static RealRoot root2OfAnother() {
    return polynomial(-2, 0, 1).times(polynomial(-5, 1)).positiveRoots(null).get(0);
  }

  @Test
  void isComparedWithNumbers() {
    double below = Math.sqrt(2);
    assertThat(root2().compare(Dyadic.of(below)))
        .isEqualTo(
            new java.math.BigDecimal(below).pow(2).compareTo(java.math.BigDecimal.valueOf(2)) < 0
                ? 1
                : -1);
    assertThat(root2().compare(Dyadic.of(1))).isPositive();
    assertThat(root2().compare(Dyadic.of(1.5))).isNegative();
    assertThat(polynomial(-3, 1).positiveRoots(null).get(0).compare(Dyadic.of(3))).isZero();
  }

  /** The least root of a gap, 3 - sqrt(2); that of a line; and 0 where contact is at the start. */
  @Test
  void isTheTimeOfAStraightFlight() {
    RealRoot root = RealRoot.ofStraight(polynomial(7, -6, 1));
    assertThat(root.nearest()).isEqualTo(3 - Math.sqrt(2), within(1e-15));
    assertThat(RealRoot.ofStraight(polynomial(3, -4)).compare(Dyadic.of(0.75))).isZero();
    assertThat(RealRoot.ofStraight(polynomial(0, -6, 1)).compare(Dyadic.ZERO)).isZero();
    assertThat(RealRoot.ofStraight(polynomial(-1, -6, 1)).compare(Dyadic.ZERO)).isZero();
  }

  @Test
  void mayBeLaterThanAnEnd() {
    double near = Math.sqrt(2);
    double end = root2().compare(Dyadic.of(near)) > 0 ? near : Math.nextDown(near);
    assertThat(root2().upTo(end)).isInfinite();
    assertThat(root2().upTo(Math.nextUp(end))).isEqualTo(near);
    assertThat(root2().upTo(Double.POSITIVE_INFINITY)).isEqualTo(near);
  }

  @Test
  void isComparedWithOtherRoots() {
    assertThat(root2().compare(root2OfAnother())).isZero();
    RealRoot near = polynomial(-2, 0, Math.nextUp(1.0)).positiveRoots(null).get(0);
    assertThat(root2().compare(near)).isPositive();
    assertThat(near.compare(root2())).isNegative();
    RealRoot three = RealRoot.at(Dyadic.of(3));
    assertThat(root2().compare(three)).isNegative();
    assertThat(three.compare(root2())).isPositive();
  }

  @Test
  void knowsTheSignOfAnotherPolynomial() {
    assertThat(root2().sign(polynomial(-2, 0, 1).times(polynomial(7, 3)))).isZero();
    assertThat(root2().sign(polynomial(-1.4142135623730951, 1)))
        .isEqualTo(root2().compare(Dyadic.of(1.4142135623730951)));
    assertThat(root2().sign(polynomial(-2, 0, Math.nextUp(1.0)))).isPositive();
    assertThat(root2().sign(polynomial(-2, 0, Math.nextDown(1.0)))).isNegative();
    assertThat(root2().sign(polynomial())).isZero();
    assertThat(root2().sign(polynomial(-4))).isNegative();
  }

  @Test
  void aTieRoundsToTheEvenDouble() {
    double one = 1;
    double next = Math.nextUp(one);
    double third = Math.nextUp(next);
    // (t - (a + b) / 2), times 2
    assertThat(middle(one, next).nearest()).isEqualTo(one);
    assertThat(middle(next, third).nearest()).isEqualTo(third);
  }

  private static RealRoot middle(double a, double b) {
    Dyadic sum = Dyadic.of(a).plus(Dyadic.of(b));
    return Polynomial.of(sum.negate(), Dyadic.of(2)).positiveRoots(null).get(0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.MIN_VALUE, 0x1p-1022, 0.1, 1, 3e200, Double.MAX_VALUE})
  void aDoubleIsItsOwnNearestOne(double x) {
    assertThat(polynomial(-x, 1).positiveRoots(null).get(0).nearest()).isEqualTo(x);
  }

  @Test
  void beyondTheRangeOfDoublesItIsInfiniteOrZero() {
    Dyadic most = Dyadic.of(Double.MAX_VALUE);
    Dyadic least = Dyadic.of(Double.MIN_VALUE);
    assertThat(first(most.times(most)).nearest()).isInfinite();
    assertThat(first(least.times(least)).nearest()).isZero();
  }

  private static RealRoot first(Dyadic root) {
    return Polynomial.of(root.negate(), Dyadic.of(1)).positiveRoots(null).get(0);
  }

  @Test
  void betweenTwoRootsIsANumber() {
    RealRoot near = polynomial(-2, 0, Math.nextUp(1.0)).positiveRoots(null).get(0);
    Dyadic between = near.between(root2());
    assertThat(near.compare(between)).isNegative();
    assertThat(root2().compare(between)).isPositive();
    assertThat(root2().compare(root2().after())).isNegative();
    assertThat(root2().compare(RealRoot.at(Dyadic.ZERO).between(root2()))).isPositive();
  }

  /** (t - 1.4142, 1e-20) at the square root of 2: most digits cancel. */
  @Test
  void aUnitVectorIsRightAlsoWhereDigitsCancel() {
    UnitVector unit = root2().unit(polynomial(-2, 0, 1 + 0x1p-50), polynomial(0, 0x1p-50));
    // x = 2^-49, y = 2^-50 sqrt(2)
    assertThat(unit.x()).isCloseTo(Math.sqrt(2 / 3.0), within(1e-15));
    assertThat(unit.y()).isCloseTo(Math.sqrt(1 / 3.0), within(1e-15));
  }
}
