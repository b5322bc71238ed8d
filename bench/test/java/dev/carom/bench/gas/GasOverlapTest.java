// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.gas;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import org.junit.jupiter.api.Test;

class GasOverlapTest {

  /** A pair drawn into each other, one that touches, and one apart. */
  @Test
  void tellsTheDeepestOverlap() {
    SceneBuilder builder = Scene.builder();
    builder.circle(0, 0, 2, 0, 0).circle(2.5, 0, 1, 0, 0);
    builder.circle(0, 10, 1, 0, 0).circle(2, 10, 1, 0, 0);
    assertThat(GasOverlap.deepest(builder.build(), 2, 0.5)).isEqualTo(0.5);
    Scene touching =
        Scene.builder().collide(false).circle(0, 0, 1, 0, 0).circle(2, 0, 1, 0, 0).build();
    assertThat(GasOverlap.deepest(touching, 1, 1)).isZero();
  }
}
