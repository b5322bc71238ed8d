// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.charts.Marks;
import dev.carom.bench.results.Results;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The errors that carom predicts for its places, against the true ones. */
final class TrustFigures {

  private static final String ERROR = "error";

  private static final Marks MARKS =
      new Marks(
          List.of(Metrics.OURS, ERROR),
          line -> line.equals(Metrics.OURS) ? "predicted" : "true error");

  private final Results results;

  TrustFigures(Results results) {
    this.results = results;
  }

  /** One figure, or none if nothing was measured. */
  List<Figure> figures() {
    List<String> scenes = results.scenes(Metrics.ERROR_BOUND).stream().sorted().toList();
    if (scenes.isEmpty()) {
      return List.of();
    }
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    ReportTable.Builder table =
        new ReportTable.Builder("scene", "true error", "bound, 5 %", "median", "95 %");
    for (String scene : scenes) {
      Curve curve = curve(scene);
      double[] x = curve.x();
      panels.put(
          scene.equals("falling") ? "With gravity" : "Without gravity",
          List.of(curve, new Curve(ERROR, "", x, x, x, x)));
      for (int i = 0; i < curve.x().length; i++) {
        table.row(
            scene,
            ReportNumbers.error(curve.x()[i]),
            ReportNumbers.error(curve.low()[i]),
            ReportNumbers.error(curve.middle()[i]),
            ReportNumbers.error(curve.high()[i]));
      }
    }
    String told = told(scenes);
    return List.of(
        new Figure(
            "trust",
            "How far a place can be trusted",
            title(scenes),
            "Carom can tell, for each place, how wrong it is at most. Line: median of that bound; band: 5 to 95 % of the places. It has to stand above the true error.",
            "The predicted bound of the error against the true error. " + told,
            new CurveChart(told, MARKS, Unit.POWER, "error, in radii", panels)
                .alongPowers("true error of a place, in radii")
                .panels(),
            table.build()));
  }

  /** A decade stands at its middle. */
  private Curve curve(String scene) {
    Map<Integer, Double> medians = series(scene, "median");
    int[] decades = medians.keySet().stream().mapToInt(i -> i).sorted().toArray();
    return new Curve(
        Metrics.OURS,
        "",
        Arrays.stream(decades).mapToDouble(decade -> Math.pow(10, decade + 0.5)).toArray(),
        values(series(scene, "p5"), decades),
        values(medians, decades),
        values(series(scene, "p95"), decades));
  }

  private Map<Integer, Double> series(String scene, String stat) {
    return results.series(scene, Metrics.CAROM, Metrics.ERROR_BOUND, stat);
  }

  private static double[] values(Map<Integer, Double> series, int[] decades) {
    return Arrays.stream(decades).mapToDouble(series::get).toArray();
  }

  private double exceeded(String scene, String stat) {
    return results.value(scene, Metrics.CAROM, Metrics.ERROR_BOUND_EXCEEDED, stat);
  }

  private String title(List<String> scenes) {
    double exceeded = scenes.stream().mapToDouble(scene -> exceeded(scene, "count")).sum();
    double places = scenes.stream().mapToDouble(scene -> exceeded(scene, "of")).sum();
    return exceeded == 0
        ? "Carom predicts its own error: none of %s places is further off"
            .formatted(ReportNumbers.count(places))
        : "%s of %s places are further from the truth than predicted"
            .formatted(ReportNumbers.count(exceeded), ReportNumbers.count(places));
  }

  private String told(List<String> scenes) {
    List<String> told = new ArrayList<>();
    for (String scene : scenes) {
      told.add(
          "%s: the error exceeds the bound at %s of %s places; in the median the bound is %s times the error"
              .formatted(
                  scene,
                  ReportNumbers.count(exceeded(scene, "count")),
                  ReportNumbers.count(exceeded(scene, "of")),
                  ReportNumbers.error(
                      results.value(scene, Metrics.CAROM, Metrics.ERROR_BOUND_RATIO, "median"))));
    }
    return String.join(". ", told) + ".";
  }
}
