// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ConfinementTest {

  private static final double[] WALLS = {-10, 100, 20, 50};

  /** A disk of radius 2, whose centre may be at -8 to 98. */
  @ParameterizedTest
  @CsvSource({
    "50, 98, 98",
    "50, 98.00000000000001, 98.00000000000001",
    "50, 98.0000000001, 98",
    "50, 1e300, 98",
    "50, Infinity, 98",
    "50, -8, -8",
    "50, -8.000000000000002, -8.000000000000002",
    "50, -8.0000000001, -8",
    "50, -1e300, -8",
    "98.00000000000001, 99, 98",
    "99, 120, 120",
    "99, 1e300, 1e300",
    "99, -1e300, -8",
    "-9, -20, -20",
    "-9, 1e300, 98",
  })
  void whoBeganInsideOfAWallStaysThere(double start, double x, double reported) {
    assertThat(Confinement.x(WALLS, start, x, 2)).isEqualTo(reported);
  }

  @Test
  void eachAxisHasItsWalls() {
    assertThat(Confinement.y(WALLS, 30, 1e9, 2)).isEqualTo(48);
    assertThat(Confinement.y(WALLS, 30, -1e9, 2)).isEqualTo(22);
  }

  @Test
  void withoutBoundsAllStaysAsItIs() {
    assertThat(Confinement.x(null, 50, 1e300, 2)).isEqualTo(1e300);
    assertThat(Confinement.y(null, 50, -1e300, 2)).isEqualTo(-1e300);
  }
}
