// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.methods.RungCounts;
import dev.carom.bench.results.Row;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class RungPartTest {

  @BeforeAll
  static void count() {
    RungCounts.enable();
  }

  private static Map<String, Double> counts(List<Row> rows) {
    return rows.stream().collect(Collectors.toMap(Row::stat, Row::value));
  }

  @Test
  void plainDoublesDecideTheOrdinaryAndSumsWithoutRoundingTies() {
    Map<String, Double> ordinary = counts(RungPart.ofQuestions("q", Queries.draw("ordinary", 200)));
    Map<String, Double> ties = counts(RungPart.ofQuestions("q", Queries.draw("near-tie", 200)));

    assertThat(ordinary).containsEntry("asked", 200.0);
    assertThat(ordinary.get("double")).isGreaterThan(190);
    assertThat(ties.get("double-double")).isGreaterThan(20);
    assertThat(ties.get("exact")).isZero();
    assertThat(ties.get("double") + ties.get("double-double") + ties.get("exact")).isEqualTo(200);
  }

  @Test
  void framesAreJudgedByThePairsThatTheyLookAt() {
    Map<String, Double> frames = counts(RungPart.ofFrames("base-1", Subjects.scene("base-1"), 20));

    assertThat(frames.get("asked")).isGreaterThan(50);
    assertThat(frames.get("double")).isGreaterThan(0.99 * frames.get("asked"));
  }
}
