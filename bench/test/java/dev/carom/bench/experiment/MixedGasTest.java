// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import dev.carom.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MixedGasTest {

  @ParameterizedTest
  @CsvSource({"1, 0.4, 1", "500, 0.2, 1000", "1000, 0.4, 10", "500, 0.01, 100"})
  void circlesCoverWhatWasAskedAndOverlapNothing(int n, double packing, double spread)
      throws CannotPlaceException {
    Scene scene = new MixedGas(n, packing, spread, true, 3).scene();

    GasTest.assertGas(scene, n, packing, spread * (1 + 1e-12), 0);
    for (int i = 0; i < n; i++) {
      assertThat(scene.mass(i)).isEqualTo(scene.circle(i).radius() * scene.circle(i).radius());
    }
  }

  @Test
  void allOctavesHaveAlikeMany() throws CannotPlaceException {
    int n = 10_000;
    Scene scene = new MixedGas(n, 0.1, 1024, false, 1).scene();
    for (double octave = 1; octave < 1024; octave *= 2) {
      int count = 0;
      for (int i = 0; i < n; i++) {
        double r = scene.circle(i).radius();
        count += r >= octave && r < 2 * octave ? 1 : 0;
      }
      // 5 standard deviations of a count of n / 10
      assertThat(count).isBetween(n / 10 - 150, n / 10 + 150);
    }
    assertThat(new MixedGas(50, 0.1, 9, false, 1).scene())
        .isEqualTo(new MixedGas(50, 0.1, 9, false, 1).scene())
        .isNotEqualTo(new MixedGas(50, 0.1, 9, false, 2).scene());
  }

  @Test
  void refusesWhatIsNoGas() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new MixedGas(0, 0.2, 1, false, 1))
        .withMessage("circles is 0: expected at least 1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new MixedGas(1, 0.5, 1, false, 1))
        .withMessage("packing is 0.5: expected more than 0 and at most 0.4");
    assertThatIllegalArgumentException().isThrownBy(() -> new MixedGas(1, 0.2, 0, false, 1));
  }
}
