// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BarChart;
import dev.carom.bench.charts.BarChart.Bar;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import java.awt.Color;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/** Circles that fall into a heap, by Carom and by the engines: overlap, rest, energy, time. */
final class ContactFigures {

  private static final String SCENE = "heap";

  private final Results results;
  private final Marks marks;

  ContactFigures(Results results) {
    this.results = results;
    marks = Settings.marks(results);
  }

  /** One figure of two panels, or none if nothing was measured. */
  List<Figure> figures() {
    if (settings().isEmpty()) {
      return List.of();
    }
    List<Panel> panels =
        List.of(
            panel("Deepest overlap, in radii", this::overlap, ReportNumbers::error),
            panel(
                "Mean frame; faster than Carom: "
                    + told("none", this::isFaster, Metrics::shortName),
                this::time,
                ReportNumbers::time));
    String title =
        "In a heap, Carom's circles touch; those of the engines, each at its better setting, sink %s into each other"
            .formatted(engines());
    return List.of(
        new Figure(
            "heap",
            "A heap",
            title,
            "100 circles fall into a heap and come to rest. Each engine has its defaults, then is tuned for accuracy, which need not help in a heap. The mean frame is that of fall and rest together.",
            title + ".",
            panels,
            table()));
  }

  /** The least and the greatest overlap of others, each at the setting that overlaps less. */
  private String engines() {
    double[] overlaps =
        settings().stream()
            .filter(s -> !s.equals(Metrics.CAROM))
            .collect(Collectors.toMap(Setting::method, this::overlap, Math::min))
            .values()
            .stream()
            .mapToDouble(overlap -> overlap)
            .sorted()
            .toArray();
    if (overlaps.length == 0) {
      return "?";
    }
    String least = ReportNumbers.error(overlaps[0]);
    String most = ReportNumbers.error(overlaps[overlaps.length - 1]);
    return (least.equals(most) ? least : least + " to " + most) + " radii";
  }

  private List<Setting> settings() {
    return Settings.of(results, SCENE, Metrics.HEAP_OVERLAP);
  }

  private Panel panel(String title, ToDoubleFunction<Setting> value, DoubleFunction<String> text) {
    List<Bar> bars =
        settings().stream()
            .map(
                s -> {
                  double v = value.applyAsDouble(s);
                  Color color = marks.color(s.method());
                  return new Bar(Metrics.shortName(s), color, v, text.apply(v));
                })
            .toList();
    return new Panel(title, new BarChart(title, bars).picture());
  }

  private double overlap(Setting setting) {
    return results.value(SCENE, setting, Metrics.HEAP_OVERLAP, "max");
  }

  private double energy(Setting setting) {
    return results.value(SCENE, setting, Metrics.HEAP_ENERGY, "gained");
  }

  private double rest(Setting setting) {
    return results.value(SCENE, setting, Metrics.HEAP_REST, "frame");
  }

  private double time(Setting setting) {
    return results.value(SCENE, setting, Metrics.FRAME_TIME, "mean");
  }

  private static String percent(double share) {
    return ReportNumbers.error(100 * share) + " %";
  }

  private static String seconds(double frames) {
    return Double.isInfinite(frames) ? "not in 10 s" : ReportNumbers.ratio(frames / 60) + " s";
  }

  private boolean isFaster(Setting setting) {
    return spread(setting).isBelow(spread(Metrics.CAROM));
  }

  private Spread spread(Setting setting) {
    return results
        .spread(SCENE, setting, Metrics.FRAME_TIME, "mean")
        .orElse(Spread.of(0, Double.NaN));
  }

  private String told(String none, Predicate<Setting> who, Function<Setting, String> what) {
    return settings().stream()
        .filter(who)
        .map(what)
        .reduce((one, other) -> one + ", " + other)
        .orElse(none);
  }

  private ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "method",
            "deepest overlap, in radii",
            "overlap at the end",
            "energy from nowhere",
            "at rest after",
            "time of a frame, mean",
            "worst frame");
    for (Setting s : settings()) {
      table.row(
          Metrics.fullName(s),
          ReportNumbers.error(overlap(s)),
          ReportNumbers.error(results.value(SCENE, s, Metrics.HEAP_OVERLAP, "end")),
          percent(energy(s)),
          seconds(rest(s)),
          ReportNumbers.time(time(s)),
          ReportNumbers.time(results.value(SCENE, s, Metrics.FRAME_TIME, "worst")));
    }
    return table.build();
  }
}
