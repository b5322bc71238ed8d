// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.carom.internal.sweep.Falls;
import dev.carom.internal.sweep.Hit;
import dev.carom.oracle.Answer;
import dev.carom.oracle.Draw;
import dev.carom.oracle.Family;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.ParabolaFamilies;
import dev.carom.oracle.ParabolaNextFamilies;
import dev.carom.oracle.ParabolaQuery;
import dev.carom.oracle.Part;
import dev.carom.oracle.Question;
import dev.carom.oracle.Tally;
import dev.carom.oracle.Truth;
import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The promise of exactness for circles with a constant acceleration: no wrong decision, every time
 * the correctly rounded one, no normal beyond 1e-15, in generated queries of every family; also for
 * impacts after a contact, the return to the thing just hit, and later entries.
 *
 * <p>More queries, and others: {@code mvn -pl src test -Dtest=ParabolaExactnessTest
 * -Dcarom.queries=1000000 -Dcarom.seed=2}. Those of some families alone: {@code
 * -Dcarom.families=.*touching.*}. Prints a table. The oracle takes about 0.2 ms a query.
 */
class ParabolaExactnessTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final long QUERIES = Long.getLong("carom.queries", 3_050);
  private static final long NEXT_QUERIES = Long.getLong("carom.queries", 1_500);
  private static final int CHUNK = 50;

  private static List<Family<ParabolaQuery>> families() {
    return FamilyTallies.chosen(
        Stream.concat(ParabolaFamilies.all().stream(), ParabolaFamilies.ofMovingLines().stream()));
  }

  /** By the two forms of {@link SweptCircle}. */
  private static Answer ask(ParabolaQuery query) {
    return query.straight().ask(LibraryDetector.falling(query.gx(), query.gy()));
  }

  @Test
  void answersGeneratedQueries() {
    FamilyTallies.judge(ParabolaExactnessTest::ask, families(), QUERIES, CHUNK);
  }

  /** Defects of a detector: each must be seen in every answer that it spoils. */
  private enum Defect {
    TIME_TWO_ULPS_LATE {
      @Override
      Answer spoil(Answer a) {
        double time = Math.nextUp(Math.nextUp(a.time()));
        return new Answer(time, a.part(), a.nx(), a.ny());
      }
    },
    NO_END {
      @Override
      Answer spoil(Answer a) {
        return a.part() == Part.START || a.part() == Part.END ? Answer.MISS : a;
      }
    },
    ENDS_SWAPPED {
      @Override
      Answer spoil(Answer a) {
        Part other =
            switch (a.part()) {
              case START -> Part.END;
              case END -> Part.START;
              default -> a.part();
            };
        return new Answer(a.time(), other, a.nx(), a.ny());
      }
    },
    NO_HIT {
      @Override
      Answer spoil(Answer a) {
        return Answer.MISS;
      }
    },
    NORMAL_TURNED {
      @Override
      Answer spoil(Answer a) {
        return new Answer(a.time(), a.part(), a.nx() - 2e-15 * a.ny(), a.ny() + 2e-15 * a.nx());
      }
    };

    /** The answer of the detector with the defect, to what is a hit. */
    abstract Answer spoil(Answer answer);
  }

  @ParameterizedTest
  @EnumSource(Defect.class)
  void noDefectIsOverlooked(Defect defect) {
    long[] spoilt = new long[1];
    Tally tally =
        FamilyTallies.tally(
            query -> {
              Answer answer = ask(query);
              Answer spoiled = answer.part() == Part.NONE ? answer : defect.spoil(answer);
              spoilt[0] += spoiled.equals(answer) ? 0 : 1;
              return spoiled;
            },
            families(),
            3);
    assertEquals(spoilt[0], tally.failures());
    assertTrue(spoilt[0] > 30);
  }

  // What follows a contact.

  /**
   * What is hit next.
   *
   * @param after the time after which an entry counts; NaN for the return to what is touched
   */
  private record Next(ParabolaQuery query, double after) implements Question {

    @Override
    public Truth truth() {
      return Double.isNaN(after) ? query.truthOfReturn() : query.truthAfter(after);
    }

    @Override
    public boolean isFair() {
      return true;
    }

    @Override
    public String hex() {
      return query.hex() + ", after " + after;
    }

    /** By the sweep itself. The normal of an end or a disk is that of a rounded place. */
    Answer ask() {
      boolean isReturn = Double.isNaN(after);
      if (query.straight() instanceof PairQuery q) {
        double time =
            isReturn
                ? Falls.returnToDisk(
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
                    q.end())
                : Falls.timeOfDiskAfter(query.numbers(after, q.end()));
        return answer(time, Part.CIRCLE, 0);
      }
      double[] end = isReturn ? query.numbers(query.end()) : query.numbers(after, query.end());
      double time = isReturn ? Falls.returnToLine(end) : Falls.timeOfLineAfter(end);
      if (time == NEVER) {
        return Answer.MISS;
      }
      double[] at = query.numbers(time);
      int contact = isReturn ? Falls.contactOfReturn(at) : Falls.contact(at);
      return answer(time, Falls.part(contact), contact);
    }

    private Answer answer(double time, Part part, int contact) {
      if (time == NEVER) {
        return Answer.MISS;
      }
      if (part == Part.SIDE) {
        Hit hit = new Hit().of(Falls.line(query.numbers()), contact, time);
        return new Answer(time, part, hit.nx(), hit.ny());
      }
      Truth truth = truth();
      return truth.hit()
          ? new Answer(time, part, truth.normal().x().near(), truth.normal().y().near())
          : new Answer(time, part, 0, 0);
    }
  }

  @Test
  void returnsAreTheTrueOnes() {
    judge(ParabolaNextFamilies.ofReturns(), (query, d) -> new Next(query, Double.NaN));
  }

  @Test
  void laterEntriesAreTheTrueOnes() {
    judge(ParabolaNextFamilies.ofEntries(), ParabolaExactnessTest::entry);
  }

  private static void judge(
      List<Family<ParabolaQuery>> families, BiFunction<ParabolaQuery, Draw, Next> next) {
    FamilyTallies.judge(
        Next::ask,
        FamilyTallies.chosen(
            families.stream()
                .map(base -> new Family<>(base.name(), d -> next.apply(base.next(d), d)))),
        NEXT_QUERIES,
        (int) Math.max(1, Math.min(CHUNK, NEXT_QUERIES / families.size())));
  }

  /** After one of the times around the entries. */
  private static Next entry(ParabolaQuery query, Draw d) {
    double first = query.truthAfter(-1).time();
    double s =
        switch (d.whole(0, 7)) {
          case 0 -> -1;
          case 1 -> 0;
          case 2 -> Math.nextDown(first);
          case 3 -> Math.nextUp(first);
          case 4 -> Math.min(query.end(), 8) / d.whole(1, 5);
          case 5 -> first < NEVER ? query.truthAfter(first).time() : NEVER;
          default -> first;
        };
    return new Next(query, s == NEVER ? -1 : s);
  }
}
