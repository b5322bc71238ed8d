// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.series.Features;
import java.util.LinkedHashMap;
import java.util.Map;

/** What each thing that a scene uses costs a frame, and in memory. */
public final class FeatureFigures {

  /** What the scenes use, in words, in the order in which it grows. */
  private static final Map<String, String> USES = new LinkedHashMap<>();

  static {
    USES.put("circles", "100 circles, nothing to hit");
    USES.put("walls", "and four walls");
    USES.put("few-lines", "walls and 8 lines, no grid");
    USES.put("lines", "walls and 100 lines, in a grid");
    USES.put("sensors", "walls and 100 lines that only report");
    USES.put("recording", "100 lines, and the past is recorded");
    USES.put("steering", "100 lines, one velocity set a frame");
    USES.put("moving-line", "100 lines, one of them moved a frame");
    USES.put("collisions", "walls, and the circles collide");
  }

  private final Results results;

  /**
   * Takes what is shown.
   *
   * @param results what was measured
   */
  public FeatureFigures(Results results) {
    this.results = results;
  }

  /**
   * The numbers.
   *
   * @return a row for each use
   */
  public ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder("a scene of", "a frame", "impacts a frame", "an impact", "memory");
    USES.forEach(
        (use, words) -> {
          String scene = Features.SCENE + use;
          if (results.scenes(Features.TIME).contains(scene)) {
            double time = value(scene, Features.TIME, "median");
            double impacts = value(scene, Features.IMPACTS, "mean");
            double bytes = value(scene, Features.MEMORY, "mean");
            table.row(
                words,
                ReportNumbers.time(time),
                ReportNumbers.ratio(impacts),
                impacts > 0 ? ReportNumbers.time(time / impacts) : "-",
                Double.isNaN(bytes) ? "not measured" : ReportNumbers.count(bytes / 1024) + " KiB");
          }
        });
    return table.build();
  }

  private double value(String scene, String metric, String stat) {
    return results.value(scene, Metrics.CAROM, metric, stat);
  }
}
