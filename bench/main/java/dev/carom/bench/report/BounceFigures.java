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

/** A ball that bounces under gravity: the energy that each method has gained or lost. */
final class BounceFigures {

  /** Off by so much of its energy, a ball visibly bounces higher or lower. */
  private static final double VISIBLE = 0.01;

  private final Results results;

  BounceFigures(Results results) {
    this.results = results;
  }

  /** One figure, or none if nothing was measured. */
  List<Figure> figures() {
    Map<String, Curve> curves = new LinkedHashMap<>();
    List<Curve> all = new ArrayList<>();
    ReportTable.Builder table =
        new ReportTable.Builder(
            "method", "bounces", "worst energy error", "bounces within which it exceeds 1 %");
    for (Setting setting : Settings.of(results, Metrics.BOUNCE, Metrics.BOUNCE_ENERGY)) {
      Map<Integer, Double> series =
          results.series(Metrics.BOUNCE, setting, Metrics.BOUNCE_ENERGY, "worst");
      int[] bounces = series.keySet().stream().mapToInt(i -> i).sorted().toArray();
      double[] x = Arrays.stream(bounces).asDoubleStream().toArray();
      double[] errors = Arrays.stream(bounces).mapToDouble(series::get).toArray();
      String knob = setting.knob().isEmpty() ? "" : Metrics.shortKnob(setting);
      Curve curve = new Curve(setting.method(), knob, x, errors, errors, errors);
      all.add(curve);
      curves.merge(setting.method(), curve, (a, b) -> end(b) < end(a) ? b : a);
      int last = bounces.length - 1;
      table.row(
          Metrics.shortName(setting),
          ReportNumbers.count(x[last]),
          ReportNumbers.error(errors[last]),
          visible(bounces, errors));
    }
    if (curves.isEmpty()) {
      return List.of();
    }
    CurveChart chart =
        new CurveChart(
                caption(all),
                Settings.marks(results),
                Unit.SHARE,
                "error of the energy",
                Map.of("", List.copyOf(curves.values())))
            .alongCounts("number of bounces");
    return List.of(
        new Figure(
            "bounce",
            "A ball that bounces",
            title(curves),
            "A ball under gravity on a level floor; its energy should not change. The worst error so far, of each engine at its better setting. At 100 % the ball lies still or bounces twice as high.",
            caption(all),
            chart.panels(),
            table.build()));
  }

  private static String visible(int[] bounces, double[] errors) {
    for (int i = 0; i < bounces.length; i++) {
      if (!(errors[i] <= VISIBLE)) {
        return ReportNumbers.count(bounces[i]);
      }
    }
    return "none";
  }

  private static double end(Curve curve) {
    return curve.middle()[curve.middle().length - 1];
  }

  private static String title(Map<String, Curve> curves) {
    Curve ours = curves.get(Metrics.OURS);
    if (ours == null) {
      return "The energy of a ball that bounces";
    }
    String bounces = ReportNumbers.count(ours.x()[ours.x().length - 1]);
    return end(ours) == 0
        ? "Carom's ball bounces %s times without a measurable change of energy".formatted(bounces)
        : "After %s bounces the energy of Carom's ball is off by at most %s"
            .formatted(bounces, ReportNumbers.error(end(ours)));
  }

  private static String caption(List<Curve> curves) {
    List<String> told = new ArrayList<>();
    for (Curve curve : curves) {
      int last = curve.x().length - 1;
      told.add(
          "%s %s after %s"
              .formatted(
                  (Glossary.name(curve.method()) + " " + curve.knob()).strip(),
                  ReportNumbers.error(curve.middle()[last]),
                  ReportNumbers.count(curve.x()[last])));
    }
    return "Worst relative error so far of the energy of a ball that bounces, against the number of bounces: "
        + String.join(", ", told)
        + ".";
  }
}
