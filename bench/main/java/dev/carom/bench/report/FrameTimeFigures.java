// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.FrameStripsChart;
import dev.carom.bench.charts.FrameStripsChart.Strip;
import dev.carom.bench.replay.Budget;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** All frame times of a replay of each method, against the budget. */
final class FrameTimeFigures {

  private static final double BUDGET = 1e6 * Budget.MILLIS;

  /** A strip narrower than this is not seen. */
  private static final int MOST_STRIPS = 12;

  private final Results results;

  FrameTimeFigures(Results results) {
    this.results = results;
  }

  List<Figure> figures() {
    List<Figure> figures = new ArrayList<>();
    for (String scene : results.scenes(Metrics.FRAME_RAW)) {
      List<Strip> all = strips(scene);
      int charts = (all.size() + MOST_STRIPS - 1) / MOST_STRIPS;
      int each = (all.size() + charts - 1) / charts;
      for (int i = 0; i < charts; i++) {
        int to = Math.min(all.size(), (i + 1) * each);
        figures.add(figure(scene, i == 0 ? "" : "-" + (i + 1), all.subList(i * each, to)));
      }
    }
    return figures;
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

  private Figure figure(String scene, String number, List<Strip> strips) {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "setting", "frames", "median", "95 %", "99 %", "worst", "over the budget");
    List<String> over = new ArrayList<>();
    for (Strip strip : strips) {
      double[] sorted = strip.nanos().clone();
      Arrays.sort(sorted);
      int n = sorted.length;
      long missed = Arrays.stream(sorted).filter(t -> t > BUDGET).count();
      String name = (strip.method() + " " + strip.knob()).strip();
      table.row(
          name,
          ReportNumbers.count(n),
          ReportNumbers.time(rank(sorted, 0.5)),
          ReportNumbers.time(rank(sorted, 0.95)),
          ReportNumbers.time(rank(sorted, 0.99)),
          ReportNumbers.time(sorted[n - 1]),
          ReportNumbers.failures((double) missed, n));
      if (missed > 0) {
        over.add(name + " (" + missed + " of " + n + ")");
      }
    }
    String title =
        over.isEmpty()
            ? "All frames of all methods are within the budget of 16.67 ms"
            : "Frames over the budget of 16.67 ms: " + String.join(", ", over);
    FrameStripsChart chart =
        new FrameStripsChart(
            title,
            "Scene "
                + scene
                + ": every frame of one replay by the most accurate setting of each method. Lines: median and 95 %.",
            Settings.marks(results),
            strips,
            BUDGET);
    String caption = title + ". " + worst(strips);
    return new Figure(
        "frames-" + scene + number,
        "Frame times: " + scene,
        caption,
        chart::picture,
        table.build());
  }

  private static String worst(List<Strip> strips) {
    List<String> all = new ArrayList<>();
    for (Strip strip : strips) {
      double worst = Arrays.stream(strip.nanos()).max().orElseThrow();
      all.add(
          "%s %s"
              .formatted((strip.method() + " " + strip.knob()).strip(), ReportNumbers.time(worst)));
    }
    int n = strips.get(0).nanos().length;
    return "Worst of " + n + ": " + String.join(", ", all) + ".";
  }

  private static double rank(double[] sorted, double share) {
    return sorted[(int) Math.ceil(share * sorted.length) - 1];
  }
}
