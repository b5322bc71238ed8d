// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EndpointTest {

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesWhatIsNotFinite(double bad) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Endpoint(bad, 0))
        .withMessage("x is " + bad + ": expected a finite number");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Endpoint(0, bad))
        .withMessage("y is " + bad + ": expected a finite number");
  }
}
