// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CircleTest {

  @Test
  void centerIsThePointItWasMadeOf() {
    Vec2 center = new Vec2(1, -2);
    assertThat(new Circle(center, 3)).isEqualTo(new Circle(1, -2, 3));
    assertThat(new Circle(center, 3).center()).isEqualTo(center);
  }

  @Test
  void radiusZeroIsAPointParticle() {
    assertThat(new Circle(1, 2, 0).radius()).isZero();
  }

  @ParameterizedTest
  @ValueSource(
      doubles = {
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        -1,
        -Double.MIN_VALUE
      })
  void refusesARadiusThatIsNone(double bad) {
    String message = "radius is " + bad + ": expected a finite number, at least 0";
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Circle(0, 0, bad))
        .withMessage(message);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Circle(Vec2.ZERO, bad))
        .withMessage(message);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesACentreThatIsNotFinite(double bad) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Circle(bad, 0, 1))
        .withMessage("x is " + bad + ": expected a finite number");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Circle(0, bad, 1))
        .withMessage("y is " + bad + ": expected a finite number");
  }
}
