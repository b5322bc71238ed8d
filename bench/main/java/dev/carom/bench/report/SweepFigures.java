// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.series.Growth;
import dev.carom.bench.series.Sweep;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** The published experiment's own figures: time against circles, radius, lines and impacts. */
public final class SweepFigures {

  private static final Map<String, String> PANELS = new LinkedHashMap<>();

  static {
    PANELS.put("circles", "number of circles");
    PANELS.put("radius", "radius in px");
    PANELS.put("lines", "number of lines");
    PANELS.put("impacts", "number of impacts in it");
  }

  /** The panels whose numbers are sizes of the scene, so that there is a growth. */
  private static final List<String> SIZES = List.of("circles", "lines");

  private static final int LEAST_POINTS = 3;

  private final Results results;

  /**
   * Prepares the figure.
   *
   * @param results what was measured
   */
  public SweepFigures(Results results) {
    this.results = results;
  }

  /** Makes the figure: one, or none if no sweep was measured. */
  public List<Figure> figures() {
    if (results.scenes(Sweep.TIME).isEmpty()) {
      return List.of();
    }
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    PANELS.forEach(
        (axis, name) -> {
          List<Curve> curves = curves(axis);
          if (!curves.isEmpty()) {
            panels.put("Time of a frame against the " + name, curves);
          }
        });
    String title = title();
    CurveChart chart =
        new CurveChart(
                "Time of a frame against circles, radius, lines and impacts.",
                Settings.marks(results),
                Unit.TIME,
                null,
                panels)
            .level(1e9 / Budget.PUBLISHED_FPS, "published: 19.2 frames/s")
            .levelBelow(1e6 * Budget.MILLIS, "goal: 60 frames/s");
    String caption =
        "Time of a frame against circles, radius, lines and impacts, with the published 19.2 frames per second and the goal of 60. "
            + title
            + ". "
            + String.join(" ", growth());
    return List.of(
        new Figure(
            "sweep",
            "The published experiment",
            title,
            "100 circles of radius 10 among 100 lines, one of these numbers varied. Line: mean; band: from the fastest to the slowest of 600 frames.",
            caption,
            chart.panels(),
            table()));
  }

  /** How times grow with the sizes of the scene: a sentence for each size and method. */
  public List<String> growth() {
    List<String> sentences = new ArrayList<>();
    for (String axis : SIZES) {
      for (Curve curve : curves(axis)) {
        if (curve.x().length >= LEAST_POINTS) {
          Growth fit = Growth.of(curve.x(), curve.middle());
          sentences.add(
              String.format(
                  Locale.ROOT,
                  "The time of %s grows with the number of %s to the power %.2f (%.2f .. %.2f at 95 %%).",
                  Glossary.name(curve.method()),
                  axis,
                  fit.slope(),
                  fit.low(),
                  fit.high()));
        }
      }
    }
    return sentences;
  }

  private String title() {
    Map<String, Double> full = new LinkedHashMap<>();
    for (Curve curve : curves("circles")) {
      int last = curve.x().length - 1;
      full.put(curve.method(), curve.middle()[last]);
    }
    return full.entrySet().stream()
            .map(e -> Glossary.name(e.getKey()) + " " + ReportNumbers.time(e.getValue()))
            .collect(Collectors.joining(", ", "The mean frame with the most circles: ", "; "))
        + "in the publication "
        + ReportNumbers.time(1e9 / Budget.PUBLISHED_FPS);
  }

  private List<Curve> curves(String axis) {
    Map<Setting, List<Integer>> places = new LinkedHashMap<>();
    for (String scene : results.scenes(Sweep.TIME)) {
      String prefix = Sweep.SCENE + axis + "=";
      if (scene.startsWith(prefix)) {
        int at = Integer.parseInt(scene.substring(prefix.length()));
        for (Setting setting : Settings.of(results, scene, Sweep.TIME)) {
          places.computeIfAbsent(setting, none -> new ArrayList<>()).add(at);
        }
      }
    }
    List<Curve> curves = new ArrayList<>();
    places.forEach((setting, at) -> curves.add(curve(axis, setting, at)));
    return curves;
  }

  private Curve curve(String axis, Setting setting, List<Integer> places) {
    int[] sorted = places.stream().mapToInt(i -> i).sorted().toArray();
    int n = sorted.length;
    double[][] values = new double[4][n];
    for (int i = 0; i < n; i++) {
      String scene = Sweep.SCENE + axis + "=" + sorted[i];
      values[0][i] = sorted[i];
      values[1][i] = results.value(scene, setting, Sweep.TIME, "min");
      values[2][i] = results.value(scene, setting, Sweep.TIME, "mean");
      values[3][i] = results.value(scene, setting, Sweep.TIME, "max");
    }
    String slope =
        SIZES.contains(axis) && n >= LEAST_POINTS
            ? String.format(Locale.ROOT, "grows as n^%.2f", Growth.of(values[0], values[2]).slope())
            : "";
    return new Curve(setting.method(), slope, values[0], values[1], values[2], values[3]);
  }

  /** The numbers: a row for each place and method. */
  public ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "varied", "value", "method", "mean", "least", "greatest", "frames a second");
    for (String axis : PANELS.keySet()) {
      for (Curve curve : curves(axis)) {
        for (int i = 0; i < curve.x().length; i++) {
          table.row(
              axis,
              ReportNumbers.count(curve.x()[i]),
              Glossary.name(curve.method()),
              ReportNumbers.time(curve.middle()[i]),
              ReportNumbers.time(curve.low()[i]),
              ReportNumbers.time(curve.high()[i]),
              ReportNumbers.count(1e9 / curve.middle()[i]));
        }
      }
    }
    return table.build();
  }
}
