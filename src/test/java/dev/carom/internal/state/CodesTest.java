// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.util.KindNumber;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CodesTest {

  @ParameterizedTest
  @ValueSource(ints = {KindNumber.WALL, KindNumber.LINE, KindNumber.PEG, KindNumber.CIRCLE})
  void aCodeTellsItsKindAndItsIndex(int kind) {
    int last = Codes.limit(kind) - 1;
    for (int i : new int[] {0, 1, last - 1, last}) {
      int code = Codes.of(kind, i);
      assertThat(Codes.kind(code)).isEqualTo(kind);
      assertThat(Codes.index(code)).isEqualTo(i);
      assertThat(Codes.isWall(code)).isEqualTo(kind == KindNumber.WALL);
      assertThat(Codes.isLine(code)).isEqualTo(kind == KindNumber.LINE);
      assertThat(Codes.isCircle(code)).isEqualTo(kind == KindNumber.CIRCLE);
    }
  }

  @Test
  void theRangesFollowEachOther() {
    assertThat(Codes.of(KindNumber.WALL, 0)).isZero();
    for (int kind = KindNumber.WALL; kind < KindNumber.CIRCLE; kind++) {
      assertThat(Codes.of(kind, Codes.limit(kind) - 1) + 1).isEqualTo(Codes.of(kind + 1, 0));
    }
    assertThat(Codes.of(KindNumber.CIRCLE, Codes.limit(KindNumber.CIRCLE) - 1))
        .isEqualTo(Integer.MAX_VALUE);
  }

  @Test
  void eachKindHasAShortForm() {
    assertThat(Codes.line(7)).isEqualTo(Codes.of(KindNumber.LINE, 7));
    assertThat(Codes.peg(7)).isEqualTo(Codes.of(KindNumber.PEG, 7));
    assertThat(Codes.circle(7)).isEqualTo(Codes.of(KindNumber.CIRCLE, 7));
    assertThat(Codes.slot(Codes.circle(7))).isEqualTo(7);
  }

  @Test
  void whatIsNoCodeIsNoneOfThoseThatAreLookedUp() {
    assertThat(Codes.isLine(-1)).isFalse();
    assertThat(Codes.isCircle(-1)).isFalse();
  }

  @Test
  void aWallTellsItsAxisAndWhichWayItFaces() {
    assertThat(List.of(Codes.LEFT, Codes.RIGHT)).allMatch(Codes::isVertical);
    assertThat(List.of(Codes.BOTTOM, Codes.TOP)).noneMatch(Codes::isVertical);
    assertThat(List.of(Codes.LEFT, Codes.BOTTOM))
        .allMatch(wall -> Codes.isLower(wall) && Codes.inwards(wall) == 1);
    assertThat(List.of(Codes.RIGHT, Codes.TOP))
        .allMatch(wall -> !Codes.isLower(wall) && Codes.inwards(wall) == -1);
  }
}
