// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static dev.carom.bench.measures.Found.value;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.results.Row;
import java.util.List;
import org.junit.jupiter.api.Test;

class RoundingPartTest {

  /** Rounding the start costs up to 1 unit, each impact of the frame about as much again. */
  @Test
  void anErrorIsAFewRoundings() {
    List<Row> rows = new RoundingPart("base-1").run();
    List<Row> ours = rows.stream().filter(row -> row.method().equals("carom")).toList();

    assertThat(value(ours, "frame_roundings", "max")).isBetween(0.5, 4.0);
    assertThat(value(ours, "frame_roundings", "median")).isLessThan(0.5);
    assertThat(value(ours, "frame_roundings", "above limit")).isZero();
    assertThat(ours).filteredOn(row -> row.n() == 60_000).hasSize(4);
    // The greatest conditioning of a frame is at least that of the worst circle.
    assertThat(value(ours, "frame_roundings", "max of frames"))
        .isBetween(0.01, value(ours, "frame_roundings", "max"));
    assertThat(value(ours, "frame_roundings", "impacts of worst")).isBetween(0.0, 5.0);
    assertThat(value(ours, "frame_roundings", "rounded places")).isBetween(0.0, 4.0);
  }
}
