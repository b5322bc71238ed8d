// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** How far a path nearby is off, where that is known in closed form. */
class NearbyPathTest {

  @Test
  void startsAtTheDistanceOne() {
    NearbyPath path = new NearbyPath(3, 4);
    assertThat(path.log(7, 0, 0)).isZero();
    assertThat(path.log(7, 0, 2)).as("across").isCloseTo(Math.log(0.6), within(1e-15));
    assertThat(new NearbyPath(0, 0).log(7, 0, 0)).as("in any direction").isZero();
  }

  /**
   * Straight onto a round thing of radius 1 and back, at speed 1: a place off by x to the side
   * gains the speed 2 x there. With a time of 2^200 between two impacts each one multiplies x by
   * 2^201 and 1, so that ten of them are far beyond the doubles.
   */
  @Test
  void growsBeyondTheDoubles() {
    ImpactMap map = new ImpactMap(0, -1, 0, 0, 0, 1, 1, 1);
    NearbyPath path = new NearbyPath(1, 0);
    for (int impacts = 1; impacts <= 10; impacts++) {
      path.bounce(map);
      double expected = 201 * impacts * Math.log(2);
      assertThat(path.log(0x1p200, 0, 0)).isCloseTo(expected, within(1e-11));
      path.fly(0x1p200);
      assertThat(path.log(0, 0, 0)).isCloseTo(expected, within(1e-11));
    }
    path.join();
    assertThat(path.log(1, 0, 0)).isEqualTo(Double.NEGATIVE_INFINITY);
  }
}
