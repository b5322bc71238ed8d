// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.Codes;
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
    assertThat(ImpactRows.SETTLED).isEqualTo(Outcome.SETTLED.ordinal());
    assertThat(Outcome.values()).hasSize(7);
  }

  @Test
  void aPairIsOfCircles() {
    ImpactRows rows = new ImpactRows(1);
    rows.addPair(1, 2, 3);
    ImpactLog log = new ImpactLog(rows);
    assertThat(List.of(log.kind(0), log.feature(0), log.outcome(0)))
        .containsExactly(Kind.CIRCLE, Feature.CIRCLE, Outcome.BOUNCED);
  }

  @Test
  void aCircleSettlesOnASide() {
    ImpactRows rows = new ImpactRows(1);
    rows.add(2.5, 4, Codes.line(3), Feature.SIDE.ordinal());
    rows.set(10, 20, 0, 2, -1e-9);
    rows.setOutcome(ImpactRows.SETTLED);
    ImpactLog log = new ImpactLog(rows);
    assertThat(log.outcome(0)).isEqualTo(Outcome.SETTLED);
    assertThat(log.toString()).endsWith("line 3 SIDE, approach speed 5.0E-10, SETTLED");
  }
}
