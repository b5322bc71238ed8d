// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.ExactReturn;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The return to the thing just hit: by examples, and the ladder beside exact numbers alone. */
class ParabolaReturnTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  @Test
  void aBounceOffAFloorTakesTwiceTheTimeToItsApex() {
    assertThat(ParabolaReturn.toWall(3, -2, 1, NEVER)).isEqualTo(3);
    assertThat(ParabolaReturn.toWall(-3, 2, -1, NEVER)).isEqualTo(3);
    assertThat(ParabolaReturn.toWall(3, -2, 1, 3)).isEqualTo(3);
    assertThat(ParabolaReturn.toWall(3, -2, 1, Math.nextDown(3.0))).isEqualTo(NEVER);
    assertThat(ParabolaReturn.toSide(1, 1, 3, 0, -2, 0, 0, 10, 0, 0, 0, NEVER)).isEqualTo(3);
    assertThat(ParabolaReturn.toSide(-1, 1, 3, 0, -2, 10, 0, 0, 0, 0, 0, 3)).isEqualTo(3);
    assertThat(ParabolaReturn.toSide(1, 1, 3, 0, -2, 0, 0, 10, 0, 0, 0, Math.nextDown(3.0)))
        .isEqualTo(NEVER);
    // From the top of a peg straight up.
    assertThat(ParabolaReturn.toDisk(0, 1, 0, 3, 0, -2, 0, 0, 0, 0, NEVER)).isEqualTo(3);
    assertThat(ParabolaReturn.toDisk(0, 1, 0, 3, 0, -2, 0, 0, 0, 0, 3)).isEqualTo(3);
    assertThat(ParabolaReturn.toDisk(0, 1, 0, 3, 0, -2, 0, 0, 0, 0, Math.nextDown(3.0)))
        .isEqualTo(NEVER);
  }

  @Test
  void withoutNormalSpeedTheAccelerationDecides() {
    assertThat(ParabolaReturn.toWall(0, -2, 1, 9)).isZero();
    assertThat(ParabolaReturn.toWall(-1e-300, -2, 1, 9)).isZero();
    assertThat(ParabolaReturn.toWall(0, 2, 1, 9)).isEqualTo(NEVER);
    assertThat(ParabolaReturn.toWall(5, 0, 1, 9)).isEqualTo(NEVER);
    assertThat(ParabolaReturn.toSide(1, 1, 0, 0, -2, 0, 0, 10, 0, 0, 0, 9)).isZero();
    assertThat(ParabolaReturn.toSide(1, 1, -1e-300, 0, -2, 0, 0, 10, 0, 0, 0, 9)).isZero();
    assertThat(ParabolaReturn.toSide(1, 1, 1, 3, 0, 0, 0, 10, 0, 0, 0, 9)).isEqualTo(NEVER);
    assertThat(ParabolaReturn.toDisk(0, 1, 0, 0, 0, -2, 0, 0, 0, 0, 9)).isZero();
    assertThat(ParabolaReturn.toDisk(0, 1, 0, -1e-300, 0, -2, 0, 0, 0, 0, 9)).isZero();
    assertThat(ParabolaReturn.toDisk(0, 1, 2, 0, 0, -2, 0, 0, 0, 0, 9)).isEqualTo(NEVER);
    assertThat(ParabolaReturn.toDisk(0, -1, 0, 0, 0, -2, 0, 0, 0, 0, 9)).isEqualTo(NEVER);
  }

  /** It passes over the peg and falls past it, or comes down on it, whatever the rounded place. */
  @Test
  void thePlaceAtTheStartIsTheDistanceToComeBackTo() {
    double near = ParabolaReturn.toDisk(0, 1, 0.1, 3, 0, -2, 0, 0, 0, 0, NEVER);
    double off = ParabolaReturn.toDisk(0, Math.nextUp(1.0), 0.1, 3, 0, -2, 0, 0, 0, 0, NEVER);
    assertThat(near).isBetween(3.0, 3.1);
    assertThat(off).isBetween(near - 1e-14, near + 1e-14);
    assertThat(ParabolaReturn.toDisk(0, 1, 9, 3, 0, -2, 0, 0, 0, 0, NEVER)).isEqualTo(NEVER);
  }

  @Test
  void theLadderAnswersAsExactNumbersDo() {
    SplittableRandom random = new SplittableRandom(5);
    int hits = 0;
    for (int i = 0; i < 5_000; i++) {
      double scale = i % 5 == 0 ? Math.scalb(1.0, random.nextInt(-500, 500)) : 1;
      double[] n = random.doubles(10, -scale, scale).toArray();
      double T = i % 3 == 0 ? random.nextDouble() * 3 : NEVER;
      double gx = i % 2 == 0 ? 0 : n[4];
      double disk = ParabolaReturn.toDisk(n[0], n[1], n[2], n[3], gx, n[5], n[6], n[7], 0, 0, T);
      assertThat(disk)
          .isEqualTo(
              ExactReturn.toDisk(n[0], n[1], n[2], n[3], gx, n[5], n[6], n[7], 0, 0).time(T));
      double side = ParabolaReturn.toSide(1, n[2], n[3], gx, n[5], n[0], n[1], n[6], n[7], 0, 0, T);
      assertThat(side)
          .isEqualTo(
              ExactReturn.toSide(1, n[2], n[3], gx, n[5], n[0], n[1], n[6], n[7], 0, 0).time(T));
      assertThat(ParabolaReturn.toWall(n[2], n[5], 1, T))
          .isEqualTo(ExactReturn.toWall(n[2], n[5], 1).time(T));
      hits += disk > 0 && disk < NEVER ? 1 : 0;
      hits += side > 0 && side < NEVER ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(1_000);
  }
}
