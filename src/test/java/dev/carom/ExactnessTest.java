// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.carom.oracle.Answer;
import dev.carom.oracle.Brinks;
import dev.carom.oracle.CaseFile;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.Judge;
import dev.carom.oracle.Query;
import dev.carom.oracle.Tally;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The promise of exactness against the oracle: no wrong decision, every time the correctly rounded
 * one, no normal beyond 1e-15, in the committed cases and in generated queries of every family.
 *
 * <p>More queries, and others: {@code mvn -pl src test -Dtest=ExactnessTest
 * -Dcarom.queries=10000000 -Dcarom.seed=2}. Prints a table.
 */
class ExactnessTest {
  /** Of each family. */
  private static final long QUERIES = Long.getLong("carom.queries", 46_000) / Families.all().size();

  private static final int CHUNK = (int) Math.min(500, QUERIES);

  private static Answer ask(Query query) {
    return query.ask(LibraryDetector.STRAIGHT);
  }

  static Stream<String> files() {
    return CaseFile.names().stream();
  }

  @ParameterizedTest
  @MethodSource("files")
  void answersTheCommittedCases(String name) {
    Judge<Query> judge = new Judge<>(ExactnessTest::ask);
    Tally tally = new Tally();
    CaseFile.read(name).forEach(row -> judge.judge(row.query(), tally, name));
    assertEquals(0, tally.failures(), tally::firstFailure);
    assertEquals(0, tally.notNearest(), "times not rounded correctly");
  }

  @Test
  void answersGeneratedQueries() {
    judge(Families.all());
  }

  @Test
  void answersQueriesAboutMovingLines() {
    judge(Families.ofMovingLines());
  }

  /** Where a bound of rounding errors that were a bit too small would let a wrong answer pass. */
  @Test
  void answersQueriesOnTheBrink() {
    judge(Brinks.all());
  }

  private static void judge(List<Family<Query>> families) {
    FamilyTallies.judge(ExactnessTest::ask, families, QUERIES * families.size(), CHUNK);
  }
}
