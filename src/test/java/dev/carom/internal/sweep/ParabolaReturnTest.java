// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.Polynomial;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The return to the thing just hit: by examples, and the ladder beside exact numbers alone. */
class ParabolaReturnTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  @Test
  void aBounceOffAFloorTakesTwiceTheTimeToItsApex() {
    assertThat(FallReturn.toWall(3, -2, 1, NEVER)).isEqualTo(3);
    assertThat(FallReturn.toWall(-3, 2, -1, NEVER)).isEqualTo(3);
    assertThat(FallReturn.toWall(3, -2, 1, 3)).isEqualTo(3);
    assertThat(FallReturn.toWall(3, -2, 1, Math.nextDown(3.0))).isEqualTo(NEVER);
    assertThat(Falls.returnToSide(1, 1, 3, 0, -2, 0, 0, 10, 0, 0, 0, NEVER)).isEqualTo(3);
    assertThat(Falls.returnToSide(-1, 1, 3, 0, -2, 10, 0, 0, 0, 0, 0, 3)).isEqualTo(3);
    assertThat(Falls.returnToSide(1, 1, 3, 0, -2, 0, 0, 10, 0, 0, 0, Math.nextDown(3.0)))
        .isEqualTo(NEVER);
    // From the top of a peg straight up.
    assertThat(Falls.returnToDisk(0, 1, 0, 3, 0, -2, 0, 0, 0, 0, NEVER)).isEqualTo(3);
    assertThat(Falls.returnToDisk(0, 1, 0, 3, 0, -2, 0, 0, 0, 0, 3)).isEqualTo(3);
    assertThat(Falls.returnToDisk(0, 1, 0, 3, 0, -2, 0, 0, 0, 0, Math.nextDown(3.0)))
        .isEqualTo(NEVER);
  }

  /** A disk of radius 1 on or near a line from (0, 0) to (10, 0), with an acceleration of -2. */
  private static double toFloor(double x, double y, double vx, double vy, double T) {
    return Falls.returnToLine(x, y, 1, vx, vy, 0, -2, 0, 0, 10, 0, 0, 0, T);
  }

  private static int contact(double x, double y, double vx, double vy, double t) {
    return Falls.contactOfReturn(x, y, 1, vx, vy, 0, -2, 0, 0, 10, 0, 0, 0, t);
  }

  @Test
  void aBounceOnALineComesBackToItsSideOrOneOfItsEnds() {
    assertThat(toFloor(5, 1, 1, 3, NEVER)).isEqualTo(3);
    assertThat(contact(5, 1, 1, 3, 3)).isEqualTo(Contact.LEFT);
    assertThat(toFloor(5, 1, 1, 3, Math.nextDown(3.0))).isEqualTo(NEVER);
    // 0.2 beyond the end after 3, and falling.
    double onEnd = toFloor(7.2, 1, 1, 3, NEVER);
    assertThat(onEnd).isBetween(3.0, 3.1);
    assertThat(contact(7.2, 1, 1, 3, onEnd)).isEqualTo(Contact.END);
    assertThat(toFloor(9.5, 1, 1, 3, NEVER)).isEqualTo(NEVER);
    // Exactly over the end when it is back.
    assertThat(toFloor(7, 1, 1, 3, NEVER)).isEqualTo(3);
    assertThat(contact(7, 1, 1, 3, 3)).isEqualTo(Contact.END);
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
      double disk = Falls.returnToDisk(n[0], n[1], n[2], n[3], gx, n[5], n[6], n[7], 0, 0, T);
      assertThat(disk)
          .isEqualTo(
              Falls.exactReturnToDisk(n[0], n[1], n[2], n[3], gx, n[5], n[6], n[7], 0, 0, T));
      double side = Falls.returnToSide(1, n[2], n[3], gx, n[5], n[0], n[1], n[6], n[7], 0, 0, T);
      assertThat(side)
          .isEqualTo(
              Falls.exactReturnToSide(1, n[2], n[3], gx, n[5], n[0], n[1], n[6], n[7], 0, 0, T));
      assertThat(FallReturn.toWall(n[2], n[5], 1, T))
          .isEqualTo(
              ExactParabola.ofGap(Polynomial.EXACT.motion(0, 0, n[2], 0, n[5]).fromStart())
                  .time(T));
      hits += disk > 0 && disk < NEVER ? 1 : 0;
      hits += side > 0 && side < NEVER ? 1 : 0;
    }
    assertThat(hits).isGreaterThan(1_000);
  }
}
