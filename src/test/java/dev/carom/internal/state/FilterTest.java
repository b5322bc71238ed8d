// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

class FilterTest {

  @Test
  void holdsACategoryAndAMask() {
    int[] some = {0, 1, -1, 6, Integer.MIN_VALUE, Integer.MAX_VALUE};
    for (int category : some) {
      for (int mask : some) {
        long filter = Filter.of(category, mask);
        assertThat(Filter.category(filter)).isEqualTo(category);
        assertThat(Filter.mask(filter)).isEqualTo(mask);
      }
    }
  }

  @Test
  void twoMeetIfEachMaskHasTheOthersCategory() {
    Random random = new Random(1);
    int meetings = 0;
    for (int i = 0; i < 10_000; i++) {
      int[] n = random.ints(4).map(bits -> bits & random.nextInt() & random.nextInt()).toArray();
      boolean meet = (n[0] & n[3]) != 0 && (n[2] & n[1]) != 0;
      meetings += meet ? 1 : 0;
      assertThat(Filter.meet(Filter.of(n[0], n[1]), Filter.of(n[2], n[3]))).isEqualTo(meet);
    }
    assertThat(meetings).isBetween(500, 9_500);
  }

  @Test
  void theLastBitCountsAsAnyOther() {
    int last = Integer.MIN_VALUE;
    assertThat(Filter.meet(Filter.of(last, 1), Filter.of(1, last))).isTrue();
    assertThat(Filter.meet(Filter.of(last, 1), Filter.of(1, ~last))).isFalse();
    assertThat(Filter.meet(Filter.of(1, ~last), Filter.of(last, 1))).isFalse();
  }
}
