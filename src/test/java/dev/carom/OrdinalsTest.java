// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** The numbers that stand for constants of public enums are their ordinals. */
class OrdinalsTest {

  @Test
  void responses() {
    assertThat(Traits.BOUNCE).isEqualTo(Response.BOUNCE.ordinal());
    assertThat(Traits.HALT).isEqualTo(Response.HALT.ordinal());
    assertThat(Traits.SENSOR).isEqualTo(Response.SENSOR.ordinal());
    for (Response response : Response.values()) {
      assertThat(SceneRowKind.RESPONSES.get(response.ordinal()))
          .isEqualToIgnoringCase(response.name());
    }
  }
}
