// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dev.carom.bench.jmh.ExactnessBenchmark;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlainSweptCircleTest {

  @ParameterizedTest
  @ValueSource(strings = {"seg_uniform", "circ_uniform"})
  void answersOrdinaryQueriesAsTheLibraryDoes(String family) {
    ExactnessBenchmark plain = benchmark(family);
    ExactnessBenchmark exact = benchmark(family);
    int hits = 0;
    for (int i = 0; i < 4096; i++) {
      double time = exact.exact();
      if (time == Double.POSITIVE_INFINITY) {
        assertThat(plain.plain()).isInfinite();
      } else {
        assertThat(plain.plain()).isCloseTo(time, within(1e-9));
        hits++;
      }
    }
    assertThat(hits).isGreaterThan(1000);
  }

  @Test
  void refusesWhatTheLibraryRefuses() {
    double big = Double.MAX_VALUE;
    assertThat(PlainSweptCircle.pair(big, 0, 1, -1, 0, -big, 0, 1, 1, 0, 1)).isInfinite();
    assertThatThrownBy(() -> PlainSweptCircle.pair(0, 0, -1, 1, 0, 9, 0, 1, 0, 0, 1))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> PlainSweptCircle.pair(0, 0, 1, 1, Double.NaN, 9, 0, 1, 0, 0, 1))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> PlainSweptCircle.line(0, 0, 1, 1, 0, 9, 0, 1, 1 / 0.0, 1))
        .isInstanceOf(IllegalArgumentException.class);
  }

  private static ExactnessBenchmark benchmark(String family) {
    ExactnessBenchmark benchmark = new ExactnessBenchmark();
    benchmark.family = family;
    benchmark.queries = 4096;
    benchmark.draw();
    return benchmark;
  }
}
