// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import dev.carom.bench.results.ResultsCsv;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FeaturesCommandTest {

  @Test
  void whatIsUsedCostsTimeAndMemory(@TempDir Path folder) throws IOException {
    Path csv = folder.resolve("features.csv");
    Cli run = Cli.run("features --rounds 1 --warm-up 0 --csv", csv);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .containsPattern("100 circles, nothing to hit +[0-9.]+ [num]?s +0 +- +\\d+ KiB")
        .containsPattern("walls, and the circles collide +[0-9.]+ [num]?s +[0-9.]+ ");
    List<Row> rows = ResultsCsv.read(csv);
    assertThat(value(rows, "circles", "feature_impacts")).isZero();
    // As many lines, in places as crowded. Measured: 16 % more, for a line that moves meets more.
    // That they move is tested by AmongMovingLinesTest.
    assertThat(value(rows, "moving-lines", "feature_impacts"))
        .isCloseTo(value(rows, "many-lines", "feature_impacts"), withinPercentage(25));
    assertThat(value(rows, "sensors", "feature_impacts")).isPositive();
    for (String[] pair :
        new String[][] {{"lines", "gravity"}, {"tiles", "falling-tiles"}, {"gas", "falling-gas"}}) {
      assertThat(value(rows, pair[1], "feature_impacts"))
          .as(pair[1])
          .isPositive()
          .isNotEqualTo(value(rows, pair[0], "feature_impacts"));
      assertThat(value(rows, pair[1], "feature_time")).as(pair[1]).isPositive();
    }
    assertThat(run.out()).containsPattern("10,000 among 10,000, with gravity +.* -");
    assertThat(value(rows, "lines", "feature_memory"))
        .isLessThan(value(rows, "recording", "feature_memory"))
        .isLessThan(value(rows, "uncertainty", "feature_memory"));
    assertThat(value(rows, "uncertainty", "feature_impacts"))
        .isEqualTo(value(rows, "lines", "feature_impacts"));
  }

  private static double value(List<Row> rows, String use, String metric) {
    return valueOf(rows, "feature:" + use, metric);
  }

  private static double valueOf(List<Row> rows, String scene, String metric) {
    return rows.stream()
        .filter(row -> row.scene().equals(scene) && row.metric().equals(metric))
        .mapToDouble(Row::value)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void aHeapComesToRestAndBallsAmongPegsFall(@TempDir Path folder) throws IOException {
    Path csv = folder.resolve("heaps.csv");
    Cli run = Cli.run("features --rounds 1 --warm-up 0 --heaps 29 --seed 2 --csv", csv);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .containsPattern("50 balls that fall among 203 pegs +[0-9.]+ [num]?s +[0-9,]+ +[0-9.]+ ")
        .containsPattern("a heap of 10 +[0-9.]+ [num]?s +[0-9,]+ .* [0-9]+ %")
        .doesNotContain("a heap of 30");
    List<Row> rows = ResultsCsv.read(csv);
    assertThat(valueOf(rows, "heap:10", "heap_impacts")).isPositive();
    assertThat(valueOf(rows, "heap:10", "heap_resting")).isBetween(0.5, 1.0); // 54 of 60 seeds
    assertThat(valueOf(rows, "plinko", "heap_impacts")).isPositive();
  }
}
