// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.carom.oracle.Answer;
import dev.carom.oracle.Family;
import dev.carom.oracle.Judge;
import dev.carom.oracle.Question;
import dev.carom.oracle.Tally;
import java.util.List;
import java.util.StringJoiner;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Counts for each family of questions: a table, and whether all answers were right. */
final class FamilyTallies {

  static final long SEED = Long.getLong("carom.seed", 1);

  private static final String FAMILIES = System.getProperty("carom.families", ".*");

  private FamilyTallies() {}

  /** The families that were chosen by {@code -Dcarom.families}; by default all. */
  static <Q extends Question> List<Family<Q>> chosen(Stream<Family<Q>> families) {
    return families.filter(family -> family.name().matches(FAMILIES)).toList();
  }

  /**
   * Judges a detector, several chunks at a time, prints a table and expects no failure. Each family
   * has its share of the questions, in chunks that each have their own seed.
   */
  static <Q extends Question> void judge(
      Function<Q, Answer> detector, List<Family<Q>> families, long questions, int chunk) {
    Judge<Q> judge = new Judge<>(detector);
    int chunks = (int) Math.max(1, questions / families.size() / chunk);
    StringJoiner table = new StringJoiner("\n", "\n", "\n").add(Tally.HEAD);
    StringJoiner failures = new StringJoiner("\n");
    Tally total = new Tally();
    for (Family<Q> family : families) {
      Tally tally =
          IntStream.range(0, chunks)
              .parallel()
              .mapToObj(k -> judge.judge(family, SEED * 1_000_000 + k, chunk))
              .reduce(new Tally(), Tally::plus);
      table.add(tally.row(family.name()));
      total = total.plus(tally);
      if (tally.failures() > 0) {
        failures.add(tally.firstFailure());
      }
    }
    System.out.println(table.add(total.row("all")));
    assertEquals(0, total.failures(), failures::toString);
    assertEquals(0, total.notNearest(), "times not rounded correctly");
  }

  /** The counts of a few questions of each family. */
  static <Q extends Question> Tally tally(
      Function<Q, Answer> detector, List<Family<Q>> families, int each) {
    Judge<Q> judge = new Judge<>(detector);
    return families.stream()
        .map(family -> judge.judge(family, SEED, each))
        .reduce(new Tally(), Tally::plus);
  }
}
