// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.carom.oracle.Answer;
import dev.carom.oracle.Brinks;
import dev.carom.oracle.CaseFile;
import dev.carom.oracle.Detector;
import dev.carom.oracle.Families;
import dev.carom.oracle.Family;
import dev.carom.oracle.Judge;
import dev.carom.oracle.MovingLineQuery;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.Part;
import dev.carom.oracle.Query;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.Tally;
import dev.carom.oracle.WallQuery;
import java.util.List;
import java.util.Optional;
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
  private static final long QUERIES = Long.getLong("carom.queries", 46_000);
  private static final long SEED = Long.getLong("carom.seed", 1);
  private static final int CHUNK = (int) Math.min(500, QUERIES / Families.all().size());

  private final Library library = new Library();
  private final Judge<Query> judge = new Judge<>(query -> query.ask(library));

  static Stream<String> files() {
    return CaseFile.names().stream();
  }

  @ParameterizedTest
  @MethodSource("files")
  void answersTheCommittedCases(String name) {
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

  /** Each family has its share of the queries, in chunks that each have their own seed. */
  private void judge(List<Family> families) {
    int chunks = (int) Math.max(1, QUERIES / Families.all().size() / CHUNK);
    FamilyTallies tallies = new FamilyTallies();
    for (Family family : families) {
      tallies.add(
          family.name(),
          chunks,
          chunk -> judge.judge(family.name(), family::next, SEED * 1_000_000 + chunk, CHUNK));
    }
    tallies.assertNoFailure();
  }

  /** {@link SweptCircle} as the judge sees it: its two forms, which must agree to the bit. */
  private static final class Library implements Detector {

    @Override
    public Answer line(SegmentQuery q) {
      double time =
          new SweptCircle(q.px(), q.py(), q.r(), q.vx(), q.vy())
              .timeToLine(q.ax(), q.ay(), q.bx(), q.by(), q.end());
      Line line = new Line(q.ax(), q.ay(), q.bx(), q.by());
      return answer(time, cast(q.px(), q.py(), q.r(), q.vx(), q.vy(), line, q.end()));
    }

    @Override
    public Answer movingLine(MovingLineQuery q) {
      double time =
          new SweptCircle(q.px(), q.py(), q.r(), q.vx(), q.vy())
              .timeToLine(q.ax(), q.ay(), q.bx(), q.by(), q.ux(), q.uy(), q.end());
      Line line = new Line(q.ax(), q.ay(), q.bx(), q.by());
      Circle circle = new Circle(q.px(), q.py(), q.r());
      Vec2 u = new Vec2(q.ux(), q.uy());
      return answer(time, new SweptCircle(circle, new Vec2(q.vx(), q.vy())).cast(line, u, q.end()));
    }

    @Override
    public Answer pair(PairQuery q) {
      double time =
          new SweptCircle(q.x1(), q.y1(), q.r1(), q.vx1(), q.vy1())
              .timeToCircle(new SweptCircle(q.x2(), q.y2(), q.r2(), q.vx2(), q.vy2()), q.end());
      Circle first = new Circle(q.x1(), q.y1(), q.r1());
      Circle second = new Circle(q.x2(), q.y2(), q.r2());
      Vec2 v1 = new Vec2(q.vx1(), q.vy1());
      Vec2 v2 = new Vec2(q.vx2(), q.vy2());
      Answer answer =
          answer(time, new SweptCircle(first, v1).cast(new SweptCircle(second, v2), q.end()));
      if (q.isPeg()) {
        assertEquals(answer, peg(q, second), "the second circle at rest is a peg");
      }
      return answer;
    }

    private static Answer peg(PairQuery q, Circle peg) {
      double time =
          new SweptCircle(q.x1(), q.y1(), q.r1(), q.vx1(), q.vy1())
              .timeToPeg(q.x2(), q.y2(), q.r2(), q.end());
      return answer(time, cast(q.x1(), q.y1(), q.r1(), q.vx1(), q.vy1(), peg, q.end()));
    }

    @Override
    public Answer bounds(WallQuery q) {
      double time =
          new SweptCircle(q.px(), q.py(), q.r(), q.vx(), q.vy())
              .timeToBounds(q.xmin(), q.ymin(), q.xmax(), q.ymax(), q.end());
      Bounds bounds = new Bounds(q.xmin(), q.ymin(), q.xmax(), q.ymax());
      return answer(time, cast(q.px(), q.py(), q.r(), q.vx(), q.vy(), bounds, q.end()));
    }

    private static Optional<Impact> cast(
        double px, double py, double r, double vx, double vy, Obstacle obstacle, double end) {
      return new SweptCircle(px, py, r, vx, vy).cast(obstacle, end);
    }

    private static Answer answer(double time, Optional<Impact> impact) {
      double castTime = impact.map(Impact::time).orElse(Double.POSITIVE_INFINITY);
      assertEquals(time, castTime, "the hot and the friendly form differ in time");
      return impact
          .map(i -> new Answer(time, part(i), i.normal().x(), i.normal().y()))
          .orElse(Answer.MISS);
    }

    private static Part part(Impact impact) {
      return Part.valueOf(impact.feature().name());
    }
  }
}
