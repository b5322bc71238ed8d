// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.CellOutcome;
import dev.carom.bench.stability.FailureMap;
import dev.carom.bench.stability.Survey;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;

/**
 * The outcomes of all cells of a map.
 *
 * @param setting who played
 * @param outcomes of each cell the number of its class
 * @param coarse in how many cells it is right to 0.1 radius; NaN if not counted
 * @param played false of one that has no code for such scenes
 */
record MapTally(
    FailureMap map, Setting setting, List<Integer> outcomes, double coarse, boolean played) {

  /** Between two shares. */
  static final String BAR = " | ";

  /** The more often right the better; where that is equal, the more often right to 0.1 radius. */
  static final Comparator<List<MapTally>> BY_RIGHT =
      Comparator.<List<MapTally>>comparingDouble(MapTally::part)
          .thenComparingDouble(all -> Math.max(0, coarse(all)));

  /** Those of a map; none if it was not played. */
  static List<MapTally> of(Results results, FailureMap map) {
    String scene = Survey.SCENE + map.name();
    List<Setting> cannot = results.settings(scene, ReportRun.FAILURE);
    return Standing.of(results, scene, Survey.OUTCOME).stream()
        .map(
            s ->
                new MapTally(
                    map,
                    s.setting(),
                    values(s, Survey.OUTCOME).stream().map(Double::intValue).toList(),
                    s.value(Survey.WITHIN, "0.1"),
                    !cannot.contains(s.setting())))
        .toList();
  }

  /** The numbers of all cells, or of a side. */
  static Collection<Double> values(Standing s, String metric) {
    return s.results().series(s.scene(), s.setting(), metric, Survey.CELL).values();
  }

  private long right() {
    return outcomes.stream().filter(outcome -> outcome == CellOutcome.RIGHT.ordinal()).count();
  }

  static int cells(Collection<MapTally> tallies) {
    return tallies.stream().mapToInt(tally -> tally.outcomes.size()).sum();
  }

  /** The part of cells that is right. */
  static double part(Collection<MapTally> tallies) {
    return (double) tallies.stream().mapToLong(MapTally::right).sum() / cells(tallies);
  }

  private static double coarse(Collection<MapTally> tallies) {
    return tallies.stream().mapToDouble(MapTally::coarse).sum();
  }

  /** That part in percent. */
  static String share(Collection<MapTally> tallies) {
    return ReportNumbers.share(part(tallies), 1);
  }

  /** The share of cells that are right to 0.001 radius, and that to 0.1. */
  static String shares(Collection<MapTally> tallies) {
    double coarse = coarse(tallies);
    return Double.isNaN(coarse)
        ? share(tallies)
        : share(tallies) + BAR + ReportNumbers.share(coarse, cells(tallies));
  }
}
