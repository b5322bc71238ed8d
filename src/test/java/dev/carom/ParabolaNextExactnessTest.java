// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Falls;
import dev.carom.oracle.Draw;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.ParabolaContact;
import dev.carom.oracle.ParabolaFamily;
import dev.carom.oracle.ParabolaNextFamilies;
import dev.carom.oracle.ParabolaQuery;
import dev.carom.oracle.Part;
import java.util.List;
import java.util.Locale;
import java.util.StringJoiner;
import java.util.function.BiFunction;
import org.junit.jupiter.api.Test;

/**
 * Impacts after a contact under a constant acceleration, held to the oracle: the return to the
 * thing just hit, and later entries. No wrong decision, every time the correctly rounded one.
 *
 * <p>More queries, and others: {@code mvn -pl src test -Dtest=ParabolaNextExactnessTest
 * -Dcarom.queries=1000000 -Dcarom.seed=2}. Those of some families alone: {@code
 * -Dcarom.families=.*touching.*}. Prints a table.
 */
class ParabolaNextExactnessTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final long QUERIES = Long.getLong("carom.queries", 1_500);
  private static final long SEED = Long.getLong("carom.seed", 1);

  private static final String FAMILIES = System.getProperty("carom.families", ".*");

  private static long hits;

  /** An answer, given or true: a time, and for a hit on a line the part that is hit. */
  private record Answer(double time, Part part, int side) {}

  private static final Answer MISS = new Answer(NEVER, Part.NONE, 0);

  @Test
  void returnsAreTheTrueOnes() {
    judge(ParabolaNextFamilies.ofReturns(), ParabolaNextExactnessTest::judgeReturn);
  }

  @Test
  void laterEntriesAreTheTrueOnes() {
    judge(ParabolaNextFamilies.ofEntries(), ParabolaNextExactnessTest::judgeEntry);
  }

  /** Prints, and expects no failure; the judge returns a description of one, or an empty text. */
  private static void judge(
      List<ParabolaFamily> all, BiFunction<ParabolaQuery, Integer, String> judge) {
    List<ParabolaFamily> families =
        all.stream().filter(family -> family.name().matches(FAMILIES)).toList();
    StringJoiner table =
        new StringJoiner("\n", "\n", "\n").add("family  questions  hits  exact  wrong");
    StringJoiner failures = new StringJoiner("\n");
    long failed = 0;
    for (ParabolaFamily family : families) {
      Draw draw = new Draw(SEED * 0x9E3779B97F4A7C15L ^ family.name().hashCode());
      long asked = PrecisionCounter.PARABOLAS.count();
      long exact = PrecisionCounter.EXACT_PARABOLAS.count();
      hits = 0;
      int wrong = 0;
      for (int i = 0; i < Math.max(1, QUERIES / families.size()); i++) {
        String failure = judge.apply(family.next(draw), i);
        wrong += failure.isEmpty() ? 0 : 1;
        if (wrong == 1 && !failure.isEmpty()) {
          failures.add(family.name() + ", query " + i + ": " + failure);
        }
      }
      failed += wrong;
      table.add(
          String.format(
              Locale.ROOT,
              "%-32s %6d %6d %6d %4d",
              family.name(),
              PrecisionCounter.PARABOLAS.count() - asked,
              hits,
              PrecisionCounter.EXACT_PARABOLAS.count() - exact,
              wrong));
    }
    System.out.println(table);
    assertThat(failed).as(failures.toString()).isZero();
  }

  private static String judgeReturn(ParabolaQuery query, int number) {
    return compare(query, truth(query, query.truthOfReturn()), askReturn(query), "");
  }

  /** After one of the times around the entries. */
  private static String judgeEntry(ParabolaQuery query, int number) {
    double first = query.truthAfter(-1).time();
    double s =
        switch (number % 8) {
          case 0 -> -1;
          case 1 -> 0;
          case 2 -> Math.nextDown(first);
          case 3 -> Math.nextUp(first);
          case 4 -> Math.min(query.end(), 8) / (1 + number % 5);
          case 5 -> first < NEVER ? query.truthAfter(first).time() : NEVER;
          default -> first;
        };
    if (s == NEVER) {
      s = -1;
    }
    return compare(query, truth(query, query.truthAfter(s)), askEntry(query, s), " after " + s);
  }

  private static String compare(ParabolaQuery query, Answer truth, Answer said, String how) {
    hits += truth.time() < NEVER ? 1 : 0;
    return truth.equals(said)
        ? ""
        : query.hex() + "\n" + query + how + "\n  is   " + truth + "\n  said " + said;
  }

  private static Answer truth(ParabolaQuery query, ParabolaContact contact) {
    double time = contact.time();
    if (time == NEVER) {
      return MISS;
    }
    if (query.straight() instanceof PairQuery) {
      return new Answer(time, Part.CIRCLE, 0);
    }
    double[] n = query.straight().numbers();
    int side = 0;
    if (contact.part() == Part.SIDE) {
      double left = contact.normal().x().near() * (n[1] - n[3]);
      side = left + contact.normal().y().near() * (n[2] - n[0]) > 0 ? 1 : -1;
    }
    return new Answer(time, contact.part(), side);
  }

  private static Answer askReturn(ParabolaQuery query) {
    double end = query.end();
    if (query.straight() instanceof PairQuery q) {
      double time =
          Falls.returnToDisk(
              q.x1(),
              q.y1(),
              q.vx1(),
              q.vy1(),
              query.gx(),
              query.gy(),
              q.x2(),
              q.y2(),
              q.vx2(),
              q.vy2(),
              end);
      return time < NEVER ? new Answer(time, Part.CIRCLE, 0) : MISS;
    }
    double time = Falls.returnToLine(query.numbers(end));
    return time == NEVER ? MISS : answer(time, Falls.contactOfReturn(query.numbers(time)));
  }

  private static Answer askEntry(ParabolaQuery query, double s) {
    double end = query.end();
    if (query.straight() instanceof PairQuery) {
      double time = Falls.timeOfDiskAfter(query.numbers(s, end));
      return time < NEVER ? new Answer(time, Part.CIRCLE, 0) : MISS;
    }
    double time = Falls.timeOfLineAfter(query.numbers(s, end));
    return time == NEVER ? MISS : answer(time, Falls.contact(query.numbers(time)));
  }

  private static Answer answer(double time, int contact) {
    return switch (Contact.withoutTime(contact)) {
      case Contact.START -> new Answer(time, Part.START, 0);
      case Contact.END -> new Answer(time, Part.END, 0);
      case Contact.LEFT -> new Answer(time, Part.SIDE, 1);
      default -> new Answer(time, Part.SIDE, -1);
    };
  }
}
