// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BounceChart;
import dev.carom.bench.charts.Curve;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Arrays;
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
    List<Curve> curves = new ArrayList<>();
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
      curves.add(new Curve(setting.method(), knob, x, errors, errors, errors));
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
    BounceChart chart = new BounceChart(caption(curves), Settings.marks(results), curves);
    return List.of(
        new Figure(
            "bounce",
            "A ball that bounces",
            title(curves),
            "A ball under gravity bounces elastically on a level floor: 23 px high, 38.4 frames a bounce. Its energy should not change. Shown is the worst error so far; each error is the mean over one bounce. At an error of 1 the ball lies on the floor, or bounces twice as high; a ceiling at 1,000 px ends the growth. An error of 0 stands below the break of the axis. Each engine bounces for a few seconds.",
            caption(curves),
            List.of(new Panel("", chart.picture())),
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

  private static String title(List<Curve> curves) {
    for (Curve curve : curves) {
      if (curve.method().equals(Metrics.OURS)) {
        int last = curve.x().length - 1;
        double error = curve.middle()[last];
        return "Within %s bounces the energy of Carom's ball is off by %s"
            .formatted(
                ReportNumbers.count(curve.x()[last]),
                error == 0 ? "less than a double shows" : "at most " + ReportNumbers.error(error));
      }
    }
    return "The energy of a ball that bounces";
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
