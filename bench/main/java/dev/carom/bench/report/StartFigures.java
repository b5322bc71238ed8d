// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BarChart;
import dev.carom.bench.charts.BarChart.Bar;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.DoubleStream;

/** The first second of a small game, by Carom and by the engines. */
final class StartFigures {

  private static final String SCENE = "start";
  private static final String TIME = "start_time";

  private final Results results;

  StartFigures(Results results) {
    this.results = results;
  }

  /** One figure of two panels, or none if nothing was measured. */
  List<Figure> figures() {
    if (settings().isEmpty()) {
      return List.of();
    }
    String title =
        "The first frame comes after %s to %s; the slowest later frame is shortest with %s"
            .formatted(first(DoubleStream::min), first(DoubleStream::max), best());
    ReportTable.Builder table =
        new ReportTable.Builder("method", "first frame after", "slowest of the next 99 frames");
    settings()
        .forEach(
            s ->
                table.row(
                    Metrics.fullName(s),
                    ReportNumbers.time(value(s, "first")),
                    ReportNumbers.time(value(s, "worst"))));
    return List.of(
        new Figure(
            "start",
            "The first second",
            title,
            "A small game in a fresh virtual machine: 30 circles that collide, among 12 lines. The engines have their defaults.",
            title + ".",
            List.of(
                panel("From the start of Java to the first frame", "first"),
                panel("Slowest of the next 99 frames", "worst")),
            table.build()));
  }

  private String first(Function<DoubleStream, OptionalDouble> which) {
    return ReportNumbers.time(
        which.apply(settings().stream().mapToDouble(s -> value(s, "first"))).orElseThrow());
  }

  private String best() {
    return settings().stream()
        .min(Comparator.comparingDouble(s -> value(s, "worst")))
        .map(s -> Glossary.name(s.method()))
        .orElseThrow();
  }

  private List<Setting> settings() {
    return Settings.of(results, SCENE, TIME);
  }

  private Panel panel(String title, String stat) {
    List<Bar> bars =
        settings().stream()
            .map(
                s ->
                    new Bar(
                        Glossary.name(s.method()),
                        Settings.marks(results).color(s.method()),
                        value(s, stat),
                        ReportNumbers.time(value(s, stat))))
            .toList();
    return new Panel(title, new BarChart(title, bars).picture());
  }

  private double value(Setting setting, String stat) {
    return results.value(SCENE, setting, TIME, stat);
  }
}
