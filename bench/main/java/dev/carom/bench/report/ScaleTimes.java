// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.Curve;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import dev.carom.bench.results.Setting;
import dev.carom.bench.results.Spread;
import dev.carom.bench.series.Scale;
import dev.carom.bench.series.ScalePlan.Model;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;

/**
 * The times against the number of circles. A method that took too long in one virtual machine has
 * no time there, and none in larger scenes, where others may have gone on.
 */
final class ScaleTimes {

  /** The divisor of a time. */
  enum Per {
    FRAME("a frame"),
    IMPACT("an impact");

    final String words;

    Per(String words) {
      this.words = words;
    }
  }

  private final Results results;

  ScaleTimes(Results results) {
    this.results = results;
  }

  /** Whether anything was measured. */
  boolean isEmpty() {
    return results.scenes(Scale.TIME).isEmpty();
  }

  static String scene(Model model, double circles) {
    return prefix(model) + (int) circles;
  }

  private static String prefix(Model model) {
    return Scale.SCENE + model.label() + "=";
  }

  /** The lines of a model; at the last place of one that took too long it is NaN. */
  List<Curve> curves(Model model, Per per) {
    Map<Setting, TreeSet<Integer>> places = new LinkedHashMap<>();
    for (String scene : results.scenes(Scale.TIME)) {
      if (scene.startsWith(prefix(model))) {
        int at = circles(scene);
        for (Setting setting : Settings.of(results, scene, Scale.TIME)) {
          if (per != Per.IMPACT || impacts(scene, setting) > 0) {
            places.computeIfAbsent(setting, none -> new TreeSet<>()).add(at);
          }
        }
      }
    }
    List<Curve> curves = new ArrayList<>();
    places.forEach(
        (setting, all) -> {
          double[] x =
              all.headSet(end(model, setting), true).stream().mapToDouble(n -> n).toArray();
          curves.add(curve(model, setting, x, per));
        });
    return curves;
  }

  private static int circles(String scene) {
    return Integer.parseInt(scene.substring(scene.indexOf('=') + 1));
  }

  /** The smallest scene in which it took too long. */
  private int end(Model model, Setting setting) {
    return results.scenes(Scale.TIME).stream()
        .filter(scene -> scene.startsWith(prefix(model)) && isCut(scene, setting))
        .mapToInt(ScaleTimes::circles)
        .min()
        .orElse(Integer.MAX_VALUE);
  }

  private boolean isCut(String scene, Setting setting) {
    return results.spread(scene, setting, Scale.TIME, Scale.TIMED_OUT).isPresent();
  }

  /** Whether a row is of a scene that only some of the virtual machines came to. */
  boolean isBeyond(Row row) {
    if (!row.metric().equals(Scale.TIME)) {
      return false;
    }
    Setting setting = new Setting(row.method(), row.knob());
    for (Model model : Model.values()) {
      if (row.scene().startsWith(prefix(model))) {
        return circles(row.scene()) > end(model, setting);
      }
    }
    return false;
  }

  private Curve curve(Model model, Setting setting, double[] x, Per per) {
    double[][] values = new double[3][x.length];
    for (int i = 0; i < x.length; i++) {
      String scene = scene(model, x[i]);
      double share = per == Per.FRAME ? 1 : impacts(scene, setting);
      double[] times = times(scene, setting);
      for (int k = 0; k < times.length; k++) {
        values[k][i] = times[k] / share;
      }
    }
    return new Curve(setting.method(), setting.knob(), x, values[0], values[1], values[2]);
  }

  /**
   * How many circles a frame of so many nanoseconds has, between two measured sizes by a power law.
   *
   * @return with two digits, or that more are possible than were measured; empty if not measured
   */
  Optional<String> within(Model model, String method, double nanos) {
    for (Curve curve : curves(model, Per.FRAME)) {
      if (!curve.method().equals(method)) {
        continue;
      }
      for (int i = 1; i < curve.x().length; i++) {
        double below = curve.middle()[i - 1];
        double above = curve.middle()[i];
        if (below <= nanos && above > nanos) {
          double share = Math.log(nanos / below) / Math.log(above / below);
          double n = curve.x()[i - 1];
          double circles = n * Math.pow(curve.x()[i] / n, share);
          return Optional.of(
              ReportNumbers.count(new BigDecimal(circles).round(new MathContext(2)).doubleValue()));
        }
      }
      int last = curve.x().length - 1;
      if (curve.middle()[last] <= nanos) {
        return Optional.of("over " + ReportNumbers.count(curve.x()[last]));
      }
    }
    return Optional.empty();
  }

  /** Low, middle, high: over the virtual machines, or, if there is but one, over its rounds. */
  private double[] times(String scene, Setting setting) {
    Spread s =
        results
            .spread(scene, setting, Scale.TIME, "median")
            .filter(spread -> !isCut(scene, setting))
            .orElse(Spread.of(0, Double.NaN));
    return s.forks() > 1
        ? new double[] {s.low(), s.middle(), s.high()}
        : new double[] {
          results.value(scene, setting, Scale.TIME, "min"),
          s.middle(),
          results.value(scene, setting, Scale.TIME, "max")
        };
  }

  /** Not above 0 for a method that does not tell, or did not come so far. */
  double impacts(String scene, Setting setting) {
    return results.value(scene, setting, Scale.IMPACTS, "mean");
  }
}
