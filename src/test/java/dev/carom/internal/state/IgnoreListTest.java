// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class IgnoreListTest {

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
    assertThat(jam.entries()).containsExactly(3, 100, 7);
    assertThat(jam.makesInert(7)).isTrue();
    assertThat(jam.makesInert(8)).isFalse();
  }

  @Test
  void keepsOnlyCircles() {
    int a = Codes.circle(0);
    int b = Codes.circle(1);
    assertThat(of(3, a, 7, b).ofCircles()).isEqualTo(of(a, b));
    assertThat(of(3, a - 1).ofCircles()).isNull();
    IgnoreList all = IgnoreList.crushedBy(of(a), b);
    assertThat(all.ofCircles()).isSameAs(all);
  }

  @Test
  void anEntryTellsItsCodeAndWhetherItCrushes() {
    int[] entries = IgnoreList.crushedBy(of(3), Codes.circle(7)).entries();
    assertThat(entries).hasSize(2);
    assertThat(IgnoreList.code(entries[0])).isEqualTo(3);
    assertThat(IgnoreList.crushes(entries[0])).isFalse();
    assertThat(IgnoreList.code(entries[1])).isEqualTo(Codes.circle(7));
    assertThat(IgnoreList.crushes(entries[1])).isTrue();
  }

  /** The left wall has the code 0. */
  @Test
  void tellsWhatIsInertFromWhatCrushed() {
    IgnoreList wall = of(Codes.LEFT);
    IgnoreList jam = IgnoreList.crushedBy(wall, 5);
    assertThat(jam.entries()).containsExactly(0, ~5);
    assertThat(IgnoreList.code(0)).isZero();
    assertThat(wall.hasCrushers()).isFalse();
    assertThat(jam.hasCrushers()).isTrue();
    assertThat(jam.isCrushedBy(5)).isTrue();
    assertThat(jam.isCrushedBy(Codes.LEFT)).isFalse();
    assertThat(jam.makesInert(5)).isFalse();
    assertThat(jam.concerns(5)).isTrue();
    assertThat(jam.concerns(Codes.LEFT)).isTrue();
    assertThat(jam.concerns(6)).isFalse();
  }

  /** A line keeps its code, circle i becomes circle i + 3. */
  @Test
  void numbersCirclesAnew() {
    IgnoreList jam = IgnoreList.crushedBy(of(5, Codes.circle(1)), Codes.circle(2));
    assertThat(jam.ofOtherCircles(i -> i + 3))
        .isEqualTo(IgnoreList.crushedBy(of(5, Codes.circle(4)), Codes.circle(5)));
  }

  @Test
  void forgetsAllThatCrushed() {
    IgnoreList jam = IgnoreList.crushedBy(IgnoreList.crushedBy(of(3), 5), Codes.circle(7));
    assertThat(jam.withoutCrushers()).isEqualTo(of(3));
    assertThat(IgnoreList.crushedBy(null, 5).withoutCrushers()).isNull();
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
    int circle = Codes.circle(7);
    MovingCircle m = new MovingCircle();
    m.stuck = 99;
    m.jam = IgnoreList.with(IgnoreList.with(null, Codes.line(0)), circle);
    assertThat(m.forget(Codes.line(0), 0)).isTrue();
    assertThat(m.jam.makesInert(Codes.line(0))).isFalse();
    assertThat(m.jam.makesInert(circle)).isTrue();
    assertThat(m.stuck).isEqualTo(99);
    m.forget(circle, 0);
    assertThat(m.jam).isNull();
    assertThat(m.stuck).isZero();
  }
}
