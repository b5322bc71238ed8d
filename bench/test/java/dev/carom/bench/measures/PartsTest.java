// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;

class PartsTest {

  @Test
  void idsAreUniqueAndAreFileNames() {
    List<String> ids = Parts.of(false).stream().map(Part::id).toList();

    assertThat(ids)
        .doesNotHaveDuplicates()
        .allMatch(id -> id.matches("[a-z0-9.-]+(/[a-z0-9.-]+)+"));
    assertThat(ids).contains("scene/base-1/poster", "scene/fast-1/carom");
  }

  @Test
  void theQuickOnesAreSomeOfAll() {
    List<String> all = Parts.of(false).stream().map(Part::id).toList();
    List<String> quick = Parts.of(true).stream().map(Part::id).toList();

    assertThat(new HashSet<>(all)).containsAll(quick);
    assertThat(quick).hasSizeLessThan(all.size());
  }

  @Test
  void everySceneIsTimedInFiveForksOrMore() {
    List<String> ids = Parts.of(false).stream().map(Part::id).toList();
    for (String scene : List.of("base-1", "base-2", "base-3", "base-1-r5", "radii", "fast-1")) {
      assertThat(ids)
          .filteredOn(id -> id.matches("time/" + scene + "/fork-\\d"))
          .hasSizeGreaterThanOrEqualTo(5);
    }
    assertThat(ids).filteredOn(id -> id.startsWith("query-time/")).hasSizeGreaterThanOrEqualTo(5);
  }
}
