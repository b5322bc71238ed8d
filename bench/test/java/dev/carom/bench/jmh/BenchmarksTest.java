// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.ObstacleKind;
import org.junit.jupiter.api.Test;

class BenchmarksTest {

  /** A benchmark of a query that is answered otherwise than its name says measures nothing. */
  @Test
  void queriesAreWhatTheirNamesSay() {
    QueryBenchmark queries = new QueryBenchmark();
    int hits = 0;
    for (int i = 0; i < 4096; i++) {
      assertThat(queries.lineSide()).isBetween(0.0, 1.0);
      assertThat(queries.lineMiss()).isInfinite();
      assertThat(queries.peg()).isBetween(0.0, 1.0);
      assertThat(queries.pair()).isBetween(0.0, 1.0);
      assertThat(queries.sphere()).isBetween(0.0, 1.0);
      assertThat(queries.bounds()).isBetween(0.0, 1.0);
      hits += Double.isFinite(queries.lineEndpoint()) ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(4000);
  }

  @Test
  void editsAreWhatTheirNamesSay() throws Exception {
    EditBenchmark edits = new EditBenchmark();
    EditBenchmark.Steered steered = new EditBenchmark.Steered();
    steered.start(2);
    for (int i = 0; i < 20; i++) {
      assertThat(edits.steer(steered)).isTrue();
    }
    assertThat(steered.world.circleCount()).isEqualTo(400);
    assertThat(steered.world.idEnd(ObstacleKind.LINE)).isEqualTo(400);
    assertThat(steered.world.impacts().size()).isPositive();

    EditBenchmark.Thousand thousand = new EditBenchmark.Thousand();
    thousand.start();
    assertThat(edits.restoreAndStepAlone(thousand)).isTrue();
    assertThat(edits.restoreAndStepGas(thousand)).isTrue();
    assertThat(edits.snapshotAlone(thousand)).isNotEqualTo(thousand.ofAlone);
    assertThat(edits.restoreAlone(thousand).snapshot()).isEqualTo(thousand.ofAlone);
    assertThat(edits.restoreGas(thousand).circleCount()).isEqualTo(1000);
    assertThat(edits.snapshotGas(thousand)).isEqualTo(thousand.ofGas);
  }

  @Test
  void aTimelineIsAskedForWhatItHolds() throws Exception {
    EditBenchmark edits = new EditBenchmark();
    EditBenchmark.Recorded recorded = new EditBenchmark.Recorded();
    recorded.record();
    assertThat(edits.lookUp(recorded)).isBetween(0.0, 100 * 1400.0);
    assertThat(edits.lookUp(recorded)).isNotEqualTo(edits.lookUp(recorded));
    assertThat(recorded.timeline.end()).isEqualTo(600);
    assertThat(edits.frame(recorded)).isEqualTo(edits.frameRecorded(recorded));
    assertThat(recorded.recording.snapshot()).isEqualTo(recorded.plain.snapshot());
  }
}
