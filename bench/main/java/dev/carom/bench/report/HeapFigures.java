// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.series.Heaps;

/** What heaps of circles cost, and balls among pegs, as a table. */
public final class HeapFigures {

  private final Results results;

  /**
   * Takes what is shown.
   *
   * @param results what was measured
   */
  public HeapFigures(Results results) {
    this.results = results;
  }

  /** The numbers: a row for each scene. */
  public ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "a scene of",
            "a simulated second",
            "impacts in it",
            "median frame",
            "worst frame",
            "at rest at the end");
    for (String scene : results.scenes(Heaps.SECOND)) {
      table.row(
          words(scene),
          ReportNumbers.time(value(scene, Heaps.SECOND, "mean")),
          ReportNumbers.count(value(scene, Heaps.IMPACTS, "mean")),
          ReportNumbers.time(value(scene, Heaps.FRAME, "median")),
          ReportNumbers.time(value(scene, Heaps.FRAME, "max")),
          Math.round(100 * value(scene, Heaps.RESTING, "end")) + " %");
    }
    return table.build();
  }

  private static String words(String scene) {
    return scene.equals(Heaps.PLINKO)
        ? "50 balls that fall among 203 pegs"
        : "a heap of "
            + ReportNumbers.count(Double.parseDouble(scene.substring(Heaps.HEAP.length())));
  }

  private double value(String scene, String metric, String stat) {
    return results.value(scene, Metrics.CAROM, metric, stat);
  }
}
