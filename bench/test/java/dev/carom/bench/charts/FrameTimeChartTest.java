// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FrameTimeChartTest {

  private static String svg(double budgetMillis, double... nanos) {
    byte[] svg = new FrameTimeChart(nanos, budgetMillis).picture().svg();
    return new String(svg, StandardCharsets.UTF_8);
  }

  @Test
  void saysWhetherTheBudgetWasKept() {
    assertThat(svg(20, 1, 2, 3)).contains("All 3 frames are within the budget of 20 ms<");
    assertThat(svg(20, 1, 2.1e7, 3e7)).contains("Above the budget of 20 ms: 2 of 3 frames<");
  }

  @Test
  void namesMedianWorstAndBudgetAtTheirLines() {
    assertThat(svg(1000.0 / 60, 600, 900, 700, 650))
        .contains(">median 675 ns<", ">1/25,000 of the budget<")
        .contains(">worst 900 ns<", ">of 4: frame 2<")
        .contains(">budget 16.67 ms<", ">60 frames a second<");
  }

  @Test
  void drawsEveryFrameEvenOneThatTookNoTime() {
    String mark = "<g style='fill:rgb.0,114,178.;";
    assertThat(svg(20, 1000, 2000, 3000).split(mark, -1)).hasSize(1 + 3);
    assertThat(svg(20, 0, 2000, 3000).split(mark, -1)).hasSize(1 + 3);
    assertThat(svg(20, 0, 0, 0))
        .contains("triangles: 3 too short", ">median 0 ns<", ">below the step of the clock<");
  }

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
