// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;

/** How far circles are from their true course, frame by frame. */
final class DriftFigure {

  private final Results results;
  private final String scene;
  private final List<Curve> curves;

  private DriftFigure(Results results, String scene) {
    this.results = results;
    this.scene = scene;
    curves =
        Standing.drawn(results, scene, Metrics.TRAJECTORY_DRIFT).stream()
            .map(
                s ->
                    Curves.ofSeries(
                        s,
                        Metrics.TRAJECTORY_DRIFT,
                        List.of("p5", "median", "p95"),
                        DoubleUnaryOperator.identity()))
            .toList();
  }

  /** That of the first scene, for those of others look as it does; or none. */
  static List<Figure> of(Results results) {
    return results.scenes(Metrics.TRAJECTORY_DRIFT).stream()
        .limit(1)
        .map(scene -> new DriftFigure(results, scene).figure())
        .toList();
  }

  private Figure figure() {
    double ours = horizon(Metrics.CAROM);
    double limit = horizon(new Setting(Metrics.NEIGHBOUR, ""));
    String title =
        "Half of Carom's circles stay on the true course %s; if the start is off by one bit, %s"
            .formatted(until(ours), until(limit));
    CurveChart chart =
        new CurveChart(
                title,
                Settings.marks(results),
                Unit.POWER,
                null,
                Map.of("Distance from the true course, in radii", curves))
            .along("frame")
            .place(limit, "off by 1 bit");
    return new Figure(
        "drift-" + scene,
        "The course of a run: " + scene,
        title,
        "Line: median of 100 circles; band: 5 to 95 % of Carom's. Each hit on an endpoint multiplies an error, so no program in doubles stays right much longer.",
        chart.panels(),
        Column.table(
            Standing.of(results, scene, Metrics.HORIZON),
            Column.SHORT_SETTING,
            Column.of(
                "half of the circles are more than 0.1 radius off at frame",
                Metrics.HORIZON,
                "median",
                ReportNumbers::count)));
  }

  private double horizon(Setting setting) {
    return results.value(scene, setting, Metrics.HORIZON, "median");
  }

  /** A horizon after the last frame was never reached. */
  private String until(double frame) {
    double[] frames = curves.get(0).x();
    return frame > frames[frames.length - 1]
        ? "to the end"
        : "until frame " + ReportNumbers.count(frame);
  }
}
