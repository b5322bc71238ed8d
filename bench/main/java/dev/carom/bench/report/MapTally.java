// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Results;
import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.CellLimit;
import dev.carom.bench.stability.CellOutcome;
import dev.carom.bench.stability.FailureMap;
import dev.carom.bench.stability.Survey;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;

/**
 * The outcomes of all cells of a map.
 *
 * @param setting who played
 * @param coarse in how many cells it is right to 0.1 radius; NaN if not counted
 * @param played false of one that has no code for such scenes
 */
record MapTally(
    FailureMap map,
    Setting setting,
    List<CellOutcome> outcomes,
    List<CellLimit> limits,
    double coarse,
    boolean played) {

  /** Between two shares. */
  static final String BAR = " | ";

  /** The more often right the better; where that is equal, the more often right to 0.1 radius. */
  static final Comparator<MapTally> BY_RIGHT =
      Comparator.comparingInt(MapTally::right)
          .thenComparingDouble(t -> Double.isNaN(t.coarse) ? 0 : t.coarse);

  /** Those of a map: of who plays it, then of who cannot; none if it was not played. */
  static List<MapTally> of(Results results, FailureMap map) {
    String scene = Survey.SCENE + map.name();
    List<Setting> cannot = results.settings(scene, ReportRun.FAILURE);
    List<CellLimit> limits =
        values(results, map, Survey.LIMIT).stream()
            .map(i -> CellLimit.values()[i.intValue()])
            .toList();
    return Standing.of(results, scene, Survey.OUTCOME).stream()
        .map(
            s ->
                new MapTally(
                    map,
                    s.setting(),
                    results
                        .series(scene, s.setting(), Survey.OUTCOME, Survey.CELL)
                        .values()
                        .stream()
                        .map(i -> CellOutcome.values()[i.intValue()])
                        .toList(),
                    limits,
                    s.value(Survey.WITHIN, "0.1"),
                    !cannot.contains(s.setting())))
        .sorted(Comparator.comparing(tally -> !tally.played))
        .toList();
  }

  /** Values of a metric that depends on the map only, not on the method. */
  static Collection<Double> values(Results results, FailureMap map, String metric) {
    String scene = Survey.SCENE + map.name();
    return results.settings(scene, metric).stream()
        .limit(1)
        .flatMap(any -> results.series(scene, any, metric, Survey.CELL).values().stream())
        .toList();
  }

  String name() {
    return Glossary.shortName(setting);
  }

  int cells() {
    return outcomes.size();
  }

  int right() {
    return count(CellOutcome.RIGHT);
  }

  /** How many cells are of a class. */
  int count(CellOutcome outcome) {
    return count((found, limit) -> found == outcome);
  }

  /** How many cells there are that doubles and events can do justice to. */
  int within() {
    return count((outcome, limit) -> limit == CellLimit.NONE);
  }

  /** How many of those are not right. */
  int wrongWithin() {
    return count((outcome, limit) -> limit == CellLimit.NONE && outcome != CellOutcome.RIGHT);
  }

  private int count(BiPredicate<CellOutcome, CellLimit> which) {
    return (int)
        IntStream.range(0, cells()).filter(i -> which.test(outcomes.get(i), limits.get(i))).count();
  }

  /** The share of cells that are right. */
  static String share(Collection<MapTally> tallies) {
    return share(tallies, tallies.stream().mapToDouble(MapTally::right).sum());
  }

  /** The share of cells that are right to 0.001 radius, and that to 0.1. */
  static String shares(Collection<MapTally> tallies) {
    double coarse = tallies.stream().mapToDouble(MapTally::coarse).sum();
    return share(tallies) + (Double.isNaN(coarse) ? "" : BAR + share(tallies, coarse));
  }

  private static String share(Collection<MapTally> tallies, double right) {
    return ReportNumbers.share(right, tallies.stream().mapToInt(MapTally::cells).sum());
  }
}
