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

  private final Results results;

  ScaleTimes(Results results) {
    this.results = results;
  }

  /** The lines of a model; at the last place of one that took too long it is NaN. */
  List<Curve> curves(Model model) {
    return Curves.ofScenes(
        Curves.along(results, Scale.TIME, prefix(model)).stream()
            .filter(s -> !isBeyond(s))
            .toList(),
        ScaleTimes::times);
  }

  private static String prefix(Model model) {
    return Scale.SCENE + model.label() + "=";
  }

  /** Whether a time is of a scene that only some of the virtual machines came to. */
  boolean isBeyond(Standing s) {
    if (!s.scene().startsWith(Scale.SCENE)) {
      return false;
    }
    String prefix = s.scene().substring(0, s.scene().indexOf('=') + 1);
    return results.scenes(Scale.TIME).stream()
        .filter(scene -> scene.startsWith(prefix) && Curves.size(scene) < Curves.size(s.scene()))
        .anyMatch(scene -> isCut(new Standing(results, scene, s.setting())));
  }

  private static boolean isCut(Standing s) {
    return s.spread(Scale.TIME, Scale.TIMED_OUT).isPresent();
  }

  /** Low, middle, high: over the virtual machines, or, if there is but one, over its rounds. */
  private static double[] times(Standing s) {
    Optional<Spread> median = s.spread(Scale.TIME, "median").filter(spread -> !isCut(s));
    if (median.isEmpty()) {
      return new double[] {Double.NaN, Double.NaN, Double.NaN};
    }
    Spread found = median.get();
    return found.forks() > 1
        ? new double[] {found.low(), found.middle(), found.high()}
        : new double[] {s.value(Scale.TIME, "min"), found.middle(), s.value(Scale.TIME, "max")};
  }

  /**
   * How many circles a frame of so many nanoseconds has, between two measured sizes by a power law.
   *
   * @return with two digits, or that more are possible than were measured; empty if not measured
   */
  Optional<String> within(Model model, String method, double nanos) {
    return curves(model).stream()
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
    return times[x.length - 1] <= nanos
        ? Optional.of("over " + ReportNumbers.count(x[x.length - 1]))
        : Optional.empty();
  }
}
