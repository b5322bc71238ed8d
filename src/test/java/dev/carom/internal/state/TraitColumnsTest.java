// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Flags and filters of things by their numbers. */
class TraitColumnsTest {

  @Test
  void thingsHaveNoFlagsAndTheDefaultFilter() {
    TraitColumns none = new TraitColumns();
    assertThat(none.flags(7)).isZero();
    assertThat(none.filter(7)).isEqualTo(Filter.DEFAULT);
    none.setFlags(7, 0);
    none.setFilter(7, Filter.DEFAULT);
    assertThat(none.areFlagged() || none.areFiltered()).isFalse();
    assertThat(none.filters(7)).isNull();
  }

  @Test
  void eachHasItsOwn() {
    TraitColumns traits = new TraitColumns();
    traits.setFlags(3, 2);
    traits.setFilter(2, 5);
    assertThat(traits.areFlagged() && traits.areFiltered()).isTrue();
    for (int i = 0; i < 20; i++) {
      assertThat(traits.flags(i)).isEqualTo(i == 3 ? 2 : 0);
      assertThat(traits.filter(i)).isEqualTo(i == 2 ? 5 : Filter.DEFAULT);
    }
    traits.setFlags(3, 0);
    traits.setFlags(4, 1);
    traits.setFilter(9, 6);
    assertThat(new int[] {traits.flags(3), traits.flags(4)}).containsExactly(0, 1);
    assertThat(traits.filter(8)).isEqualTo(Filter.DEFAULT);
    assertThat(traits.filter(9)).isEqualTo(6);
  }

  @Test
  void aCopyIsAnotherOne() {
    TraitColumns traits = new TraitColumns();
    traits.setFlags(1, 2);
    traits.setFilter(0, 5);
    TraitColumns copy = traits.copy();
    copy.setFlags(1, 1);
    copy.setFilter(0, 6);
    assertThat(traits.flags(1)).isEqualTo(2);
    assertThat(traits.filter(0)).isEqualTo(5);
    TraitColumns some = traits.of(new int[] {1, 0});
    assertThat(new int[] {some.flags(0), some.flags(1)}).containsExactly(2, 0);
    assertThat(some.filters(2)).containsExactly(Filter.DEFAULT, 5);
  }

  @Test
  void filtersThatAreAllTheDefaultAreNone() {
    TraitColumns traits = new TraitColumns();
    traits.setFilter(2, 5);
    assertThat(traits.filters(2)).isNull();
    assertThat(traits.filters(3)).containsExactly(Filter.DEFAULT, Filter.DEFAULT, 5);
    assertThat(traits.filters(40)).hasSize(40).endsWith(Filter.DEFAULT);
  }
}
