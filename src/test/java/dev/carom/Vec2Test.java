// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class Vec2Test {

  @Test
  void keepsItsComponentsToTheBit() {
    Vec2 v = new Vec2(-0.0, Double.MIN_VALUE);
    assertThat(Double.doubleToRawLongBits(v.x())).isEqualTo(Double.doubleToRawLongBits(-0.0));
    assertThat(v.y()).isEqualTo(Double.MIN_VALUE);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesWhatIsNotFinite(double bad) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Vec2(bad, 0))
        .withMessage("x is " + bad + ": expected a finite number");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Vec2(0, bad))
        .withMessage("y is " + bad + ": expected a finite number");
  }

  @Test
  void lengthOfPythagoreanTriples() {
    assertThat(new Vec2(3, -4).length()).isEqualTo(5);
    assertThat(new Vec2(-20, 21).length()).isEqualTo(29);
    assertThat(Vec2.ZERO.length()).isZero();
  }

  @Test
  void lengthNeitherOverflowsNorUnderflowsOnTheWay() {
    assertThat(new Vec2(0x3p1000, 0x4p1000).length()).isEqualTo(0x5p1000);
    assertThat(new Vec2(0x3p-1070, 0x4p-1070).length()).isEqualTo(0x5p-1070);
    assertThat(new Vec2(Double.MAX_VALUE, Double.MAX_VALUE).length())
        .isEqualTo(Double.POSITIVE_INFINITY);
  }

  @Test
  void lengthIsThatOfTheMirroredVector() {
    double length = new Vec2(1.1, 2.3).length();
    assertThat(new Vec2(-1.1, 2.3).length()).isEqualTo(length);
    assertThat(new Vec2(2.3, -1.1).length()).isEqualTo(length);
    assertThat(length).isCloseTo(Math.sqrt(6.5), within(Math.ulp(length)));
  }
}
