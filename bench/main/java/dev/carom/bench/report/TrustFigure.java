// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.results.Results;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The errors that carom predicts for its places, against the true ones. */
final class TrustFigure {

  private static final String ERROR = "error";

  private static final Marks MARKS =
      new Marks(
          List.of(Metrics.OURS, ERROR),
          line -> line.equals(Metrics.OURS) ? "predicted" : "true error");

  private TrustFigure() {}

  /** One figure, or none if nothing was measured. */
  static List<Figure> of(Results results) {
    List<Standing> scenes =
        results.scenes(Metrics.ERROR_BOUND).stream()
            .sorted()
            .map(scene -> new Standing(results, scene, Metrics.CAROM))
            .toList();
    return scenes.isEmpty() ? List.of() : List.of(figure(scenes));
  }

  private static Figure figure(List<Standing> scenes) {
    double exceeded = scenes.stream().mapToDouble(TrustFigure::exceeded).sum();
    String places = ReportNumbers.count(scenes.stream().mapToDouble(TrustFigure::places).sum());
    String title =
        exceeded == 0
            ? "Carom predicts its own error: none of %s places is further off".formatted(places)
            : "%s of %s places are further from the truth than predicted"
                .formatted(ReportNumbers.count(exceeded), places);
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    scenes.forEach(
        s ->
            panels.put(
                s.scene().equals("falling") ? "With gravity" : "Without gravity", curves(s)));
    return new Figure(
        "trust",
        "How far a place can be trusted",
        title,
        "Carom can tell, for each place, how wrong it is at most. Line: median of that bound; band: 5 to 95 % of the places. It has to stand above the true error.",
        new CurveChart(title, MARKS, Unit.POWER, "error, in radii", panels)
            .alongPowers("true error of a place, in radii")
            .panels(),
        Column.table(
            scenes,
            Column.SCENE,
            new Column("places", s -> ReportNumbers.count(places(s))),
            new Column("error exceeds the bound", s -> ReportNumbers.count(exceeded(s))),
            Column.of(
                "bound, in true errors: median",
                Metrics.ERROR_BOUND_RATIO,
                "median",
                ReportNumbers::error)));
  }

  /** The bound by decades of the true error, each at its middle, and that error. */
  private static List<Curve> curves(Standing s) {
    Curve bound =
        Curves.ofSeries(
            s,
            Metrics.ERROR_BOUND,
            List.of("p5", "median", "p95"),
            decade -> Math.pow(10, decade + 0.5));
    double[] x = bound.x();
    return List.of(bound, new Curve(ERROR, "", x, x, x, x));
  }

  private static double exceeded(Standing s) {
    return s.value(Metrics.ERROR_BOUND_EXCEEDED, "count");
  }

  private static double places(Standing s) {
    return s.value(Metrics.ERROR_BOUND_EXCEEDED, "of");
  }
}
