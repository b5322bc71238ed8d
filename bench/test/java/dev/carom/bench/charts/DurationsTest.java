// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DurationsTest {

  @ParameterizedTest
  @CsvSource({
    "612.4,3,612 ns",
    "999.6,3,1 µs",
    "1270,2,1.3 µs",
    "16666666,4,16.67 ms",
    "2e9,3,2 s"
  })
  void durationsTakeTheUnitWithFewestDigits(double nanos, int digits, String text) {
    assertThat(Durations.text(nanos, digits)).isEqualTo(text);
  }

  @Test
  void thousandsAreSetApart() {
    assertThat(Durations.number(26_871, 2)).isEqualTo("27,000");
    assertThat(Durations.number(1_234_567.25, 9)).isEqualTo("1,234,567.25");
    assertThat(Durations.number(999, 3)).isEqualTo("999");
  }

  @Test
  void labelsAreMovedApart() {
    assertThat(LineLabels.spread(new double[] {50, 52, 300}, 38, 20, 280))
        .containsExactly(50, 88, 280);
    assertThat(LineLabels.spread(new double[] {270, 275}, 38, 20, 280)).containsExactly(242, 280);
  }
}
