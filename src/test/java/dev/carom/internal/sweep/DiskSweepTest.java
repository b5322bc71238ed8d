// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class DiskSweepTest {

  @Test
  void mayMeetTellsWhoPassesOrGoesAway() {
    assertThat(DiskSweep.mayMeet(-5, 0, 1, 0, 2)).isTrue();
    assertThat(DiskSweep.mayMeet(-5, 2.1, 1, 0, 2)).isFalse();
    assertThat(DiskSweep.mayMeet(-5, 0, -1, 0, 2)).isFalse();
  }

  /**
   * The square of the radius alone would underflow, that of its product with the speed does not.
   */
  @Test
  void mayMeetHoldsForATinyRadiusAtAGreatSpeed() {
    assertThat(DiskSweep.mayMeet(-1, 0.5e-170, 1e150, 0, 1e-170)).isTrue();
    assertThat(DiskSweep.mayMeet(-1, 2e-100, 1e150, 0, 1e-170)).isFalse();
  }
}
