// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.report.ScaleTimes.Per;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.series.ScalePlan.Model;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Time per frame, per impact and per circle, against the number of circles. */
public final class ScaleFigures {

  private final Results results;
  private final ScaleTimes times;
  private final ScaleGrowth growth;
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
    times = new ScaleTimes(results);
    growth = new ScaleGrowth(results);
  }

  /** Makes the figure: one, or none if nothing was measured. */
  public List<Figure> figures() {
    if (times.isEmpty()) {
      return List.of();
    }
    Map<String, List<Curve>> panels = new LinkedHashMap<>();
    for (Model model : Model.values()) {
      List<Curve> curves = times.curves(model, Per.FRAME);
      if (!curves.isEmpty()) {
        panels.put(model.title(), curves.stream().map(ScaleFigures::unset).toList());
      }
    }
    CurveChart chart =
        new CurveChart(
                "Time against the number of circles.",
                Settings.marks(results),
                Unit.TIME,
                "median time of a frame",
                panels)
            .alongCounts("number of circles")
            .level(1e6 * Budget.MILLIS, "60 FPS")
            .limit(limit);
    String caption =
        "Time of a frame, of an impact and of a circle against the number of circles, by each method up to where one frame takes longer than %s. "
                .formatted(ReportNumbers.time(limit))
            + String.join(" ", told());
    return List.of(
        new Figure(
            "scale",
            "Many circles",
            growth.title(),
            "Equal density in all scenes; engines at their defaults. A crossed ring above the break: a frame took longer than %s, and larger scenes were not played."
                .formatted(ReportNumbers.time(limit)),
            caption.strip(),
            chart.panels(),
            table()));
  }

  /** Each method stands there in one setting: it needs no name. */
  private static Curve unset(Curve c) {
    return new Curve(c.method(), "", c.x(), c.low(), c.middle(), c.high());
  }

  /** How times grow with the number of circles, and what a world takes of memory: sentences. */
  public List<String> told() {
    List<String> told = new ArrayList<>(growth.sentences());
    growth.memory().ifPresent(told::add);
    return told;
  }

  /** The numbers: a row for each scene and method. */
  public ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "model", "circles", "method", "a frame", "least", "greatest", "an impact", "a circle");
    for (Model model : Model.values()) {
      for (Curve curve : times.curves(model, Per.FRAME)) {
        for (int i = 0; i < curve.x().length; i++) {
          row(table, model, curve, i);
        }
      }
    }
    return table.build();
  }

  private void row(ReportTable.Builder table, Model model, Curve curve, int i) {
    double n = curve.x()[i];
    double time = curve.middle()[i];
    Setting setting = new Setting(curve.method(), curve.knob());
    double impacts = times.impacts(ScaleTimes.scene(model, n), setting);
    boolean cut = Double.isNaN(time);
    table.row(
        model.label(),
        ReportNumbers.count(n),
        Glossary.name(curve.method()),
        cut ? "over " + ReportNumbers.time(limit) : ReportNumbers.time(time),
        cut ? "-" : ReportNumbers.time(curve.low()[i]),
        cut ? "-" : ReportNumbers.time(curve.high()[i]),
        impacts > 0 && !cut ? ReportNumbers.time(time / impacts) : "-",
        cut ? "-" : ReportNumbers.time(time / n));
  }
}
