// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class HeapPartTest {

  private static Map<String, Double> measure(Contender contender, Scene scene, int frames) {
    return HeapPart.measure(new Trial("heap", contender), scene, frames).stream()
        .collect(Collectors.toMap(row -> row.metric() + " " + row.stat(), Row::value));
  }

  @Test
  void aHeapComesToRestWithoutOverlap() {
    Map<String, Double> carom = measure(Methods.CAROM, Subjects.scene(Subjects.HEAP), 300);

    assertThat(carom.get("heap_overlap max")).isLessThan(1e-9);
    assertThat(carom.get("heap_energy gained")).isLessThan(1e-3);
    assertThat(carom.get("heap_rest frame")).isBetween(100.0, 300.0);
  }

  /** 3 of 10 units over are 0.6 radii. */
  @Test
  void theDeepestOverlapCountsAndWhatMovesToTheEndIsNeverAtRest() {
    Scene scene =
        Scene.builder()
            .collide(false)
            .bounds(0, 0, 100, 100)
            .circle(20, 50, 5, 0, 1)
            .circle(27, 50, 5, 0, 1)
            .build();

    Map<String, Double> found = measure(Methods.TEXTBOOK_DOUBLE, scene, 5);

    assertThat(found.get("heap_overlap max")).isCloseTo(0.6, within(1e-12));
    assertThat(found.get("heap_rest frame")).isInfinite();
  }
}
