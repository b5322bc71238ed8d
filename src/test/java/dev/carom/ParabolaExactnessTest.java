// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Falls;
import dev.carom.internal.sweep.Hit;
import dev.carom.oracle.Answer;
import dev.carom.oracle.Judge;
import dev.carom.oracle.MovingLineQuery;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.ParabolaFamilies;
import dev.carom.oracle.ParabolaFamily;
import dev.carom.oracle.ParabolaQuery;
import dev.carom.oracle.Part;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.Tally;
import dev.carom.oracle.WallQuery;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The promise of exactness for circles with a constant acceleration: no wrong decision, every time
 * the correctly rounded one, no normal beyond 1e-15, in generated queries of every family.
 *
 * <p>More queries, and others: {@code mvn -pl src test -Dtest=ParabolaExactnessTest
 * -Dcarom.queries=1000000 -Dcarom.seed=2}. Those of some families alone: {@code
 * -Dcarom.families=.*touching.*}. Prints a table. The oracle takes about 0.2 ms a query.
 */
class ParabolaExactnessTest {
  private static final long QUERIES = Long.getLong("carom.queries", 3_050);
  private static final long SEED = Long.getLong("carom.seed", 1);
  private static final String FAMILIES = System.getProperty("carom.families", ".*");
  private static final int CHUNK = 50;

  private final Judge<ParabolaQuery> judge = new Judge<>(ParabolaExactnessTest::ask);

  /** Each family has its share of the queries, in chunks that each have their own seed. */
  @Test
  void answersGeneratedQueries() {
    int chunks = (int) Math.max(1, QUERIES / families().size() / CHUNK);
    FamilyTallies tallies = new FamilyTallies();
    for (ParabolaFamily family : families()) {
      tallies.add(
          family.name(),
          chunks,
          chunk -> judge.judge(family.name(), family::next, SEED * 1_000_000 + chunk, CHUNK));
    }
    tallies.assertNoFailure();
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
    Judge<ParabolaQuery> strict =
        new Judge<>(
            query -> {
              Answer answer = ask(query);
              Answer spoiled = answer.part() == Part.NONE ? answer : defect.spoil(answer);
              spoilt[0] += spoiled.equals(answer) ? 0 : 1;
              return spoiled;
            });
    Tally tally = new Tally();
    for (ParabolaFamily family : families()) {
      tally = tally.plus(strict.judge(family.name(), family::next, SEED, 3));
    }
    assertEquals(spoilt[0], tally.failures());
    assertTrue(spoilt[0] > 30);
  }

  private static List<ParabolaFamily> families() {
    return Stream.concat(ParabolaFamilies.all().stream(), ParabolaFamilies.ofMovingLines().stream())
        .filter(family -> family.name().matches(FAMILIES))
        .toList();
  }

  /**
   * {@link SweptCircle} in its two forms, which must agree to the bit. It has none for a moving
   * line: the sweep itself is asked.
   */
  private static Answer ask(ParabolaQuery query) {
    if (query.straight() instanceof MovingLineQuery) {
      return movingLine(query);
    }
    Vec2 g = new Vec2(query.gx(), query.gy());
    if (query.straight() instanceof SegmentQuery q) {
      return line(q, g);
    }
    return query.straight() instanceof PairQuery q
        ? pair(q, g)
        : bounds((WallQuery) query.straight(), g);
  }

  private static Answer movingLine(ParabolaQuery query) {
    double time = Falls.timeOfLine(query.numbers(query.end()));
    if (time == Double.POSITIVE_INFINITY) {
      return Answer.MISS;
    }
    int contact = Falls.contact(query.numbers(time));
    Hit hit = new Hit().of(Falls.line(query.numbers()), contact, time);
    return new Answer(time, part(contact), hit.nx(), hit.ny());
  }

  private static Part part(int contact) {
    return switch (Contact.withoutTime(contact)) {
      case Contact.START -> Part.START;
      case Contact.END -> Part.END;
      default -> Part.SIDE;
    };
  }

  private static Answer line(SegmentQuery q, Vec2 g) {
    SweptCircle circle = new SweptCircle(q.px(), q.py(), q.r(), q.vx(), q.vy(), g.x(), g.y());
    double time = circle.timeToLine(q.ax(), q.ay(), q.bx(), q.by(), q.end());
    return answer(time, circle.cast(new Line(q.ax(), q.ay(), q.bx(), q.by()), q.end()));
  }

  private static Answer pair(PairQuery q, Vec2 g) {
    SweptCircle first = new SweptCircle(q.x1(), q.y1(), q.r1(), q.vx1(), q.vy1(), g.x(), g.y());
    SweptCircle second = new SweptCircle(q.x2(), q.y2(), q.r2(), q.vx2(), q.vy2());
    Answer answer = answer(first.timeToCircle(second, q.end()), first.cast(second, q.end()));
    if (q.isPeg()) {
      double peg = first.timeToPeg(q.x2(), q.y2(), q.r2(), q.end());
      Answer same = answer(peg, first.cast(second.at(0), q.end()));
      assertEquals(answer, same, "the second circle at rest is a peg");
    }
    return answer;
  }

  private static Answer bounds(WallQuery q, Vec2 g) {
    SweptCircle circle = new SweptCircle(q.px(), q.py(), q.r(), q.vx(), q.vy(), g.x(), g.y());
    double time = circle.timeToBounds(q.xmin(), q.ymin(), q.xmax(), q.ymax(), q.end());
    Bounds bounds = new Bounds(q.xmin(), q.ymin(), q.xmax(), q.ymax());
    return answer(time, circle.cast(bounds, q.end()));
  }

  private static Answer answer(double time, Optional<Impact> impact) {
    double castTime = impact.map(Impact::time).orElse(Double.POSITIVE_INFINITY);
    assertEquals(time, castTime, "the hot and the friendly form differ in time");
    return impact
        .map(
            i -> new Answer(time, Part.valueOf(i.feature().name()), i.normal().x(), i.normal().y()))
        .orElse(Answer.MISS);
  }
}
