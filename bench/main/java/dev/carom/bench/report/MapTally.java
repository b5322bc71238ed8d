// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.CellLimit;
import dev.carom.bench.stability.CellOutcome;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * The outcomes of all cells of a map.
 *
 * @param setting who played
 * @param played false of one that has no code for such scenes
 */
record MapTally(
    Setting setting, List<CellOutcome> outcomes, List<CellLimit> limits, boolean played) {

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
