// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.charts.BarChart;
import dev.carom.bench.charts.BarChart.Bar;
import dev.carom.bench.charts.Panel;
import dev.carom.bench.charts.Style;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.series.ManyWorlds;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** How many small worlds are played in a second, by the number of threads. */
public final class WorldsFigures {

  private final Results results;

  /**
   * Takes what is shown.
   *
   * @param results what was measured
   */
  public WorldsFigures(Results results) {
    this.results = results;
  }

  /** The bars: one figure, or none if nothing was measured. */
  public List<Figure> figures() {
    List<Setting> settings = settings();
    if (settings.isEmpty()) {
      return List.of();
    }
    List<Bar> bars = new ArrayList<>();
    for (Setting setting : settings) {
      double factor = speed(setting) / speed(settings.get(0));
      String words = words(setting) + ": " + ReportNumbers.count(speed(setting)) + " a second";
      bars.add(new Bar(words, Style.BLUE, factor, ReportNumbers.ratio(factor) + " times"));
    }
    String title = "Worlds a second, against those on one thread";
    Setting most = settings.get(settings.size() - 1);
    String sentence =
        "A sweep of small worlds is %s times as fast on %s as on one"
            .formatted(ReportNumbers.ratio(speed(most) / speed(settings.get(0))), words(most));
    return List.of(
        new Figure(
            "worlds",
            "Many worlds",
            sentence,
            "Each world is a ball that falls among 198 pegs into one of 17 slots. Any number of threads gives the same bits.",
            sentence + ".",
            List.of(new Panel(title, new BarChart(title, bars).picture())),
            table()));
  }

  /** The numbers: a row for each number of threads. */
  public ReportTable table() {
    ReportTable.Builder table =
        new ReportTable.Builder(
            "threads", "worlds a second", "slowest and fastest round", "times one thread");
    List<Setting> settings = settings();
    for (Setting setting : settings) {
      table.row(
          words(setting),
          ReportNumbers.count(speed(setting)),
          ReportNumbers.count(value(setting, "min"))
              + " to "
              + ReportNumbers.count(value(setting, "max")),
          ReportNumbers.ratio(speed(setting) / speed(settings.get(0))));
    }
    return table.build();
  }

  private List<Setting> settings() {
    return results.settings(ManyWorlds.SCENE, ManyWorlds.SPEED).stream()
        .sorted(Comparator.comparingInt(WorldsFigures::threads))
        .toList();
  }

  private static int threads(Setting setting) {
    return Integer.parseInt(setting.knob().substring(ManyWorlds.THREADS.length()));
  }

  private static String words(Setting setting) {
    return threads(setting) == 1 ? "one thread" : threads(setting) + " threads";
  }

  private double speed(Setting setting) {
    return value(setting, "median");
  }

  private double value(Setting setting, String stat) {
    return results.value(ManyWorlds.SCENE, setting, ManyWorlds.SPEED, stat);
  }
}
