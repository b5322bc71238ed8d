// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class IgnoreListTest {
  private static final int FIRST = 100;

  private static IgnoreList of(int... codes) {
    IgnoreList jam = null;
    for (int code : codes) {
      jam = IgnoreList.with(jam, code);
    }
    return jam;
  }

  @Test
  void holdsEachCodeOnce() {
    IgnoreList jam = of(3, 100, 3, 7, 100);
    assertThat(jam.codes()).containsExactly(3, 100, 7);
    assertThat(jam.makesInert(7)).isTrue();
    assertThat(jam.makesInert(8)).isFalse();
  }

  @Test
  void keepsOnlyCircles() {
    assertThat(IgnoreList.ofCircles(of(3, 100, 7, 101), FIRST)).isEqualTo(of(100, 101));
    assertThat(IgnoreList.ofCircles(of(3, 99), FIRST)).isNull();
    assertThat(IgnoreList.ofCircles(null, FIRST)).isNull();
    IgnoreList all = of(100, 101);
    assertThat(IgnoreList.ofCircles(all, FIRST)).isSameAs(all);
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
    int circle = ObstacleTable.CIRCLES + 7;
    MovingCircle m = new MovingCircle();
    m.stuck = 99;
    m.jam = IgnoreList.with(IgnoreList.with(null, ObstacleTable.WALLS), circle);
    assertThat(m.forget(ObstacleTable.WALLS, 0)).isTrue();
    assertThat(m.jam.makesInert(ObstacleTable.WALLS)).isFalse();
    assertThat(m.jam.makesInert(circle)).isTrue();
    assertThat(m.stuck).isEqualTo(99);
    m.forget(circle, 0);
    assertThat(m.jam).isNull();
    assertThat(m.stuck).isZero();
  }
}
