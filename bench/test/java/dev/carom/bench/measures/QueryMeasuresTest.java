// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static dev.carom.bench.measures.Found.reason;
import static dev.carom.bench.measures.Found.value;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.bench.methods.LineContender;
import dev.carom.bench.results.Row;
import dev.carom.oracle.Contact;
import dev.carom.oracle.SegmentQuery;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class QueryMeasuresTest {

  /** A circle of radius 5 flies at 10 towards a line at x = 50, and touches it at x = 45. */
  private static Contact truthFrom(double x) {
    return new SegmentQuery(50, 0, 50, 100, x, 40, 5, 10, 0, 1).truth();
  }

  static List<String> classes() {
    return Queries.classes();
  }

  @Test
  void answersAreCounted() {
    Contact half = truthFrom(40);
    Contact none = truthFrom(30);
    AnswerErrors errors = new AnswerErrors();
    errors.add(half, 0.5);
    errors.add(half, 0.5 + 3 * Math.ulp(0.5));
    errors.add(half, Double.POSITIVE_INFINITY);
    errors.add(half, Double.NaN);
    errors.add(none, Double.POSITIVE_INFINITY);
    errors.add(none, 0.9);
    errors.add(none, Double.NaN);
    // Touching at the start: right, and no time to have an error in ulps of.
    errors.add(truthFrom(45), 0);

    List<Row> rows = errors.rows(QueryPart.trial("some", LineContender.byId("plain"), -1));

    assertThat(value(rows, "decisions_missed", "count")).isEqualTo(2);
    assertThat(value(rows, "decisions_false", "count")).isEqualTo(2);
    assertThat(value(rows, "decisions_total", "count")).isEqualTo(8);
    assertThat(value(rows, "time_error", "max")).isEqualTo(3);
    assertThat(value(rows, "time_error", "median")).isZero();
    assertThat(rows).allSatisfy(row -> assertThat(row.scene()).isEqualTo("query:some"));
  }

  @ParameterizedTest
  @MethodSource("classes")
  void everyClassHasHitsAndTheyAreRepeatable(String name) {
    List<SegmentQuery> queries = Queries.draw(name, 500);

    assertThat(queries).hasSize(500).isEqualTo(Queries.draw(name, 500));
    assertThat(queries)
        .allSatisfy(q -> assertThat(q.end()).isGreaterThan(0).isLessThan(Double.POSITIVE_INFINITY));
    assertThat(queries.stream().filter(q -> q.truth().hit()).count()).isGreaterThan(20);
  }

  @Test
  void theReplaysHaveEnoughQuestions() {
    assertThat(Queries.draw(Queries.REPLAY, 20_000)).hasSize(20_000).doesNotHaveDuplicates();
  }

  @ParameterizedTest
  @MethodSource("classes")
  void caromIsNeverWrong(String name) {
    List<Row> rows =
        new QueryPart(name, 500).run().stream().filter(r -> r.method().equals("carom")).toList();

    assertThat(value(rows, "decisions_missed", "count")).isZero();
    assertThat(value(rows, "decisions_false", "count")).isZero();
    if (!name.equals("overlapping")) {
      assertThat(value(rows, "time_error", "max")).isLessThanOrEqualTo(0.5);
    }
  }

  @Test
  void everyWayToAnswerFindsAPlainContact() {
    for (LineContender contender : LineContender.all()) {
      double time = contender.detector().time(40, 40, 5, 10, 0, 50, 0, 50, 100, 1);
      assertThat(time).as(contender.id()).isCloseTo(0.5, within(1e-2));
      assertThat(contender.detector().time(30, 40, 5, 10, 0, 50, 0, 50, 100, 1))
          .as(contender.id())
          .isInfinite();
    }
  }

  @Test
  void theClockTimesEveryClassInAnotherMachine() {
    List<Row> rows = new QueryTimePart(3, List.of("plain"), 1).rowsOf(LineContender.byId("plain"));

    assertThat(rows)
        .extracting(Row::scene)
        .hasSize(Queries.classes().size())
        .doesNotHaveDuplicates();
    assertThat(rows)
        .allSatisfy(
            row -> {
              assertThat(row.value()).isPositive();
              assertThat(row.fork()).isEqualTo(3);
            });
  }

  @Test
  void aClockThatFailsSaysWhy() {
    LineContender nobody = new LineContender("nobody", "nobody", "", null);

    assertThat(reason(new QueryTimePart(0, List.of("nobody"), 1).rowsOf(nobody)))
        .contains("nobody is no way to test");
  }
}
