// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ResultsTest {

  private static final Metadata METADATA =
      new Metadata("", 1, "", "", "", "", Map.of(), Map.of(), "", false);
  private static final Setting FOUR = new Setting("substeps", "k=4");

  private static Row row(String scene, String metric, String stat, double value, int fork) {
    return new Row(scene, "substeps", "k=4", metric, stat, value, "ns", 10, fork);
  }

  private static Results results(Row... rows) {
    return new Results(METADATA, List.of(rows));
  }

  @Test
  void aNumberIsTakenOverAllForks() {
    Results results =
        results(
            row("a", "time", "median", 30, 0),
            row("a", "time", "median", 10, 1),
            row("a", "time", "median", 20, 2),
            row("b", "time", "median", 99, 0));
    assertThat(results.spread("a", FOUR, "time", "median")).contains(new Spread(11, 20, 29, 3, 30));
    assertThat(results.spread("a", FOUR, "time", "p5")).isEmpty();
    assertThat(results.value("c", FOUR, "time", "median")).isNaN();
    assertThat(results.scenes("time")).containsExactly("a", "b");
    assertThat(results.settings("b", "time")).containsExactly(FOUR);
    assertThat(results.methods()).containsExactly("substeps");
  }

  @Test
  void aSeriesIsReadByFrame() {
    Results results =
        results(
            row("a", "drift", "median@10", 1, -1),
            row("a", "drift", "p5@10", 9, -1),
            row("a", "drift", "median@20", 2, -1));
    assertThat(results.series("a", FOUR, "drift", "median")).isEqualTo(Map.of(10, 1.0, 20, 2.0));
  }

  @Test
  void aFailureOfOneForkIsAFailure() {
    assertThat(Spread.of(2, 1, Double.NaN).failed()).isTrue();
    assertThat(Spread.of(2, 1, Double.NaN).isBelow(Spread.of(1, 9))).isFalse();
    assertThat(Spread.of(1, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY).middle())
        .isInfinite();
  }

  @Test
  void intervalsThatTouchAreNotToldApart() {
    assertThat(Spread.of(2, 1, 2).isBelow(Spread.of(2, 3, 4))).isTrue();
    assertThat(Spread.of(2, 1, 3).isBelow(Spread.of(2, 2, 4))).isFalse();
    assertThat(Spread.of(1, 2).isBelow(Spread.of(1, 2))).isFalse();
  }

  @Test
  void theValueOfAKnobStandsAfterItsName() {
    assertThat(FOUR.value()).isEqualTo("4");
    assertThat(FOUR).hasToString("substeps (k=4)");
    assertThat(new Setting("carom", "")).hasToString("carom");
    assertThat(new Setting("box2d", "defaults").value()).isEqualTo("defaults");
  }
}
