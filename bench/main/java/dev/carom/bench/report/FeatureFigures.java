// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.series.Features;
import java.util.List;
import java.util.Map;

/** The cost of each thing that a scene uses, in the time of a frame and in memory. */
public final class FeatureFigures {

  /** The scenes in words, in the order of the table, and whether the chart has them, too. */
  private static final Map<String, List<String>> USES = Texts.table("features.txt");

  private final Results results;
  private final List<Standing> all;

  /**
   * Takes what is shown.
   *
   * @param results what was measured
   */
  public FeatureFigures(Results results) {
    this.results = results;
    all =
        USES.keySet().stream()
            .map(this::use)
            .filter(s -> results.scenes(Features.TIME).contains(s.scene()))
            .toList();
  }

  private Standing use(String use) {
    return new Standing(results, Features.SCENE + use, Metrics.CAROM);
  }

  private static String name(Standing s) {
    return s.scene().substring(Features.SCENE.length());
  }

  private static String words(Standing s) {
    return USES.get(name(s)).get(0);
  }

  private static double time(Standing s) {
    return s.value(Features.TIME, "median");
  }

  /** The bars: one figure, or none if nothing was measured. */
  public List<Figure> figures() {
    List<Standing> drawn =
        all.stream().filter(s -> USES.get(name(s)).get(1).contains("chart")).toList();
    if (drawn.isEmpty()) {
      return List.of();
    }
    String title =
        "The mean frame takes %s where there is nothing to hit, %s among 100 lines"
            .formatted(
                ReportNumbers.time(time(use("circles"))), ReportNumbers.time(time(use("lines"))));
    Panel bars =
        Figure.bars(
            title, drawn, FeatureFigures::words, Features.TIME, "median", ReportNumbers::time);
    return List.of(Figure.of("features", title, List.of(bars), table()));
  }

  /** The numbers: a row for each use. */
  public ReportTable table() {
    return Column.table(
        all,
        new Column("a scene of", FeatureFigures::words),
        Column.of("mean frame", Features.TIME, "median", ReportNumbers::time),
        Column.of("impacts a frame", Features.IMPACTS, "mean", ReportNumbers::ratio),
        new Column("an impact", FeatureFigures::impact),
        Column.of(
            "memory",
            Features.MEMORY,
            "mean",
            bytes -> ReportNumbers.count(bytes / 1024) + " KiB"));
  }

  private static String impact(Standing s) {
    double impacts = s.value(Features.IMPACTS, "mean");
    return impacts > 0 ? ReportNumbers.time(time(s) / impacts) : "-";
  }
}
