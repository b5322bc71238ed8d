// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BarChart;
import dev.carom.bench.charts.BarChart.Bar;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.results.Results;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Which precision decided, by class of questions and by scene. */
final class RungShares {

  private static final String QUERY = "query:";

  private final Results results;

  RungShares(Results results) {
    this.results = results;
  }

  private double count(String scene, String stat) {
    return results.value(scene, Metrics.CAROM, Metrics.RUNGS, stat);
  }

  /** Nothing if it was not measured. */
  Optional<Panel> panel() {
    List<Bar> bars =
        results.scenes(Metrics.RUNGS).stream()
            .filter(scene -> count(scene, "asked") > 0)
            .map(this::bar)
            .toList();
    if (bars.isEmpty()) {
      return Optional.empty();
    }
    BarChart chart =
        new BarChart(sentence(), List.of("doubles", "double-double", "exact numbers"), bars);
    return Optional.of(new Panel("Which precision decided; the share of doubles", chart.picture()));
  }

  private Bar bar(String scene) {
    double asked = count(scene, "asked");
    double[] parts = {
      count(scene, "double") / asked,
      count(scene, "double-double") / asked,
      count(scene, "exact") / asked
    };
    String words =
        scene.startsWith(QUERY)
            ? "questions: " + Metrics.queryClass(scene)
            : "pairs looked at in " + scene;
    return new Bar(words, parts, percent(parts[0]));
  }

  /** Not 100 % unless it is all. */
  private static String percent(double share) {
    if (share == 1) {
      return "100 %";
    }
    int digits = share > 0.999 ? 4 : 1;
    double unit = Math.pow(10, -digits);
    return String.format(
        Locale.ROOT, "%." + digits + "f %%", Math.min(100 - unit, Math.max(0, 100 * share)));
  }

  /** The shares over the frames of all scenes, which are what a user sees. */
  String sentence() {
    double asked = 0;
    double doubles = 0;
    for (String scene : results.scenes(Metrics.RUNGS)) {
      if (!scene.startsWith(QUERY)) {
        asked += count(scene, "asked");
        doubles += count(scene, "double");
      }
    }
    return asked == 0
        ? "Precision was not measured."
        : "Of %s pairs of circle and line that frames looked at, plain doubles decided %s."
            .formatted(
                ReportNumbers.count(asked),
                doubles == asked ? "all" : "all but " + ReportNumbers.count(asked - doubles));
  }
}
