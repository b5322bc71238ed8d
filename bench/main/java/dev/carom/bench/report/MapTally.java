// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.CellLimit;
import dev.carom.bench.stability.CellOutcome;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * The outcomes of all cells of a map.
 *
 * @param setting who played
 * @param coarse in how many cells it is right to 0.1 radius; NaN if not counted
 * @param played false of one that has no code for such scenes
 */
record MapTally(
    Setting setting,
    List<CellOutcome> outcomes,
    List<CellLimit> limits,
    double coarse,
    boolean played) {

  /** The more often right the better; where that is equal, the more often right to 0.1 radius. */
  static final Comparator<MapTally> BY_RIGHT =
      Comparator.comparingInt((MapTally t) -> t.count(CellOutcome.RIGHT))
          .thenComparingDouble(t -> Double.isNaN(t.coarse) ? 0 : t.coarse);

  /** How many cells are of a class. */
  int count(CellOutcome outcome) {
    return count(outcome::equals, limit -> true);
  }

  /** How many cells there are that doubles and events can do justice to. */
  int within() {
    return count(outcome -> true, CellLimit.NONE::equals);
  }

  /** How many of those are not right. */
  int wrongWithin() {
    return within() - count(CellOutcome.RIGHT::equals, CellLimit.NONE::equals);
  }

  int count(Predicate<CellOutcome> outcome, Predicate<CellLimit> limit) {
    return (int)
        IntStream.range(0, outcomes.size())
            .filter(i -> outcome.test(outcomes.get(i)) && limit.test(limits.get(i)))
            .count();
  }
}
