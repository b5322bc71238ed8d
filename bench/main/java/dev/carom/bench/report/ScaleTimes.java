// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Spread;
import dev.carom.bench.series.Scale;
import dev.carom.bench.series.ScalePlan.Model;
import java.util.List;
import java.util.Optional;

/**
 * The times against the number of circles. A method that took too long in one virtual machine has
 * no time there, and none in larger scenes, where others may have gone on.
 */
final class ScaleTimes {

  private ScaleTimes() {}

  /** The lines of a model; at the last place of one that took too long it is NaN. */
  static List<Curve> curves(Results results, Model model) {
    List<Standing> all = Curves.along(results, Scale.TIME, Scale.SCENE + model.label() + "=");
    List<Standing> cut = all.stream().filter(ScaleTimes::isCut).toList();
    return Curves.ofScenes(
        all.stream().filter(s -> cut.stream().noneMatch(end -> isBeyond(s, end))).toList(),
        ScaleTimes::times);
  }

  private static boolean isCut(Standing s) {
    return s.spread(Scale.TIME, Scale.TIMED_OUT).isPresent();
  }

  private static boolean isBeyond(Standing s, Standing end) {
    return s.setting().equals(end.setting()) && Curves.size(s.scene()) > Curves.size(end.scene());
  }

  /** Low, middle, high: over the virtual machines, or, if there is but one, over its rounds. */
  private static double[] times(Standing s) {
    Spread time =
        s.spread(Scale.TIME, "median")
            .filter(found -> !isCut(s))
            .orElse(Spread.of(0, Double.NaN, Double.NaN));
    return time.forks() > 1
        ? new double[] {time.low(), time.middle(), time.high()}
        : new double[] {s.value(Scale.TIME, "min"), time.middle(), s.value(Scale.TIME, "max")};
  }

  /**
   * How many circles a frame of so many nanoseconds has, between two measured sizes by a power law.
   *
   * @return with two digits, or that more are possible than were measured; empty if not measured
   */
  static Optional<String> within(Results results, Model model, String method, double nanos) {
    return curves(results, model).stream()
        .filter(curve -> curve.method().equals(method))
        .findFirst()
        .flatMap(curve -> within(curve, nanos));
  }

  private static Optional<String> within(Curve curve, double nanos) {
    double[] x = curve.x();
    double[] times = curve.middle();
    for (int i = 1; i < x.length; i++) {
      if (times[i - 1] <= nanos && times[i] > nanos) {
        double share = Math.log(nanos / times[i - 1]) / Math.log(times[i] / times[i - 1]);
        double circles = x[i - 1] * Math.pow(x[i] / x[i - 1], share);
        return Optional.of(
            ReportNumbers.count(Double.parseDouble(ReportNumbers.rounded(circles, 2))));
      }
    }
    return Optional.of(x[x.length - 1])
        .filter(most -> times[x.length - 1] <= nanos)
        .map(most -> "over " + ReportNumbers.count(most));
  }
}
