// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ObstacleMotionsTest {

  private static final int LINE = Codes.line(0);

  /** A line whose ends move at their own velocities from time 1.5, so as to be here at time 5. */
  @Test
  void arrivesAtTheEndOfItsMotionToTheBitAndRests() {
    double[] motion = {0.25, 0.5, -1, 0, 1.5, 5};
    double[] there = {0.625, 1, 7, 8};

    assertThat(at(motion, there, 1.5)).containsExactly(-0.25, -0.75, 10.5, 8);
    assertThat(at(motion, there, 4)).containsExactly(0.375, 0.5, 8, 8);
    assertThat(at(motion, there, 5)).containsExactly(there);
    assertThat(at(motion, there, 6)).containsExactly(there);
  }

  /** The same velocity of both ends, for ever. */
  @Test
  void goesOnFromItsStartIfItNeverEnds() {
    double[] motion = ObstacleMotions.motion(LINE, 0.5, 0.25, 2);

    assertThat(at(motion, new double[] {1, 2, 3, 4}, 6)).containsExactly(3, 3, 5, 5);
  }

  private static double[] at(double[] motion, double[] row, double time) {
    ObstacleMotions its = ObstacleMotions.of(new int[] {LINE}, motion);
    double[] there = new double[row.length];
    its.place(0, time, 0, row, 0, there, 0, row.length);
    return there;
  }

  /** Who shares motions keeps them; who owns them changes them where they are. */
  @Test
  void copiesMotionsOnlyWhereTheyAreShared() {
    ObstacleMotions its = ObstacleMotions.NONE.with(LINE, 1, 2, 0);

    assertThat(its.with(LINE, 3, 4, 0)).isSameAs(its);
    assertThat(its.shared().with(LINE, 5, 6, 0).ux(0)).isEqualTo(5);
    assertThat(its.ux(0)).isEqualTo(3);
    assertThat(ObstacleMotions.NONE.count()).isZero();
  }
}
