// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.Limit;
import dev.carom.bench.stability.Outcome;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * What became of all cells of a map.
 *
 * @param setting who played
 * @param outcomes by cell
 * @param limits by cell
 * @param played false of one that has no code for such scenes
 */
record Tally(Setting setting, List<Outcome> outcomes, List<Limit> limits, boolean played) {

  /** How many cells are of a class. */
  int count(Outcome outcome) {
    return count(outcome::equals, limit -> true);
  }

  /** How many cells there are that doubles and events can do justice to. */
  int within() {
    return count(outcome -> true, Limit.NONE::equals);
  }

  /** How many of those are not right. */
  int wrongWithin() {
    return within() - count(Outcome.RIGHT::equals, Limit.NONE::equals);
  }

  int count(Predicate<Outcome> outcome, Predicate<Limit> limit) {
    return (int)
        IntStream.range(0, outcomes.size())
            .filter(i -> outcome.test(outcomes.get(i)) && limit.test(limits.get(i)))
            .count();
  }
}
