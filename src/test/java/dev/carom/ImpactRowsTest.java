// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.ImpactRows;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The numbers in the rows of a log stand for the constants of public enums. */
class ImpactRowsTest {

  @Test
  void outcomesAreTheOrdinals() {
    assertThat(ImpactRows.BOUNCED).isEqualTo(Outcome.BOUNCED.ordinal());
    assertThat(ImpactRows.HALTED).isEqualTo(Outcome.HALTED.ordinal());
    assertThat(ImpactRows.SENSED).isEqualTo(Outcome.SENSED.ordinal());
    assertThat(ImpactRows.PASSED).isEqualTo(Outcome.PASSED.ordinal());
    assertThat(ImpactRows.JAMMED).isEqualTo(Outcome.JAMMED.ordinal());
    assertThat(ImpactRows.STOPPED).isEqualTo(Outcome.STOPPED.ordinal());
  }

  @Test
  void aPairIsOfCircles() {
    ImpactRows rows = new ImpactRows(1);
    rows.addPair(1, 2, 3);
    ImpactLog log = new ImpactLog(rows);
    assertThat(List.of(log.kind(0), log.feature(0), log.outcome(0)))
        .containsExactly(ObstacleKind.CIRCLE, Feature.CIRCLE, Outcome.BOUNCED);
  }
}
