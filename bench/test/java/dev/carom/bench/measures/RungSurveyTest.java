// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class RungSurveyTest {

  private final List<RungShare> shares = RungSurvey.of(300, 1, () -> {});

  private RungShare share(String family) {
    return shares.stream().filter(s -> s.family().equals(family)).findFirst().orElseThrow();
  }

  @Test
  void ordinaryQueriesAreAnsweredByTheLowestRungs() {
    RungShare uniform = share("seg_uniform");

    assertThat(uniform.queries()).isEqualTo(300);
    assertThat(uniform.plain()).isGreaterThanOrEqualTo(297);
    assertThat(uniform.times()).isPositive();
    assertThat(uniform.exactTimes()).isZero();
  }

  @Test
  void tiesClimbOneRungAndFewFurther() {
    for (String family : List.of("seg_lattice", "circ_near_graze")) {
      assertThat(share(family).doubleDouble()).as(family).isGreaterThan(30);
    }
    assertThat(share("seg_lattice").exact()).isBetween(1L, 5L);
  }

  @Test
  void aSeedAlwaysGivesTheSameCounts() {
    assertThat(RungSurvey.of(300, 1, () -> {})).isEqualTo(shares);
    assertThat(RungSurvey.of(300, 2, () -> {})).isNotEqualTo(shares);
  }
}
