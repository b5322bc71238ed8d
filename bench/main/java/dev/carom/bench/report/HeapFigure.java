// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Marks;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Spread;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/** Circles that fall into a heap, by Carom and by the engines: overlap, rest, energy, time. */
final class HeapFigure {

  private static final String SCENE = "heap";

  private final Marks marks;
  private final List<Standing> all;

  private HeapFigure(Results results) {
    marks = Settings.marks(results);
    all = Standing.of(results, SCENE, Metrics.HEAP_OVERLAP);
  }

  /** One of two panels, or none if nothing was measured. */
  static List<Figure> of(Results results) {
    HeapFigure heap = new HeapFigure(results);
    return heap.all.isEmpty() ? List.of() : List.of(heap.figure());
  }

  private Figure figure() {
    List<Panel> panels =
        List.of(
            panel("Deepest overlap, in radii", HeapFigure::overlap, ReportNumbers::error),
            panel(
                "Mean frame; faster than Carom: " + faster(),
                s -> s.value(Metrics.FRAME_TIME, "mean"),
                ReportNumbers::time));
    return new Figure(
        SCENE,
        "A heap",
        "In a heap, Carom's circles touch; those of the engines, each at its better setting, sink %s radii into each other"
            .formatted(engines()),
        "100 circles fall into a heap and come to rest. Each engine has its defaults, then is tuned for accuracy, which need not help in a heap. The mean frame is that of fall and rest together.",
        panels,
        table());
  }

  private Panel panel(String title, ToDoubleFunction<Standing> value, DoubleFunction<String> text) {
    return new Panel(title, Figure.bars(title, all, Standing::name, marks, value, text));
  }

  /** The least and the greatest overlap of others, each at the setting that overlaps less. */
  private String engines() {
    return ReportNumbers.range(
        all.stream()
            .filter(s -> !s.isOurs())
            .collect(Collectors.toMap(Standing::method, HeapFigure::overlap, Math::min))
            .values()
            .stream()
            .mapToDouble(overlap -> overlap),
        ReportNumbers::error);
  }

  private static double overlap(Standing s) {
    return s.value(Metrics.HEAP_OVERLAP, "max");
  }

  private String faster() {
    Optional<Spread> ours = Standing.ours(all).flatMap(HeapFigure::mean);
    String names =
        all.stream()
            .filter(s -> ours.isPresent() && mean(s).filter(t -> t.isBelow(ours.get())).isPresent())
            .map(Standing::name)
            .collect(Collectors.joining(", "));
    return names.isEmpty() ? "none" : names;
  }

  private static Optional<Spread> mean(Standing s) {
    return s.spread(Metrics.FRAME_TIME, "mean");
  }

  private ReportTable table() {
    return Column.table(
        all,
        Column.SETTING,
        Column.of("deepest overlap, in radii", Metrics.HEAP_OVERLAP, "max", ReportNumbers::error),
        Column.of("overlap at the end", Metrics.HEAP_OVERLAP, "end", ReportNumbers::error),
        Column.of("energy from nowhere", Metrics.HEAP_ENERGY, "gained", ReportNumbers::percent),
        Column.of("at rest after", Metrics.HEAP_REST, "frame", HeapFigure::seconds),
        Column.of("mean frame", Metrics.FRAME_TIME, "mean", ReportNumbers::time),
        Column.ratio("Carom = 1", Metrics.FRAME_TIME, "mean"),
        Column.of("worst frame", Metrics.FRAME_TIME, "worst", ReportNumbers::time));
  }

  private static String seconds(double frames) {
    return Double.isInfinite(frames) ? "not in 10 s" : ReportNumbers.ratio(frames / 60) + " s";
  }
}
