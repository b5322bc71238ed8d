// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.series.ManyWorlds;
import java.util.Comparator;
import java.util.List;

/** How many small worlds are played in a second, by the number of threads. */
public final class WorldsTable {

  private WorldsTable() {}

  /**
   * The numbers: a row for each number of threads.
   *
   * @param results what was measured
   */
  public static ReportTable of(Results results) {
    List<Standing> all =
        Standing.of(results, ManyWorlds.SCENE, ManyWorlds.SPEED).stream()
            .sorted(Comparator.comparingInt(WorldsTable::threads))
            .toList();
    return Column.table(
        all,
        new Column("threads", WorldsTable::words),
        Column.of("worlds a second", ManyWorlds.SPEED, "median", ReportNumbers::count),
        Column.of("slowest round", ManyWorlds.SPEED, "min", ReportNumbers::count),
        Column.of("fastest round", ManyWorlds.SPEED, "max", ReportNumbers::count),
        new Column("times one thread", s -> ReportNumbers.ratio(speed(s) / speed(all.get(0)))));
  }

  private static int threads(Standing s) {
    return Integer.parseInt(s.setting().value());
  }

  private static String words(Standing s) {
    return threads(s) == 1 ? "one thread" : threads(s) + " threads";
  }

  private static double speed(Standing s) {
    return s.value(ManyWorlds.SPEED, "median");
  }
}
