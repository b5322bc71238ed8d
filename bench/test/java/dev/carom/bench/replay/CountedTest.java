// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CountedTest {

  @Test
  void oneIsSingular() {
    assertThat(Counted.of(0, "circle")).isEqualTo("0 circles");
    assertThat(Counted.of(1, "circle")).isEqualTo("1 circle");
    assertThat(Counted.of(12_345, "circle")).isEqualTo("12,345 circles");
    assertThat(Counted.of(1, "query", "queries")).isEqualTo("1 query");
    assertThat(Counted.of(2, "query", "queries")).isEqualTo("2 queries");
  }
}
