// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FallTimesTest {

  /** It slides away from an end at speed 10, is pulled back by 10, and is there after 2. */
  @ParameterizedTest
  @ValueSource(doubles = {-1e-15, -1e-13, -1e-12, -1e-9, 0})
  void aSlideComesBackToTheEndAtWhichItBegan(double fromEnd) {
    assertThat(FallTimes.reaches(fromEnd, -10, 10)).isCloseTo(2, within(1e-9));
  }
}
