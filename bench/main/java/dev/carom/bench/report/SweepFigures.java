// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.series.Sweep;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** The published experiment's own figures: time against circles, radius, lines and impacts. */
public final class SweepFigures {

  private static final Map<String, String> PANELS = new LinkedHashMap<>();

  static {
    PANELS.put("circles", "Time of a frame against the number of circles");
    PANELS.put("radius", "Time of a frame against the radius in px");
    PANELS.put("lines", "Time of a frame against the number of lines");
    PANELS.put("impacts", "Time of a frame against the number of impacts in it");
  }

  /** The panels whose numbers are sizes of the scene, so that there is a growth. */
  private static final List<String> SIZES = List.of("circles", "lines");

  private final Results results;
  private final Map<String, List<Curve>> curves = new LinkedHashMap<>();

  /**
   * Prepares the figure.
   *
   * @param results what was measured
   */
  public SweepFigures(Results results) {
    this.results = results;
    PANELS.keySet().forEach(axis -> curves.put(axis, curves(axis)));
    curves.values().removeIf(List::isEmpty);
  }

  private List<Curve> curves(String axis) {
    return Curves.ofScenes(
        Curves.along(results, Sweep.TIME, Sweep.SCENE + axis + "="),
        s ->
            new double[] {
              s.value(Sweep.TIME, "min"), s.value(Sweep.TIME, "mean"), s.value(Sweep.TIME, "max")
            });
  }

  /** Makes the figure: one, or none if no sweep was measured. */
  public List<Figure> figures() {
    if (curves.isEmpty()) {
      return List.of();
    }
    String title = title();
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    curves.forEach((axis, lines) -> panels.put(PANELS.get(axis), lines));
    CurveChart chart =
        new CurveChart(title, Settings.marks(results), Unit.TIME, null, panels)
            .level(1e9 / Budget.PUBLISHED_FPS, "published: 19.2 frames/s")
            .levelBelow(1e6 * Budget.MILLIS, "goal: 60 frames/s");
    return List.of(Figure.of("sweep", title, chart.panels(), ReportTable.NONE));
  }

  private String title() {
    return curves.getOrDefault("circles", List.of()).stream()
        .map(
            curve ->
                Glossary.name(curve.method())
                    + " "
                    + ReportNumbers.time(curve.middle()[curve.x().length - 1]))
        .collect(
            Collectors.joining(
                ", ",
                "The mean frame with the most circles: ",
                "; in the publication " + ReportNumbers.time(1e9 / Budget.PUBLISHED_FPS)));
  }

  /** How times grow with the sizes of the scene: a sentence for each size and method. */
  public List<String> growth() {
    return SIZES.stream()
        .flatMap(axis -> Curves.growth(axis, curves.getOrDefault(axis, List.of())))
        .toList();
  }

  /** The numbers: a row for each place and method. */
  public ReportTable table() {
    return Curves.table(
        curves,
        List.of("varied", "value", "method", "mean", "least", "greatest"),
        ReportNumbers::time);
  }
}
