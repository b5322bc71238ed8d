// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PassageTest {

  @Test
  void comesAsNearAsItDoesAndNotNearer() {
    Passage along = Passage.of(-10, 5, 10, 5);

    assertThat(along.comesNearer(-1, 0, 1, 0, 5)).as("the side").isFalse();
    assertThat(along.comesNearer(-1, 0, 1, 0, Math.nextUp(5.0))).isTrue();
    assertThat(along.comesNearer(0, 0, 0, 0, 5)).as("a point").isFalse();
    assertThat(along.comesNearer(0, 0, 0, 0, Math.nextUp(5.0))).isTrue();
    assertThat(along.comesNearer(13, 1, 20, -7, 5)).as("ends: 3, 4, 5").isFalse();
    assertThat(along.comesNearer(13, 1, 20, -7, Math.nextUp(5.0))).isTrue();
  }

  @Test
  void crossesFromSideToSideOnly() {
    assertThat(Passage.of(0, 1, 0, -1).crosses(-1, 0, 1, 0)).isTrue();
    assertThat(Passage.of(0, 1, 0, 0).crosses(-1, 0, 1, 0)).as("ends on it").isFalse();
    assertThat(Passage.of(0, 1, 0, -Double.MIN_VALUE).crosses(-1, 0, 1, 0)).isTrue();
    assertThat(Passage.of(2, 1, 2, -1).crosses(-1, 0, 1, 0)).as("past an end").isFalse();
    assertThat(Passage.of(0, 1, 0, -1).comesNearer(-1e9, 0, 1e9, 0, 1e-300)).isTrue();
  }

  @Test
  void isSeenFromAnotherFlight() {
    Passage first = Passage.of(0, 0, 10, 0);
    Passage second = Passage.of(1e17, 3, 10, 3);

    assertThat(first.seenFrom(second).comesNearer(0, 0, 0, 0, 3)).isFalse();
    assertThat(first.seenFrom(second).comesNearer(0, 0, 0, 0, Math.nextUp(3.0))).isTrue();
  }
}
