// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.series.Growth;
import dev.carom.bench.series.Scale;
import dev.carom.bench.series.ScalePlan.Model;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Time of a frame against the number of circles. */
public final class ScaleFigures {

  private static final double BUDGET = 1e6 * Budget.MILLIS;

  private final Results results;
  private final Map<Model, List<Curve>> curves = new EnumMap<>(Model.class);
  private final double limit;

  /**
   * Prepares the figure.
   *
   * @param results what was measured
   * @param limit the time of a frame that was too long, in nanoseconds
   */
  public ScaleFigures(Results results, double limit) {
    this.results = results;
    this.limit = limit;
    Stream.of(Model.values())
        .forEach(model -> curves.put(model, ScaleTimes.curves(results, model)));
    curves.values().removeIf(List::isEmpty);
  }

  /** Makes the figure: one, or none if nothing was measured. */
  public List<Figure> figures() {
    if (curves.isEmpty()) {
      return List.of();
    }
    String title =
        Stream.of(Metrics.OURS, FirstScreen.ENGINE)
            .map(this::within)
            .filter(words -> !words.isEmpty())
            .collect(Collectors.joining("; ", "At 60 frames a second ", ""));
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    curves.forEach((model, lines) -> panels.put(model.title(), lines));
    CurveChart chart =
        new CurveChart(title, Settings.marks(results), Unit.TIME, "median time of a frame", panels)
            .alongCounts("number of circles")
            .level(BUDGET, "60 FPS")
            .limit(limit);
    return List.of(Figure.of("scale", title, chart.panels(), table(), ReportNumbers.time(limit)));
  }

  private String within(String method) {
    String circles =
        curves.keySet().stream()
            .flatMap(
                model ->
                    ScaleTimes.within(results, model, method, BUDGET).stream()
                        .map(n -> n + (model == Model.GAS ? " that collide" : " circles")))
            .collect(Collectors.joining(", or "));
    return circles.isEmpty() ? "" : Glossary.name(method) + " moves " + circles;
  }

  /** How times grow with the number of circles, and what a world takes of memory: sentences. */
  public List<String> told() {
    Stream<String> growth =
        curves.entrySet().stream()
            .flatMap(lines -> Curves.growth(lines.getKey().words(), lines.getValue()));
    return Stream.concat(growth, memory()).toList();
  }

  private Stream<String> memory() {
    return Standing.ours(results, Scale.MEMORY).stream()
        .map(
            s ->
                String.format(
                    Locale.ROOT,
                    "A world of %s circles and lines takes %.0f bytes a circle and %.0f a line.",
                    ReportNumbers.count(Curves.size(s.scene())),
                    s.value(Scale.MEMORY, "circle"),
                    s.value(Scale.MEMORY, "line")));
  }

  /** The growth of carom in each model, and the methods that became too slow. */
  String verdict() {
    List<String> models = new ArrayList<>();
    List<String> late = new ArrayList<>();
    curves.forEach(
        (model, lines) -> {
          for (Curve curve : lines) {
            if (curve.method().equals(Metrics.OURS)) {
              Curves.growth(curve).ifPresent(fit -> models.add(growth(model, curve, fit)));
            }
            if (Double.isNaN(last(curve.middle()))) {
              late.add(late(model, curve));
            }
          }
        });
    if (models.isEmpty()) {
      return "Growth: not measured.";
    }
    return "Growth: the time of a frame of Carom grows %s%s."
        .formatted(
            String.join("; ", models),
            late.isEmpty() ? "" : "; too slow to go on: " + String.join(", ", late));
  }

  private static String late(Model model, Curve curve) {
    String words = model == Model.GAS ? " (colliding)" : " (alone)";
    return Glossary.name(curve.method()) + " at " + ReportNumbers.count(last(curve.x())) + words;
  }

  private static String growth(Model model, Curve curve, Growth fit) {
    int most = curve.middle().length - 1;
    while (Double.isNaN(curve.middle()[most])) {
      most--;
    }
    return "with %s %s, up to %s for %s"
        .formatted(
            model.words(),
            Curves.power(fit),
            ReportNumbers.time(curve.middle()[most]),
            ReportNumbers.count(curve.x()[most]));
  }

  private static double last(double[] numbers) {
    return numbers[numbers.length - 1];
  }

  /** The numbers: a row for each scene and method. */
  public ReportTable table() {
    Map<String, List<Curve>> lines = new LinkedHashMap<>();
    curves.forEach((model, of) -> lines.put(model.label(), of));
    String late = "over " + ReportNumbers.time(limit);
    return Curves.table(
        lines,
        List.of("model", "circles", "method", "a frame", "least", "greatest"),
        time -> Double.isNaN(time) ? late : ReportNumbers.time(time));
  }
}
