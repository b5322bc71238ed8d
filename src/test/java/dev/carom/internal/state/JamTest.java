// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class JamTest {
  private static final int FIRST = 100;

  private static Jam of(int... codes) {
    Jam jam = null;
    for (int code : codes) {
      jam = Jam.with(jam, code);
    }
    return jam;
  }

  @Test
  void holdsEachCodeOnce() {
    Jam jam = of(3, 100, 3, 7, 100);
    assertThat(jam.codes()).containsExactly(3, 100, 7);
    assertThat(jam.makesInert(7)).isTrue();
    assertThat(jam.makesInert(8)).isFalse();
  }

  @Test
  void keepsOnlyCircles() {
    assertThat(Jam.ofCircles(of(3, 100, 7, 101), FIRST)).isEqualTo(of(100, 101));
    assertThat(Jam.ofCircles(of(3, 99), FIRST)).isNull();
    assertThat(Jam.ofCircles(null, FIRST)).isNull();
    Jam all = of(100, 101);
    assertThat(Jam.ofCircles(all, FIRST)).isSameAs(all);
  }

  @Test
  void equalsWhatHoldsTheSame() {
    assertThat(of(3, 4)).isEqualTo(of(3, 4)).hasSameHashCodeAs(of(3, 4));
    assertThat(of(3, 4)).isNotEqualTo(of(3, 5)).doesNotHaveSameHashCodeAs(of(3, 5));
    assertThat(of(3)).isNotEqualTo("3");
  }

  /** Else the rest would be hit where the flight began, at a time before the edit. */
  @Test
  void whatIsMovedIsThereAgainAndTheRestStaysInert() {
    int circle = Obstacles.CIRCLES + 7;
    Mover m = new Mover();
    m.stuck = 99;
    m.jam = Jam.with(Jam.with(null, Obstacles.WALLS), circle);
    assertThat(m.forget(Obstacles.WALLS, 0)).isTrue();
    assertThat(m.jam.makesInert(Obstacles.WALLS)).isFalse();
    assertThat(m.jam.makesInert(circle)).isTrue();
    assertThat(m.stuck).isEqualTo(99);
    m.forget(circle, 0);
    assertThat(m.jam).isNull();
    assertThat(m.stuck).isZero();
  }
}
