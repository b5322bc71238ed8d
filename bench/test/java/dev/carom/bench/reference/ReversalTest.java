// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Scene;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class ReversalTest {

  /** Each digit more that is carried is a digit more to which the start is reached again. */
  @Test
  void exactMotionReturnsAndDoublesDoNot() throws IOException {
    Reversal reversal = Reversal.of(References.scene("base-1"), 200, () -> {});
    System.out.println("base-1, 200 frames and back: " + reversal);
    assertThat(reversal.digits()).isGreaterThan(12);
    assertThat(reversal.digitsOfMore())
        .isGreaterThan(reversal.digits() + Reversal.MORE_BITS * Math.log10(2) - 1);
    assertThat(reversal.circles()).isEqualTo(100);
    assertThat(reversal.returned()).isBetween(1, 90);
  }

  /** Flat walls multiply no error, so doubles return too. */
  @Test
  void doublesReturnInABox() {
    Scene scene = Scene.builder().bounds(0, 0, 10, 10).circle(1.3, 4.1, 0.7, 3.7, -2.3).build();
    Reversal reversal = Reversal.of(scene, 50, () -> {});
    assertThat(reversal.returned()).isEqualTo(1);
    assertThat(reversal.digits()).isGreaterThan(12);
  }

  @Test
  void refusesCirclesThatCollide() {
    Scene scene = Scene.builder().circle(0, 0, 1, 1, 0).collide(true).build();
    assertThatThrownBy(() -> Reversal.of(scene, 1, () -> {}))
        .hasMessage("circles collide: expected ones that ignore each other");
  }
}
