// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static dev.carom.bench.measures.Found.reason;
import static dev.carom.bench.measures.Found.value;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.peers.Contenders;
import dev.carom.bench.replay.ReplayRun;
import dev.carom.bench.results.Row;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class TimePartTest {

  /** Figures are not looked at, so another run on the same machine does no harm. */
  @BeforeAll
  static void share() {
    System.setProperty("jmh.ignoreLock", "true");
  }

  private static TimePart part(int fork, Contender contender) {
    return new TimePart("base-1", fork, List.of(contender), 1, 0);
  }

  @Test
  void framesAreTimedInAnotherMachine() {
    List<Row> rows = part(0, Methods.CAROM).run();

    double median = value(rows, "frame_time", "median");
    assertThat(median).isPositive();
    assertThat(value(rows, "frame_time", "p5")).isLessThanOrEqualTo(median);
    assertThat(value(rows, "frame_time", "p99")).isGreaterThanOrEqualTo(median);
    double worst =
        rows.stream()
            .filter(row -> row.metric().equals("frame_raw"))
            .mapToDouble(Row::value)
            .max()
            .orElseThrow();
    assertThat(value(rows, "frame_time", "worst")).isEqualTo(worst);
    assertThat(rows).filteredOn(row -> row.metric().equals("frame_raw")).hasSize(600);
    assertThat(rows).allSatisfy(row -> assertThat(row.fork()).isZero());
  }

  @Test
  void whoLooksAtMuchPlaysFewFrames() {
    List<Row> rows = part(1, Methods.substeps(64)).run();

    assertThat(rows)
        .filteredOn(row -> row.stat().equals("median"))
        .extracting(Row::n)
        .containsExactly(60L);
    assertThat(rows).noneMatch(row -> row.metric().equals("frame_raw"));
  }

  @Test
  void whoCannotRunSaysWhy() {
    Contender absent = Drunkard.absent("no natives for this machine");

    List<Row> rows = part(2, absent).run();

    assertThat(reason(rows)).isEqualTo("no natives for this machine");
    assertThat(value(rows, "frame_time", "median")).isNaN();
  }

  @Test
  void eachRoundHasItsOwnOrder() {
    List<Contender> all = Contenders.all();
    HashSet<List<Contender>> orders = new HashSet<>();
    for (int round = 0; round < 5; round++) {
      List<Contender> order = ReplayRun.shuffled(all, round);
      assertThat(order).containsExactlyInAnyOrderElementsOf(all);
      orders.add(order);
    }
    assertThat(orders).hasSize(5);
  }
}
