// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/** Carom beside the engines: a frame, a heap, a gas, and the first second of a game. */
final class PeerFigures {

  private static final String HEAP = "heap";
  private static final String GAS = "gas";
  private static final String START = "start";
  private static final String START_TIME = "start_time";

  private final Results results;

  PeerFigures(Results results) {
    this.results = results;
  }

  private static String method(Standing s) {
    return Glossary.name(s.method());
  }

  /** Carom and the engines at their best settings, as bars; none if no engine was timed. */
  List<Figure> engines() {
    String scene = new FirstScreen(results).scene();
    List<Standing> timed =
        Standing.all(results, scene).stream()
            .filter(s -> !s.time().failed() && !Glossary.isDefault(s.setting()))
            .filter(s -> s.isOurs() || Glossary.isEngine(s.setting()))
            .sorted(Comparator.comparingDouble(PeerFigures::median))
            .toList();
    return timed.size() < 2
        ? List.of()
        : Standing.ours(timed).map(ours -> engines(timed, ours)).stream().toList();
  }

  private static Figure engines(List<Standing> timed, Standing ours) {
    String times =
        ReportNumbers.range(
            timed.stream().filter(s -> !s.isOurs()).mapToDouble(s -> median(s) / median(ours)),
            ReportNumbers::count);
    String title = "Carom is %s times as fast as the engines".formatted(times);
    Panel bars =
        Figure.bars(
            title, timed, PeerFigures::method, Metrics.FRAME_TIME, "median", ReportNumbers::time);
    return Figure.of("engines", title, List.of(bars), ReportTable.NONE, Scenes.size(ours.scene()));
  }

  private static double median(Standing s) {
    return s.time().middle();
  }

  /** Circles that fall into a heap: two panels, or none if nothing was measured. */
  List<Figure> heap() {
    List<Standing> all = Standing.of(results, HEAP, Metrics.HEAP_OVERLAP);
    return all.isEmpty() ? List.of() : List.of(heap(all));
  }

  private static Figure heap(List<Standing> all) {
    String title =
        "In a heap, Carom's circles touch; those of the engines, each at its better setting, sink %s radii into each other"
            .formatted(overlaps(all));
    List<Panel> panels =
        List.of(
            Figure.bars(
                "Deepest overlap, in radii",
                all,
                Standing::name,
                Metrics.HEAP_OVERLAP,
                "max",
                ReportNumbers::error),
            Figure.bars(
                "Mean frame; faster than Carom: " + Standing.faster(all, "mean"),
                all,
                Standing::name,
                Metrics.FRAME_TIME,
                "mean",
                ReportNumbers::time));
    ReportTable table =
        Column.table(
            all,
            Column.SETTING,
            Column.of("overlap", Metrics.HEAP_OVERLAP, "max", ReportNumbers::error),
            Column.of("overlap at the end", Metrics.HEAP_OVERLAP, "end", ReportNumbers::error),
            Column.of("energy from nowhere", Metrics.HEAP_ENERGY, "gained", ReportNumbers::percent),
            Column.of("at rest after", Metrics.HEAP_REST, "frame", PeerFigures::seconds),
            Column.of("mean frame", Metrics.FRAME_TIME, "mean", ReportNumbers::time),
            Column.ratio("Carom = 1", Metrics.FRAME_TIME, "mean"),
            Column.of("worst frame", Metrics.FRAME_TIME, "worst", ReportNumbers::time));
    return Figure.of(HEAP, title, panels, table);
  }

  /** The least and the greatest overlap of others, each at the setting that overlaps less. */
  private static String overlaps(List<Standing> all) {
    return ReportNumbers.range(
        all.stream()
            .filter(s -> !s.isOurs())
            .collect(Collectors.toMap(Standing::method, PeerFigures::overlap, Math::min))
            .values()
            .stream()
            .mapToDouble(overlap -> overlap),
        ReportNumbers::error);
  }

  private static double overlap(Standing s) {
    return s.value(Metrics.HEAP_OVERLAP, "max");
  }

  private static String seconds(double frames) {
    return Double.isInfinite(frames) ? "not in 10 s" : ReportNumbers.ratio(frames / 60) + " s";
  }

  /** Circles that collide: a table, or none if nothing was measured. */
  List<Figure> gas() {
    List<Standing> all = Standing.of(results, GAS, Metrics.GAS_ENERGY);
    return Standing.ours(all).map(ours -> gas(all, ours)).stream().toList();
  }

  private static Figure gas(List<Standing> all, Standing ours) {
    String title =
        "Colliding circles: Carom keeps energy to %s and overlaps by %s; faster: %s"
            .formatted(
                ReportNumbers.percent(ours.value(Metrics.GAS_ENERGY, "max")),
                ReportNumbers.radii(ours.value(Metrics.GAS_OVERLAP, "max")),
                Standing.faster(all, "median"));
    ReportTable table =
        Column.table(
            all,
            Column.SHORT_SETTING,
            Column.time("time of a frame", Metrics.FRAME_TIME, "median"),
            Column.ratio("Carom = 1", Metrics.FRAME_TIME, "median"),
            Column.of(
                "energy gained or lost, worst frame",
                Metrics.GAS_ENERGY,
                "max",
                ReportNumbers::percent),
            Column.of(
                "deepest overlap, in radii", Metrics.GAS_OVERLAP, "max", ReportNumbers::error),
            Column.of("circles lost, of 100", Metrics.GAS_LOST, "circles", ReportNumbers::count));
    return Figure.of(GAS, title, List.of(), table);
  }

  /** The first second of a small game: two panels, or none if nothing was measured. */
  List<Figure> start() {
    List<Standing> all = Standing.of(results, START, START_TIME);
    return all.stream()
        .min(Comparator.comparingDouble(s -> s.value(START_TIME, "worst")))
        .map(best -> start(all, best))
        .stream()
        .toList();
  }

  private static Figure start(List<Standing> all, Standing best) {
    String title =
        "The first frame comes after %s; the slowest later frame is shortest with %s"
            .formatted(
                ReportNumbers.range(
                    all.stream().mapToDouble(s -> s.value(START_TIME, "first")),
                    ReportNumbers::time),
                method(best));
    List<Panel> panels =
        List.of(
            start("From the start of Java to the first frame", all, "first"),
            start("Slowest of the next 99 frames", all, "worst"));
    return Figure.of(START, title, panels, ReportTable.NONE);
  }

  private static Panel start(String title, List<Standing> all, String stat) {
    return Figure.bars(title, all, PeerFigures::method, START_TIME, stat, ReportNumbers::time);
  }
}
