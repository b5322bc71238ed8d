// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class GasTableTest {

  private static GasTable table(double gain) {
    Sample sample = new Sample();
    sample.add("gas", "carom", "", "gas_energy", "max", 1e-15, "1", -1);
    sample.add("gas", "carom", "", "gas_overlap", "max", 0, "radii", -1);
    sample.add("gas", "dyn4j", "setting=tuned", "gas_energy", "max", gain, "1", -1);
    return new GasTable(sample.results());
  }

  @Test
  void anEngineThatGainsEnergyIsExplained() {
    assertThat(table(10.5).note()).startsWith("dyn4j gains energy where a circle has two contacts");
    assertThat(table(10.5).table().text()).contains("1,050 %");
    assertThat(table(0.01).note()).isEmpty();
  }
}
