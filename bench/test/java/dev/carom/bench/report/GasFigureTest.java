// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class GasFigureTest {

  private static Figure figure(double gain) {
    Sample sample = new Sample();
    sample.add("gas", "carom", "", "gas_energy", "max", 1e-15, "1", -1);
    sample.add("gas", "carom", "", "gas_overlap", "max", 0, "radii", -1);
    sample.add("gas", "dyn4j", "setting=tuned", "gas_energy", "max", gain, "1", -1);
    return GasFigure.of(sample.results()).get(0);
  }

  @Test
  void anEngineThatGainsEnergyIsExplained() {
    assertThat(figure(10.5).note()).contains("dyn4j gains energy where a circle has two contacts");
    assertThat(figure(10.5).table().text()).contains("1,050 %");
    assertThat(figure(0.01).note()).doesNotContain("dyn4j");
  }

  @Test
  void theTitleTellsEnergyAndOverlap() {
    assertThat(figure(1).title())
        .isEqualTo(
            "Colliding circles: Carom keeps energy to 1.0e-13 % and overlaps by 0 radii; faster: none");
  }
}
