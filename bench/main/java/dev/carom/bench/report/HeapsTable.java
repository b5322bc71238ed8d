// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.series.Heaps;

/** What heaps of circles cost, and balls among pegs. */
public final class HeapsTable {

  private HeapsTable() {}

  /**
   * The numbers: a row for each scene.
   *
   * @param results what was measured
   */
  public static ReportTable of(Results results) {
    return Column.table(
        results.scenes(Heaps.SECOND).stream()
            .map(scene -> new Standing(results, scene, Metrics.CAROM))
            .toList(),
        new Column("a scene of", s -> words(s.scene())),
        Column.of("a simulated second", Heaps.SECOND, "mean", ReportNumbers::time),
        Column.of("impacts in it", Heaps.IMPACTS, "mean", ReportNumbers::count),
        Column.of("median frame", Heaps.FRAME, "median", ReportNumbers::time),
        Column.of("worst frame", Heaps.FRAME, "max", ReportNumbers::time),
        Column.of(
            "at rest at the end", Heaps.RESTING, "end", rest -> Math.round(100 * rest) + " %"));
  }

  private static String words(String scene) {
    return scene.equals(Heaps.PLINKO)
        ? "50 balls that fall among 203 pegs"
        : "a heap of "
            + ReportNumbers.count(Double.parseDouble(scene.substring(Heaps.HEAP.length())));
  }
}
