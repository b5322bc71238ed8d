// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class ObstacleMotionsTest {

  private static final int LINE = Codes.line(0);

  /** A line whose ends move at their own velocities from time 1.5, so as to be here at time 5. */
  @Test
  void arrivesAtTheEndOfItsMotionToTheBitAndRests() {
    double[] motion = {0.25, 0.5, -1, 0, 0, 0, 0, 0, 1.5, 5};
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

  private static double[] turn(double pivotX, double angle, double since, double until) {
    double[] motion = new double[ObstacleMotions.SIZE];
    ObstacleMotions.setTurn(motion, pivotX, 2, angle, since, until);
    return motion;
  }

  /** A turn is rigid, and ends to the bit where the row says. */
  @Test
  void turnsAboutItsPivotByTheAngle() {
    Random random = new Random(1);
    for (int i = 0; i < 10_000; i++) {
      double angle = (random.nextDouble() - 0.5) * Math.PI;
      double[] motion = turn(1, angle, 3, 3.25);
      double[] there = {3 + random.nextDouble(), 4 + random.nextDouble(), 4, 2};

      assertThat(at(motion, there, 3.25)).containsExactly(there);
      assertThat(at(motion, there, 4)).containsExactly(there);
      double time = i % 2 == 0 ? 3 : 3 + 0.25 * random.nextDouble();
      double[] then = at(motion, there, time);
      for (int k = 0; k < 4; k += 2) {
        double left = angleFrom(then, there, k);
        double all = angleOfEnd(angle, (time - 3) / 0.25);
        assertThat(left).isCloseTo(all, within(1e-14));
        assertThat(Math.hypot(then[k] - 1, then[k + 1] - 2))
            .isCloseTo(Math.hypot(there[k] - 1, there[k + 1] - 2), within(2e-15));
      }
    }
  }

  /** The angle from one place to the other, as seen from the pivot. */
  private static double angleFrom(double[] then, double[] there, int k) {
    double x = then[k] - 1;
    double y = then[k + 1] - 2;
    double toX = there[k] - 1;
    double toY = there[k + 1] - 2;
    return Math.atan2(x * toY - y * toX, x * toX + y * toY);
  }

  /** The rest of a turn after a part of its duration: c goes straight from 1 to e^(i angle / 2). */
  private static double angleOfEnd(double angle, double part) {
    double x = 1 - part + part * Math.cos(angle / 2);
    double y = part * Math.sin(angle / 2);
    return angle - 2 * Math.atan2(y, x);
  }

  /** Seen from any moment on it is the same turn; its rate is that of the angle. */
  @Test
  void aTurnIsOneSeenFromAnyMoment() {
    ObstacleMotions its = ObstacleMotions.of(new int[] {LINE}, turn(1, 1.5, 3, 3.25));
    double[] there = {3, 2, 7, 5};
    for (double from = 3; from < 3.245; from += 0.01) {
      double[] xy = at(its.motion(0), there, from);
      double h = 3.2 - from;
      double qx = its.turnX(0, from, 0);
      double qy = its.turnY(0, from, 0);
      double[] later = at(its.motion(0), there, 3.2);
      double[] next = at(its.motion(0), there, from + 1e-6);

      ObstacleMotions.turn(1, 2, 1 + qx * h, qy * h, xy, 2);
      assertThat(xy[2]).isCloseTo(later[2], within(5e-15));
      assertThat(xy[3]).isCloseTo(later[3], within(5e-15));
      double[] before = at(its.motion(0), there, from - 1e-6);
      assertThat(angleFrom(before, next, 0) / 2e-6).isCloseTo(2 * qy, within(1e-6));
    }
  }

  /** Points that are equal stay equal, to the bit. */
  @Test
  void joinedEndsStayJoined() {
    Random random = new Random(2);
    for (int i = 0; i < 1000; i++) {
      double[] motion = turn(random.nextDouble(), 1.5, 0, 3);
      double x = random.nextGaussian();
      double y = random.nextGaussian();
      double time = random.nextDouble();
      double[] one = at(motion, new double[] {7, 8, x, y}, time);
      double[] next = at(motion, new double[] {x, y, 9, -1}, time);
      assertThat(one[2]).isEqualTo(next[0]);
      assertThat(one[3]).isEqualTo(next[1]);
    }
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
