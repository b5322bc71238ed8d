// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.CurveChart;
import dev.carom.bench.charts.CurveChart.Unit;
import dev.carom.bench.results.Results;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;

/** A ball that bounces under gravity: the energy that each method has gained or lost. */
final class BounceFigure {

  private static final String WORST = "worst";

  private BounceFigure() {}

  /** One figure, or none if nothing was measured. */
  static List<Figure> of(Results results) {
    List<Standing> all = Standing.of(results, Metrics.BOUNCE, Metrics.BOUNCE_ENERGY);
    Map<String, Curve> drawn = new LinkedHashMap<>();
    all.forEach(s -> drawn.merge(s.method(), curve(s), (a, b) -> error(b) < error(a) ? b : a));
    Curve ours = drawn.get(Metrics.OURS);
    return ours == null ? List.of() : List.of(figure(results, all, drawn, ours));
  }

  private static Figure figure(
      Results results, List<Standing> all, Map<String, Curve> drawn, Curve ours) {
    String bounces = bounces(ours);
    String title =
        error(ours) == 0
            ? "Carom's ball bounces %s times without a measurable change of energy"
                .formatted(bounces)
            : "After %s bounces the energy of Carom's ball is off by at most %s"
                .formatted(bounces, ReportNumbers.error(error(ours)));
    CurveChart chart =
        new CurveChart(
                title,
                Settings.marks(results),
                Unit.SHARE,
                "error of the energy",
                Map.of("", new ArrayList<>(drawn.values())))
            .alongCounts("number of bounces");
    return new Figure(
        "bounce",
        "A ball that bounces",
        title,
        "A ball under gravity on a level floor; its energy should not change. The worst error so far, of each engine at its better setting. At 100 % the ball lies still or bounces twice as high.",
        chart.panels(),
        Column.table(
            all,
            Column.SHORT_SETTING,
            new Column("bounces", s -> bounces(curve(s))),
            new Column("worst energy error", s -> ReportNumbers.percent(error(curve(s))))));
  }

  private static Curve curve(Standing s) {
    Curve curve =
        Curves.ofSeries(
            s, Metrics.BOUNCE_ENERGY, List.of(WORST, WORST, WORST), DoubleUnaryOperator.identity());
    String knob = Glossary.shortKnob(s.setting());
    return new Curve(s.method(), knob, curve.x(), curve.low(), curve.middle(), curve.high());
  }

  private static String bounces(Curve curve) {
    return ReportNumbers.count(curve.x()[curve.x().length - 1]);
  }

  private static double error(Curve curve) {
    return curve.middle()[curve.x().length - 1];
  }
}
