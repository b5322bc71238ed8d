// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SavedFlightsTest {

  private final SavedFlights states = new SavedFlights(new int[] {0, 4, 7});

  @Test
  void theLastMeetingThatACircleSensedIsKept() {
    states.putSensed(1, 5, 1e-20, 3);
    assertThat(states.sensedHead(1)).isEqualTo(5);
    assertThat(states.sensedTail(1)).isEqualTo(1e-20);
    assertThat(states.sensedPartner(1)).isEqualTo(3);
    assertThat(states.sensedHead(2)).isZero();
    assertThat(states.sensedTail(2)).isZero();
    assertThat(states.sensedPartner(2)).isZero();
  }

  @Test
  void soIsOneAtTimeZero() {
    states.putSensed(1, 0, 1e-320, 3);
    assertThat(states.sensedTail(1)).isEqualTo(1e-320);
    assertThat(states.sensedPartner(1)).isEqualTo(3);
  }

  /** So that equal worlds have equal states. */
  @Test
  void noneHasNeitherATailNorAPartner() {
    states.putSensed(1, -1, 1e-20, 3);
    assertThat(states.sensedHead(1)).isNegative();
    assertThat(states.sensedTail(1)).isZero();
    assertThat(states.sensedPartner(1)).isZero();
  }
}
