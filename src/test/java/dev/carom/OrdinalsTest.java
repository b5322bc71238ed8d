// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.io.SceneRowKind;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.util.KindNumber;
import dev.carom.internal.util.Part;
import org.junit.jupiter.api.Test;

/** The numbers that stand for constants of public enums are their ordinals. */
class OrdinalsTest {

  @Test
  void responses() {
    assertThat(ContactFlags.BOUNCE).isEqualTo(Response.BOUNCE.ordinal());
    assertThat(ContactFlags.HALT).isEqualTo(Response.HALT.ordinal());
    assertThat(ContactFlags.SENSOR).isEqualTo(Response.SENSOR.ordinal());
    for (Response response : Response.values()) {
      assertThat(SceneRowKind.RESPONSES.get(response.ordinal()))
          .isEqualToIgnoringCase(response.name());
    }
  }

  @Test
  void kinds() {
    assertThat(Kind.values()).hasSize(4);
    assertThat(Kind.of(KindNumber.WALL)).isEqualTo(Kind.WALL);
    assertThat(Kind.of(KindNumber.LINE)).isEqualTo(Kind.LINE);
    assertThat(Kind.of(KindNumber.PEG)).isEqualTo(Kind.PEG);
    assertThat(Kind.of(KindNumber.CIRCLE)).isEqualTo(Kind.CIRCLE);
    assertThat(Kind.LINE.nameOf(3)).isEqualTo("line 3");
  }

  @Test
  void features() {
    assertThat(Feature.values()).hasSize(4);
    assertThat(Part.SIDE).isEqualTo(Feature.SIDE.ordinal());
    assertThat(Part.START).isEqualTo(Feature.START.ordinal());
    assertThat(Part.END).isEqualTo(Feature.END.ordinal());
    assertThat(Part.CIRCLE).isEqualTo(Feature.CIRCLE.ordinal());
  }
}
