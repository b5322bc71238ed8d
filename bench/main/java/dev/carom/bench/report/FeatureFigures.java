// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BarChart;
import dev.carom.bench.charts.BarChart.Bar;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.Style;
import dev.carom.bench.results.Results;
import dev.carom.bench.series.Features;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The cost of each thing that a scene uses, in the time of a frame and in memory. */
public final class FeatureFigures {

  /** The scenes in words, in the order of the table. */
  private static final Map<String, String> USES = new LinkedHashMap<>();

  static {
    USES.put("circles", "100 circles, nothing to hit");
    USES.put("walls", "and four walls");
    USES.put("few-lines", "walls and 8 lines, no grid");
    USES.put("lines", "walls and 100 lines, in a grid");
    USES.put("sensors", "walls and 100 lines that only report");
    USES.put("masks", "100 lines in two layers, each circle in one");
    USES.put("recording", "100 lines, and the past is recorded");
    USES.put("uncertainty", "100 lines, and the errors are bounded");
    USES.put("steering", "100 lines, one velocity set a frame");
    USES.put("moving-line", "100 lines, one of them moved a frame");
    USES.put("collisions", "walls, and the circles collide");
    USES.put("many-lines", "1,000 circles among 10,100 lines");
    USES.put("moving-lines", "1,000 circles, 100 of 10,100 lines move");
    USES.put("gravity", "walls and 100 lines, with gravity");
    USES.put("tiles", "10,000 circles among 10,000 lines");
    USES.put("falling-tiles", "10,000 among 10,000, with gravity");
    USES.put("gas", "a gas of 1,000 that collide");
    USES.put("falling-gas", "a gas of 1,000, with gravity");
  }

  /** Those of 100 circles that differ most; the table has all. */
  private static final Set<String> DRAWN =
      Set.of("circles", "walls", "lines", "recording", "moving-line", "collisions", "gravity");

  private final Results results;

  /**
   * Takes what is shown.
   *
   * @param results what was measured
   */
  public FeatureFigures(Results results) {
    this.results = results;
  }

  /** The bars: one figure, or none if nothing was measured. */
  public List<Figure> figures() {
    List<Bar> bars = new ArrayList<>();
    USES.forEach(
        (use, words) -> {
          double time = value(Features.SCENE + use, Features.TIME, "median");
          if (DRAWN.contains(use) && !Double.isNaN(time)) {
            bars.add(new Bar(words, Style.BLUE, time, ReportNumbers.time(time)));
          }
        });
    return bars.isEmpty()
        ? List.of()
        : List.of(
            new Figure(
                "features",
                "No more than a scene needs",
                title(),
                "100 circles, by Carom: the mean of 600 frames, to which the making of the world adds its share. A scene pays only for what it uses.",
                title() + ".",
                List.of(new Panel("", new BarChart(title(), bars).picture())),
                table()));
  }

  private String title() {
    double least = value(Features.SCENE + "circles", Features.TIME, "median");
    double lines = value(Features.SCENE + "lines", Features.TIME, "median");
    return Double.isNaN(least) || Double.isNaN(lines)
        ? "What each thing that a scene uses costs"
        : "The mean frame takes %s where there is nothing to hit, %s among 100 lines"
            .formatted(ReportNumbers.time(least), ReportNumbers.time(lines));
  }

  private static String memory(double bytes) {
    return ReportNumbers.count(bytes / 1024) + " KiB";
  }

  /** The numbers: a row for each use. */
  public ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "a scene of", "mean frame", "impacts a frame", "an impact", "memory");
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
                Double.isNaN(bytes) ? "not measured" : memory(bytes));
          }
        });
    return table.build();
  }

  /** What an {@link dev.carom.Uncertainty} costs: a sentence. */
  public String uncertainty() {
    double without = value(Features.SCENE + "lines", Features.TIME, "median");
    double with = value(Features.SCENE + "uncertainty", Features.TIME, "median");
    return "To bound the errors of 100 circles among 100 lines takes %s of a frame."
        .formatted(ReportNumbers.ratio(with / without - 1));
  }

  private double value(String scene, String metric, String stat) {
    return results.value(scene, Metrics.CAROM, metric, stat);
  }
}
