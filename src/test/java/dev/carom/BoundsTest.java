// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class BoundsTest {

  @Test
  void refusesNaN() {
    double bad = Double.NaN;
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Bounds(bad, 0, 1, 1))
        .withMessage("xmin is " + bad + ": expected a number, or infinity for an open side");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Bounds(0, bad, 1, 1))
        .withMessage("ymin is " + bad + ": expected a number, or infinity for an open side");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Bounds(0, 0, bad, 1))
        .withMessage("xmax is " + bad + ": expected a number, or infinity for an open side");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Bounds(0, 0, 1, bad))
        .withMessage("ymax is " + bad + ": expected a number, or infinity for an open side");
  }

  @Test
  void refusesARectangleWithoutInside() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Bounds(2, 0, 2, 1))
        .withMessage("xmax is 2.0: expected more than xmin, 2.0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Bounds(0, 2, 1, -2))
        .withMessage("ymax is -2.0: expected more than ymin, 2.0");
    assertThatIllegalArgumentException().isThrownBy(() -> new Bounds(-0.0, 0, 0.0, 1));
    assertThatIllegalArgumentException().isThrownBy(() -> new Bounds(0, -0.0, 1, 0.0));
  }

  @Test
  void aSideAtInfinityIsOpen() {
    double inf = Double.POSITIVE_INFINITY;
    assertThat(new Bounds(-inf, 0, inf, inf).ymin()).isZero();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Bounds(inf, 0, inf, 1))
        .withMessage("xmax is Infinity: expected more than xmin, Infinity");
  }

  @Test
  void takesTheLeastAndTheGreatestRectangle() {
    double max = Double.MAX_VALUE;
    assertThat(new Bounds(0, 0, Double.MIN_VALUE, Double.MIN_VALUE).xmax()).isPositive();
    assertThat(new Bounds(-max, -max, max, max).ymin()).isEqualTo(-max);
  }
}
