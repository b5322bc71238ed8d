// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.FrameStripsChart;
import dev.carom.bench.charts.FrameStripsChart.Strip;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** All frame times of a replay of each method, against the budget. */
final class FrameTimeFigures {

  private static final double BUDGET = 1e6 * Budget.MILLIS;

  private final Results results;

  FrameTimeFigures(Results results) {
    this.results = results;
  }

  List<Figure> figures() {
    Map<String, List<Strip>> all = new LinkedHashMap<>();
    results.scenes(Metrics.FRAME_RAW).forEach(scene -> all.put(scene, strips(scene)));
    all.values().removeIf(List::isEmpty);
    return all.isEmpty() ? List.of() : List.of(figure(all));
  }

  private List<Strip> strips(String scene) {
    List<Strip> strips = new ArrayList<>();
    for (Setting setting : Settings.finest(results, scene, Metrics.FRAME_RAW)) {
      Map<Integer, Double> series = results.series(scene, setting, Metrics.FRAME_RAW, "frame");
      double[] nanos =
          series.values().stream().mapToDouble(t -> t).filter(t -> !Double.isNaN(t)).toArray();
      if (nanos.length > 0) {
        strips.add(new Strip(setting.method(), Metrics.shortKnob(setting), nanos));
      }
    }
    return strips;
  }

  private Figure figure(Map<String, List<Strip>> scenes) {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "setting", "scene", "frames", "median", "95 %", "99 %", "worst", "over the budget");
    List<String> over = new ArrayList<>();
    List<String> told = new ArrayList<>();
    scenes.forEach(
        (scene, strips) -> {
          strips.forEach(strip -> row(table, scene, strip, over));
          told.add(scene + ": " + worst(strips));
        });
    String first = scenes.keySet().iterator().next();
    List<Strip> drawn = scenes.get(first).stream().filter(FrameTimeFigures::isDrawn).toList();
    String title =
        "%s's slowest of %s frames takes %s of the 16.67 ms allowed"
            .formatted(
                name(drawn.get(0)),
                ReportNumbers.count(drawn.get(0).nanos().length),
                ReportNumbers.time(Arrays.stream(drawn.get(0).nanos()).max().orElseThrow()));
    String budget =
        over.isEmpty()
            ? "No frame of any method exceeds the budget of 16.67 ms. "
            : "Frames over the budget of 16.67 ms: " + String.join(", ", over) + ". ";
    return new Figure(
        "frames",
        "All frame times",
        title,
        "Each dot is one frame%s, on a logarithmic scale. Thick line: median; thin line: the slowest. Dashed: 16.67 ms, all that 60 frames a second allow."
            .formatted(Scenes.size(first)),
        budget + String.join(" ", told),
        List.of(
            new Panel(
                "", new FrameStripsChart(title, Settings.marks(results), drawn, BUDGET).picture())),
        table.build());
  }

  private static boolean isDrawn(Strip strip) {
    return Settings.isDrawn(new Setting(strip.method(), strip.knob()));
  }

  private static void row(ReportTable.Builder table, String scene, Strip strip, List<String> over) {
    double[] sorted = strip.nanos().clone();
    Arrays.sort(sorted);
    int n = sorted.length;
    long missed = Arrays.stream(sorted).filter(t -> t > BUDGET).count();
    String name = name(strip);
    table.row(
        name,
        scene,
        ReportNumbers.count(n),
        ReportNumbers.time(rank(sorted, 0.5)),
        ReportNumbers.time(rank(sorted, 0.95)),
        ReportNumbers.time(rank(sorted, 0.99)),
        ReportNumbers.time(sorted[n - 1]),
        ReportNumbers.failures((double) missed, n));
    if (missed > 0) {
      over.add(name + " in " + scene + " (" + missed + " of " + n + ")");
    }
  }

  private static String name(Strip strip) {
    return (Glossary.name(strip.method()) + " " + strip.knob()).strip();
  }

  private static String worst(List<Strip> strips) {
    List<String> all = new ArrayList<>();
    for (Strip strip : strips) {
      double worst = Arrays.stream(strip.nanos()).max().orElseThrow();
      all.add("%s %s".formatted(name(strip), ReportNumbers.time(worst)));
    }
    int n = strips.get(0).nanos().length;
    return "Worst of " + n + ": " + String.join(", ", all) + ".";
  }

  private static double rank(double[] sorted, double share) {
    return sorted[(int) Math.ceil(share * sorted.length) - 1];
  }
}
