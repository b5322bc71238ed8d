// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class JournalTest {

  private final double[] state = {0, 1, 10, 11, 20, 21};
  private final int[] codes = {0, 1, 2, 10, 11, 12, 20, 21, 22};
  private final Agenda due = new Agenda(3);

  @Test
  void whatWasNotedIsPutBack() {
    Journal journal = new Journal(1, 2, 3);
    for (int i : new int[] {2, 0}) {
      due.set(i, i);
      journal.save(i, i, null, state, codes);
    }
    for (int i = 0; i < 3; i++) {
      due.set(i, 7);
    }
    double[] laterState = {7, 7, 7, 7, 7, 7};
    int[] laterCodes = {7, 7, 7, 7, 7, 7, 7, 7, 7};
    journal.restore(due, null, laterState, laterCodes);
    assertThat(laterState).containsExactly(0, 1, 7, 7, 20, 21);
    assertThat(laterCodes).containsExactly(0, 1, 2, 7, 7, 7, 20, 21, 22);
    assertThat(due.get(0)).isZero();
    assertThat(due.get(1)).isEqualTo(7);
    assertThat(due.get(2)).isEqualTo(2);
  }

  @Test
  void whatWasClearedOrPutBackIsForgotten() {
    Journal journal = new Journal(2, 2, 3);
    double[] laterState = {7, 7, 7, 7, 7, 7};
    int[] laterCodes = {7, 7, 7, 7, 7, 7, 7, 7, 7};
    journal.save(0, 0, null, state, codes);
    journal.clear();
    journal.restore(due, null, laterState, laterCodes);
    journal.save(1, 0, null, state, codes);
    journal.restore(due, null, state.clone(), codes.clone());
    journal.restore(due, null, laterState, laterCodes);
    assertThat(laterState).containsOnly(7);
    assertThat(laterCodes).containsOnly(7);
  }
}
