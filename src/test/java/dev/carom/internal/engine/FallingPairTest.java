// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.MovingCircle;
import org.junit.jupiter.api.Test;

/** Two circles, one above the other when the second flight begins, in any position and order. */
class FallingPairTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final CircleTable circles = CircleTable.colliding(2);
  private final FallingPair pair = new FallingPair(circles);

  /** The positions: mirrored, upside down, with the axes exchanged, and the order of the two. */
  private int position;

  /** The tail of the time at which the flight of the first begins. */
  private double early;

  FallingPairTest() {
    circles.allowGravity();
  }

  private void put(int i, double t, double y, double r, double vx, double vy, double gy) {
    MovingCircle m = new MovingCircle();
    double x = i == 0 ? 0 : 1;
    double mirror = (position & 1) == 0 ? 1 : -1;
    double up = (position & 2) == 0 ? 1 : -1;
    if ((position & 4) == 0) {
      m.start(i, mirror * x, up * y, r, mirror * vx, up * vy, 1);
      m.fall(0, up * gy);
    } else {
      m.start(i, up * y, mirror * x, r, up * vy, mirror * vx, 1);
      m.fall(up * gy, 0);
    }
    m.t = t;
    m.tl = i == 0 ? early : 0;
    circles.put(slot(i), m);
  }

  private int slot(int i) {
    return (position & 8) == 0 ? i : 1 - i;
  }

  private boolean start() {
    return pair.start(circles.state, 0, 1);
  }

  private void assertTime(double time, double expected) {
    assertThat(time).isCloseTo(expected, within(1e-15));
  }

  /** At 1 the first is at (1, 1), at (1, 0); from 10 above it the gap of 7 closes by 4 t + t^2. */
  @Test
  void meetsWhatFallsFaster() {
    for (position = 0; position < 16; position++) {
      put(0, 0, 0, 1, 1, 2, -2);
      put(1, 1, 11, 2, 1, -4, -4);
      assertThat(start()).isTrue();
      assertThat(pair.fallAlike(0, 1)).isFalse();
      assertThat(pair.later()).isEqualTo(slot(1));
      double t = Math.sqrt(11) - 2;
      assertTime(pair.time(false, false, NEVER), t);
      assertTime(pair.time(false, true, NEVER), t); // not together: they did not part there
      assertTime(pair.timeAfter(1), t);
      assertThat(pair.timeAfter(2)).isEqualTo(NEVER);
      assertThat(pair.isFar(0.5)).isTrue();
      assertThat(pair.isFar(t)).isFalse();
    }
  }

  /** The gap of 7 closes by 4 t. */
  @Test
  void meetsWhatFallsAlikeAsIfBothFlewStraight() {
    for (position = 0; position < 16; position++) {
      put(0, 0, 0, 1, 1, 2, -2);
      put(1, 1, 11, 2, 1, -4, -2);
      assertThat(start()).isTrue();
      assertThat(pair.fallAlike(0, 1)).isTrue();
      assertTime(pair.roughTime(), 1.75);
      assertTime(pair.time(true, false, NEVER), 1.75);
      assertTime(pair.time(false, false, NEVER), 1.75);
      assertTime(pair.timeAfter(1), 1.75);
      assertThat(pair.timeAfter(1.75)).isEqualTo(NEVER);
      assertThat(pair.isFar(1.74)).isTrue();
      assertThat(pair.isFar(1.75)).isFalse();
      put(1, 1, 11, 2, 1, 4, -2);
      assertThat(start()).isTrue();
      assertThat(pair.time(false, false, NEVER)).as("parting").isEqualTo(NEVER);
    }
  }

  /** It comes in at 1, leaves on the other side at 4 - sqrt 3, turns back, and comes in again. */
  @Test
  void comesInAgainFromTheOtherSide() {
    for (position = 0; position < 16; position++) {
      put(0, 0, -1, 1, 1, 2, -2);
      put(1, 1, 10, 2, 1, -8, 0);
      assertThat(start()).isTrue();
      assertTime(pair.time(false, false, NEVER), 1);
      assertTime(pair.timeAfter(1), 4 + Math.sqrt(3));
    }
  }

  /**
   * Thrown up at 3 from what it touches, against an acceleration of 2, it is back after 3: where it
   * was, though rounding has let the two overlap.
   */
  @Test
  void comesBackToWhatItJustHit() {
    for (position = 0; position < 16; position++) {
      put(0, 5, 0, 1, 0, 0, 0);
      put(1, 5, Math.sqrt(8) - 1e-9, 2, 0, 3, -2);
      assertThat(start()).isTrue();
      assertThat(pair.time(false, true, NEVER)).isEqualTo(3);
    }
  }

  /** A quarter before the other one begins, less than its time can tell, the first is 1 below. */
  @Test
  void countsTheTailsOfTimes() {
    early = -0.25;
    for (position = 0; position < 16; position++) {
      put(0, 0x1p52, 0, 1, 0, 4, 0);
      put(1, 0x1p52, 9, 2, 0, 0, 0);
      assertThat(start()).isTrue();
      assertThat(pair.later()).isEqualTo(slot(1));
      assertTime(pair.time(false, false, NEVER), (8 - Math.sqrt(8)) / 4);
    }
  }

  @Test
  void pointsAndWhatIsOutOfRangeNeverMeet() {
    for (position = 0; position < 16; position++) {
      put(0, 0, 0, 0, 0, 0, -1);
      put(1, 0, 9, 0, 0, 0, -1);
      assertThat(start()).isFalse();
      put(0, 0, -Double.MAX_VALUE, 1, 0, 0, -1);
      put(1, 0, Double.MAX_VALUE, 1, 0, 0, -1);
      assertThat(start()).isFalse();
    }
  }
}
