// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;

class FlightTest {

  private static final Flight FLIGHT = new Flight(2, 10, 20, 3, -4, 0, 0);

  @Test
  void startsWhereItSays() {
    assertThat(FLIGHT.at(2)).isEqualTo(new Vec2(10, 20));
  }

  @Test
  void movesAlongItsVelocity() {
    assertThat(FLIGHT.at(4.5)).isEqualTo(new Vec2(17.5, 10));
    assertThat(FLIGHT.at(0)).isEqualTo(new Vec2(4, 28));
  }

  /** Where the product is rounded before the sum, (1 + 2^-30)^2 - (1 + 2^-29) comes out as 0. */
  @Test
  void roundsOnce() {
    double v = 1 + 0x1p-30;
    Flight flight = new Flight(0, -(1 + 0x1p-29), 0, v, 0, 0, 0);
    assertThat(flight.at(v)).isEqualTo(new Vec2(0x1p-60, 0));
  }

  @Test
  void aPlaceBeyondTheDoublesIsTheLargestOne() {
    Flight fast = new Flight(0, 0, 0, 1e308, -1e308, 0, 0);
    assertThat(fast.at(2)).isEqualTo(new Vec2(Double.MAX_VALUE, -Double.MAX_VALUE));
    assertThatIllegalArgumentException().isThrownBy(() -> FLIGHT.at(Double.NaN));
  }

  @Test
  void timeReversed() {
    Flight back = new Flight(0, 17.5, 10, -3, 4, 0, 0);
    assertThat(back.at(2.5)).isEqualTo(FLIGHT.at(2));
  }
}
