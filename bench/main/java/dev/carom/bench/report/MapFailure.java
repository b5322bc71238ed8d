// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.results.Setting;
import dev.carom.bench.stability.CellOutcome;
import dev.carom.bench.stability.FailureMap;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** How the engine that is known best fails on a map, and from where on. */
final class MapFailure {

  private static final String ENGINE = "gdx-box2d";

  private static final Map<CellOutcome, String> WORDS =
      Map.of(
          CellOutcome.DRIFTED, "drifts",
          CellOutcome.FAR_OFF, "is more than a radius off",
          CellOutcome.LOST_SPEED, "gets the speed wrong",
          CellOutcome.ESCAPED, "lets circles out",
          CellOutcome.NO_ANSWER, "gives no answer");

  private final FailureMap map;
  private final List<MapTally> tallies;
  private final List<Double> x;

  /** Takes a map, all who played it, and its values from left to right. */
  MapFailure(FailureMap map, List<MapTally> tallies, Collection<Double> x) {
    this.map = map;
    this.tallies = tallies;
    this.x = List.copyOf(x);
  }

  /** Half of a title, with its separator; empty if the engine did not play or does not fail. */
  String title() {
    return tuned().flatMap(this::words).orElse("");
  }

  private Optional<MapTally> tuned() {
    return tallies.stream()
        .filter(MapTally::played)
        .filter(t -> t.setting().method().equals(ENGINE) && !Metrics.isDefault(t.setting()))
        .findFirst();
  }

  private Optional<String> words(MapTally tally) {
    return Stream.of(CellOutcome.values())
        .filter(outcome -> outcome != CellOutcome.RIGHT && tally.count(outcome) > 0)
        .max(Comparator.comparingInt(tally::count))
        .map(outcome -> words(tally, outcome) + "; ");
  }

  private String words(MapTally tally, CellOutcome worst) {
    String name = Glossary.name(new Setting(ENGINE, "").method());
    int cells = tally.outcomes().size();
    for (int from = 0; from < x.size(); from++) {
      int first = from;
      long all = IntStream.range(0, cells).filter(i -> i % x.size() >= first).count();
      long bad =
          IntStream.range(0, cells)
              .filter(i -> i % x.size() >= first && tally.outcomes().get(i) == worst)
              .count();
      if (from > 0 && 3 * bad >= 2 * all) {
        return "%s %s from %s on (%s)"
            .formatted(name, WORDS.get(worst), map.x().text().apply(x.get(from)), map.x().label());
      }
    }
    return "%s %s in %s of the cells"
        .formatted(name, WORDS.get(worst), StabilityWords.share(tally.count(worst), cells));
  }
}
