// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.series.Heaps;
import dev.carom.bench.series.ManyWorlds;
import java.util.Comparator;
import java.util.List;

/** Series that have a command of their own and no figure. */
public final class SeriesTables {

  private SeriesTables() {}

  /**
   * What heaps of circles cost, and balls among pegs: a row for each scene.
   *
   * @param results what was measured
   */
  public static ReportTable heaps(Results results) {
    return Column.table(
        Standing.ours(results, Heaps.SECOND),
        new Column("a scene of", s -> heap(s.scene())),
        Column.of("a simulated second", Heaps.SECOND, "mean", ReportNumbers::time),
        Column.of("impacts in it", Heaps.IMPACTS, "mean", ReportNumbers::count),
        Column.of("median frame", Heaps.FRAME, "median", ReportNumbers::time),
        Column.of("worst frame", Heaps.FRAME, "max", ReportNumbers::time),
        Column.of(
            "at rest at the end", Heaps.RESTING, "end", rest -> Math.round(100 * rest) + " %"));
  }

  private static String heap(String scene) {
    return scene.equals(Heaps.PLINKO)
        ? "50 balls that fall among 203 pegs"
        : "a heap of " + scene.substring(Heaps.HEAP.length());
  }

  /**
   * How many small worlds are played in a second: a row for each number of threads.
   *
   * @param results what was measured
   */
  public static ReportTable worlds(Results results) {
    List<Standing> all =
        Standing.of(results, ManyWorlds.SCENE, ManyWorlds.SPEED).stream()
            .sorted(Comparator.comparingInt(SeriesTables::threads))
            .toList();
    return Column.table(
        all,
        new Column("threads", s -> threads(s) == 1 ? "one thread" : threads(s) + " threads"),
        Column.of("worlds a second", ManyWorlds.SPEED, "median", ReportNumbers::count),
        Column.of("slowest round", ManyWorlds.SPEED, "min", ReportNumbers::count),
        Column.of("fastest round", ManyWorlds.SPEED, "max", ReportNumbers::count),
        new Column("times one thread", s -> ReportNumbers.ratio(speed(s) / speed(all.get(0)))));
  }

  private static int threads(Standing s) {
    return Integer.parseInt(s.setting().value());
  }

  private static double speed(Standing s) {
    return s.value(ManyWorlds.SPEED, "median");
  }
}
