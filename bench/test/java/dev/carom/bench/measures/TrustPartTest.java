// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.References;
import dev.carom.bench.reference.Truth;
import dev.carom.bench.results.Row;
import java.util.List;
import org.junit.jupiter.api.Test;

class TrustPartTest {

  private static double value(List<Row> rows, String metric, String stat) {
    return rows.stream()
        .filter(row -> row.metric().equals(metric) && row.stat().equals(stat))
        .mapToDouble(Row::value)
        .sum();
  }

  @Test
  void boundsOfAFallAreTold() {
    List<Row> rows = new TrustPart(References.FALLING).run();
    assertThat(value(rows, TrustPart.EXCEEDED, "count")).isZero();
    assertThat(value(rows, TrustPart.EXCEEDED, "of")).isBetween(10_000.0, 24_000.0);
    assertThat(value(rows, TrustPart.RATIO, "median")).isBetween(1.0, 100.0);
    assertThat(rows)
        .filteredOn(row -> row.stat().startsWith("p5@"))
        .hasSizeGreaterThan(8)
        .allMatch(
            row ->
                row.value() > Math.pow(10, Integer.parseInt(row.stat().substring("p5@".length()))));
  }

  /** Against the course of another scene: the errors exceed the bound. */
  @Test
  void errorsAboveTheBoundAreCounted() {
    Reference truth = Truth.of(scene(1e-6), 20, () -> {});
    List<Row> rows = new TrustPart("tilted").measure(scene(0), truth);
    assertThat(value(rows, TrustPart.EXCEEDED, "count")).isEqualTo(20);
    assertThat(value(rows, TrustPart.EXCEEDED, "of")).isEqualTo(20);
    assertThat(value(rows, TrustPart.RATIO, "median")).isLessThan(1e-3);
  }

  private static Scene scene(double off) {
    return Scene.builder().bounds(0, 0, 90, 90).circle(50 + off, 50, 2, 1, 0.3).build();
  }
}
