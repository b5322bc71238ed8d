// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.carom.oracle.Tally;
import java.util.StringJoiner;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Counts for each family of queries: a table, and whether all answers were right. */
final class FamilyTallies {

  private final StringJoiner table = new StringJoiner("\n", "\n", "\n").add(Tally.HEAD);
  private final StringJoiner failures = new StringJoiner("\n");
  private Tally total = new Tally();

  /** Counts the queries of a family in chunks, several at a time. */
  void add(String family, int chunks, IntFunction<Tally> chunk) {
    Tally tally =
        IntStream.range(0, chunks).parallel().mapToObj(chunk).reduce(new Tally(), Tally::plus);
    table.add(tally.row(family));
    total = total.plus(tally);
    if (tally.failures() > 0) {
      failures.add(tally.firstFailure());
    }
  }

  /** Prints the table. */
  void assertNoFailure() {
    System.out.println(table.add(total.row("all")));
    assertEquals(0, total.failures(), failures::toString);
    assertEquals(0, total.notNearest(), "times not rounded correctly");
  }
}
