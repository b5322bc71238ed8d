// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.jmh;

import static org.assertj.core.api.Assertions.assertThat;

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
      assertThat(queries.bounds()).isBetween(0.0, 1.0);
      hits += Double.isFinite(queries.lineEndpoint()) ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(4000);
  }
}
