// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Whole runs: how far circles leave their true course, and how well Carom knows that. */
final class RunFigures {

  private static final List<String> BAND = List.of("p5", "median", "p95");
  private static final List<String> WORST = List.of("worst", "worst", "worst");
  private static final String ERROR = "error";

  private final Results results;

  RunFigures(Results results) {
    this.results = results;
  }

  /** A frame-by-frame comparison with the true course, of the first scene; or none. */
  List<Figure> drift() {
    return results.scenes(Metrics.TRAJECTORY_DRIFT).stream().limit(1).map(this::drift).toList();
  }

  private Figure drift(String scene) {
    List<Curve> curves =
        Standing.drawn(results, scene, Metrics.TRAJECTORY_DRIFT).stream()
            .map(s -> Curves.ofSeries(s, Metrics.TRAJECTORY_DRIFT, BAND, frame -> frame))
            .toList();
    double ours = horizon(scene, Metrics.CAROM);
    double limit = horizon(scene, new Setting(Metrics.NEIGHBOUR, ""));
    double end = last(curves.get(0).x());
    String title =
        "Half of Carom's circles stay on the true course %s; if the start is off by one bit, %s"
            .formatted(until(ours, end), until(limit, end));
    CurveChart chart =
        chart(title, Unit.POWER, null, Map.of("Distance from the true course, in radii", curves))
            .along("frame")
            .place(limit, "%.0f: 1 bit off".formatted(limit))
            .point(ours, 0.1, "frame %.0f".formatted(ours));
    ReportTable table =
        Column.table(
            Standing.of(results, scene, Metrics.HORIZON),
            Column.SHORT_SETTING,
            Column.of(
                "half of the circles are more than 0.1 radius off at frame",
                Metrics.HORIZON,
                "median",
                ReportNumbers::count));
    return Figure.of("drift-" + scene, title, chart.panels(), table);
  }

  private double horizon(String scene, Setting setting) {
    return results.value(scene, setting, Metrics.HORIZON, "median");
  }

  /** A horizon after the last frame was never reached. */
  private static String until(double frame, double end) {
    return frame > end ? "to the end" : "until frame " + ReportNumbers.count(frame);
  }

  private CurveChart chart(String title, Unit unit, String label, Map<String, List<Curve>> panels) {
    return new CurveChart(title, Settings.marks(results), unit, label, panels);
  }

  /** The energy of a ball that bounces under gravity, or none. */
  List<Figure> bounce() {
    List<Standing> all = Standing.of(results, Metrics.BOUNCE, Metrics.BOUNCE_ENERGY);
    return Standing.ours(all).map(ours -> bounce(all, energy(ours))).stream().toList();
  }

  private Figure bounce(List<Standing> all, Curve ours) {
    Map<String, Curve> drawn = new LinkedHashMap<>();
    all.forEach(
        s ->
            drawn.merge(
                s.method(), energy(s), (a, b) -> last(b.middle()) < last(a.middle()) ? b : a));
    String bounces = ReportNumbers.count(last(ours.x()));
    double error = last(ours.middle());
    String title =
        error == 0
            ? "Carom's ball bounces %s times without a measurable change of energy"
                .formatted(bounces)
            : "After %s bounces the energy of Carom's ball is off by at most %s"
                .formatted(bounces, ReportNumbers.error(error));
    CurveChart chart =
        chart(title, Unit.SHARE, "error of the energy", Map.of("", new ArrayList<>(drawn.values())))
            .alongCounts("number of bounces");
    ReportTable table =
        Column.table(
            all,
            Column.SHORT_SETTING,
            new Column("bounces", s -> ReportNumbers.count(last(energy(s).x()))),
            new Column("worst energy error", s -> ReportNumbers.percent(last(energy(s).middle()))));
    return Figure.of("bounce", title, chart.panels(), table);
  }

  private static Curve energy(Standing s) {
    Curve curve = Curves.ofSeries(s, Metrics.BOUNCE_ENERGY, WORST, bounces -> bounces);
    String knob = Glossary.shortKnob(s.setting());
    return new Curve(s.method(), knob, curve.x(), curve.low(), curve.middle(), curve.high());
  }

  /** The errors that carom predicts for its places, against the true ones; or none. */
  List<Figure> trust() {
    List<Standing> scenes =
        Standing.ours(results, Metrics.ERROR_BOUND).stream()
            .sorted(Comparator.comparing(Standing::scene))
            .toList();
    return scenes.isEmpty() ? List.of() : List.of(trust(scenes));
  }

  private static Figure trust(List<Standing> scenes) {
    double exceeded = scenes.stream().mapToDouble(RunFigures::exceeded).sum();
    String places = ReportNumbers.count(scenes.stream().mapToDouble(RunFigures::places).sum());
    String title =
        exceeded == 0
            ? "Carom predicts its own error: none of %s places is further off".formatted(places)
            : "%s of %s places are further from the truth than predicted"
                .formatted(ReportNumbers.count(exceeded), places);
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    for (Standing s : scenes) {
      panels.put(s.scene().equals("falling") ? "With gravity" : "Without gravity", bounds(s));
    }
    Marks marks =
        new Marks(
            List.of(Metrics.OURS, ERROR),
            line -> line.equals(Metrics.OURS) ? "predicted" : "true error");
    CurveChart chart =
        new CurveChart(title, marks, Unit.POWER, "error, in radii", panels)
            .alongPowers("true error of a place, in radii");
    ReportTable table =
        Column.table(
            scenes,
            Column.SCENE,
            new Column("places", s -> ReportNumbers.count(places(s))),
            new Column("error exceeds the bound", s -> ReportNumbers.count(exceeded(s))),
            Column.of(
                "bound, in true errors: median",
                Metrics.ERROR_BOUND_RATIO,
                "median",
                ReportNumbers::error));
    return Figure.of("trust", title, chart.panels(), table);
  }

  /** The bound by decades of the true error, each at its middle, and that error. */
  private static List<Curve> bounds(Standing s) {
    Curve bound =
        Curves.ofSeries(s, Metrics.ERROR_BOUND, BAND, decade -> Math.pow(10, decade + 0.5));
    double[] x = bound.x();
    return List.of(bound, new Curve(ERROR, "", x, x, x, x));
  }

  private static double exceeded(Standing s) {
    return s.value(Metrics.ERROR_BOUND_EXCEEDED, "count");
  }

  private static double places(Standing s) {
    return s.value(Metrics.ERROR_BOUND_EXCEEDED, "of");
  }

  private static double last(double[] numbers) {
    return numbers[numbers.length - 1];
  }
}
