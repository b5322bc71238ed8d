// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Charts of a run frame by frame: trajectory, energy, penetration, and the horizons. */
final class DriftFigures {

  private static final Map<String, String> PANELS = new LinkedHashMap<>();

  static {
    PANELS.put(Metrics.TRAJECTORY_DRIFT, "Distance from the true course, in radii");
    PANELS.put(Metrics.ENERGY_DRIFT, "Error of energy, as a part of the start's");
    PANELS.put(Metrics.PENETRATION_DRIFT, "Penetration so far, in radii");
  }

  private static final int TABLE_ROWS = 5;

  private final Results results;

  DriftFigures(Results results) {
    this.results = results;
  }

  List<Figure> figures() {
    return PANELS.keySet().stream()
        .flatMap(metric -> results.scenes(metric).stream())
        .limit(1) // those of other scenes look as this one does
        .map(this::figure)
        .toList();
  }

  private Figure figure(String scene) {
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    ReportTable.Builder table =
        new ReportTable.Builder("quantity", "setting", "frame", "band from", "line", "band to");
    PANELS.forEach(
        (metric, name) -> {
          List<Curve> curves = curves(scene, metric);
          curves.forEach(curve -> rows(table, name, curve));
          List<Curve> drawn = curves.stream().filter(DriftFigures::isDrawn).toList();
          if (panels.isEmpty() && !drawn.isEmpty()) {
            panels.put(name, drawn);
          }
        });
    Map<String, Double> horizons = horizons(scene);
    double limit = horizon(scene, new Setting(Metrics.NEIGHBOUR, ""));
    String told = told(horizons, limit);
    CurveChart chart =
        new CurveChart(
                "Scene " + scene + ", frame by frame. " + told,
                Settings.marks(results),
                Unit.POWER,
                null,
                panels)
            .along("frame")
            .place(limit, "off by 1 bit");
    return new Figure(
        "drift-" + scene,
        "The course of a run: " + scene,
        title(scene),
        "Line: median of 100 circles; band: 5 to 95 % of Carom's. Each hit on an endpoint multiplies an error, so no program in doubles stays right much longer.",
        "Distance from the true course, energy and penetration, frame by frame. " + told,
        chart.panels(),
        table.build());
  }

  private String title(String scene) {
    double ours = horizon(scene, Metrics.CAROM);
    double limit = horizon(scene, new Setting(Metrics.NEIGHBOUR, ""));
    if (Double.isNaN(ours)) {
      return "The course of a run in " + scene;
    }
    String theirs =
        Double.isNaN(limit) ? "" : "; if the start is off by one bit, " + until(scene, limit);
    return "Half of Carom's circles stay on the true course " + until(scene, ours) + theirs;
  }

  /** A horizon after the last frame was never reached. */
  private String until(String scene, double frame) {
    int last =
        results.series(scene, Metrics.CAROM, Metrics.TRAJECTORY_DRIFT, "median").keySet().stream()
            .mapToInt(i -> i)
            .max()
            .orElse(Integer.MAX_VALUE);
    return frame > last ? "to the end" : "until frame " + ReportNumbers.count(frame);
  }

  private double horizon(String scene, Setting setting) {
    return results.value(scene, setting, Metrics.HORIZON, "median");
  }

  private Map<String, Double> horizons(String scene) {
    Map<String, Double> horizons = new LinkedHashMap<>();
    for (Setting setting : Settings.of(results, scene, Metrics.HORIZON)) {
      double frame = horizon(scene, setting);
      if (!Double.isNaN(frame)) {
        horizons.merge(setting.method(), frame, Math::max); // the best setting of a method
      }
    }
    return horizons;
  }

  private static String told(Map<String, Double> horizons, double limit) {
    List<String> all = new ArrayList<>();
    horizons.forEach(
        (method, frame) -> all.add(Glossary.name(method) + " " + ReportNumbers.count(frame)));
    if (!Double.isNaN(limit)) {
      all.add("the reference started 1 ulp away " + ReportNumbers.count(limit));
    }
    return all.isEmpty()
        ? "No horizon was measured."
        : "Frame at which half of the circles are more than 0.1 radius off, by the best setting of each method: "
            + String.join(", ", all)
            + ".";
  }

  private List<Curve> curves(String scene, String metric) {
    List<Curve> curves = new ArrayList<>();
    for (Setting setting : Settings.finest(results, scene, metric)) {
      Map<Integer, Double> middle = results.series(scene, setting, metric, "median");
      Map<Integer, Double> low = results.series(scene, setting, metric, "p5");
      Map<Integer, Double> high = results.series(scene, setting, metric, "p95");
      int[] frames = middle.keySet().stream().mapToInt(i -> i).sorted().toArray();
      double[] x = Arrays.stream(frames).asDoubleStream().toArray();
      double[] lows = sizes(frames, low);
      double[] middles = sizes(frames, middle);
      double[] highs = sizes(frames, high);
      curves.add(
          metric.equals(Metrics.TRAJECTORY_DRIFT)
              ? new Curve(setting.method(), "", x, lows, middles, highs)
              : worst(setting.method(), x, lows, middles, highs, metric));
    }
    return curves;
  }

  /**
   * Where most circles do nothing wrong, what tells is the worse end, to either side of 0. How deep
   * circles are changes from frame to frame: of that, what tells is the deepest so far.
   */
  private static Curve worst(
      String method, double[] x, double[] low, double[] middle, double[] high, String metric) {
    double[] worse = new double[x.length];
    Arrays.setAll(worse, i -> Math.max(low[i], high[i]));
    if (metric.equals(Metrics.PENETRATION_DRIFT)) {
      Arrays.parallelPrefix(worse, Math::max);
      return new Curve(method, "", x, worse, worse, worse);
    }
    return new Curve(method, "", x, middle, worse, worse);
  }

  private static boolean isDrawn(Curve curve) {
    return Settings.isDrawn(new Setting(curve.method(), curve.knob()));
  }

  private static double[] sizes(int[] frames, Map<Integer, Double> series) {
    return Arrays.stream(frames)
        .mapToDouble(frame -> Math.abs(series.getOrDefault(frame, Double.NaN)))
        .toArray();
  }

  private static void rows(ReportTable.Builder table, String name, Curve curve) {
    int n = curve.x().length;
    for (int k = 1; k <= TABLE_ROWS; k++) {
      int i = k * n / TABLE_ROWS - 1;
      if (i >= 0) {
        table.row(
            name,
            Glossary.name(curve.method()),
            ReportNumbers.count(curve.x()[i]),
            ReportNumbers.error(curve.low()[i]),
            ReportNumbers.error(curve.middle()[i]),
            ReportNumbers.error(curve.high()[i]));
      }
    }
  }
}
