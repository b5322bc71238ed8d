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

  @Test
  void withoutNormalSpeedTheAccelerationDecides() {
    assertThat(FallReturn.toWall(0, -2, 1, 9)).isZero();
    assertThat(FallReturn.toWall(-1e-300, -2, 1, 9)).isZero();
    assertThat(FallReturn.toWall(0, 2, 1, 9)).isEqualTo(NEVER);
    assertThat(FallReturn.toWall(5, 0, 1, 9)).isEqualTo(NEVER);
    assertThat(Falls.returnToSide(1, 1, 0, 0, -2, 0, 0, 10, 0, 0, 0, 9)).isZero();
    assertThat(Falls.returnToSide(1, 1, -1e-300, 0, -2, 0, 0, 10, 0, 0, 0, 9)).isZero();
    assertThat(Falls.returnToSide(1, 1, 1, 3, 0, 0, 0, 10, 0, 0, 0, 9)).isEqualTo(NEVER);
    assertThat(Falls.returnToDisk(0, 1, 0, 0, 0, -2, 0, 0, 0, 0, 9)).isZero();
    assertThat(Falls.returnToDisk(0, 1, 0, -1e-300, 0, -2, 0, 0, 0, 0, 9)).isZero();
    assertThat(Falls.returnToDisk(0, 1, 2, 0, 0, -2, 0, 0, 0, 0, 9)).isEqualTo(NEVER);
    assertThat(Falls.returnToDisk(0, -1, 0, 0, 0, -2, 0, 0, 0, 0, 9)).isEqualTo(NEVER);
  }

  /** It passes over the peg and falls past it, or comes down on it, whatever the rounded place. */
  @Test
  void thePlaceAtTheStartIsTheDistanceToComeBackTo() {
    double near = Falls.returnToDisk(0, 1, 0.1, 3, 0, -2, 0, 0, 0, 0, NEVER);
    double off = Falls.returnToDisk(0, Math.nextUp(1.0), 0.1, 3, 0, -2, 0, 0, 0, 0, NEVER);
    assertThat(near).isBetween(3.0, 3.1);
    assertThat(off).isBetween(near - 1e-14, near + 1e-14);
    assertThat(Falls.returnToDisk(0, 1, 9, 3, 0, -2, 0, 0, 0, 0, NEVER)).isEqualTo(NEVER);
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
  void aBounceOnAnEndComesBackToItOrOntoTheSide() {
    assertThat(toFloor(10, 1, 0, 3, NEVER)).isEqualTo(3);
    assertThat(contact(10, 1, 0, 3, 3)).isEqualTo(Contact.END);
    assertThat(toFloor(0, 1, 1, 3, NEVER)).isEqualTo(3);
    assertThat(contact(0, 1, 1, 3, 3)).isEqualTo(Contact.LEFT);
    assertThat(toFloor(-0.6, 0.8, 1, 3, NEVER)).isBetween(2.8, 3.0);
    assertThat(toFloor(0, 1, 4, 3, NEVER)).isEqualTo(NEVER); // right over the line
    assertThat(toFloor(-1, 0, -1, 0, NEVER)).isEqualTo(NEVER);
  }

  @Test
  void withoutNormalSpeedALineSupports() {
    assertThat(toFloor(5, 1, 2, 0, 9)).isZero();
    assertThat(contact(5, 1, 2, 0, 0)).isEqualTo(Contact.LEFT | Contact.NOW);
    assertThat(toFloor(5, 1, 2, -1e-300, 9)).isZero();
    assertThat(toFloor(10, 1, 0, 0, 9)).isZero();
    assertThat(contact(10, 1, 0, 0, 0)).isEqualTo(Contact.END | Contact.NOW);
    assertThat(toFloor(10, 1, 2, 0, 9)).isEqualTo(NEVER); // too fast for the curve of the end
    assertThat(toFloor(5, -1, 2, 0, 9)).isEqualTo(NEVER);
  }

  /**
   * Rounded to beyond the start of the line and into it, with a hop too low for its gap to show.
   */
  @Test
  void noHopBelowRoundingFallsThroughALine() {
    double y = Math.nextDown(1.0);
    for (double up : new double[] {0, 1e-300, 1e-20, 1e-12, 1e-9}) {
      double t = toFloor(-1e-20, y, 1, up, NEVER);
      assertThat(t).as("hop with %s", up).isLessThan(1e-8);
      double over = toFloor(5, y, 1, up, NEVER);
      assertThat(over).isEqualTo(up);
    }
  }

  /** The velocity and the acceleration are both along the line, but for a 1e-12th. */
  @Test
  void aReturnIsRoundedCorrectlyWhereBothProductsCancel() {
    double time =
        Falls.returnToSide(
            1,
            0x1.37aa731f746bbp-1,
            -0x1.751b08fb0b919p3,
            0x1.b7e60bef8073cp-2,
            -0x1.074f11f1e865fp3,
            -0x1.300cc9e7387e7p6,
            0x1.02b1ab58eb8bbp6,
            -0x1.30274185da9a4p6,
            0x1.04aca093b2a96p6,
            0x1.bc043a1e7c8ep-26,
            0x1.dd1aa2afbd87bp-18,
            NEVER);
    assertThat(time).isEqualTo(0.005506587360528489);
  }

  /** A point that falls through the end that it touches has no speed towards it, as it counts. */
  @Test
  void aPointDoesNotHitTheEndThatItTouches() {
    assertThat(Falls.returnToLine(0, 5, 0, 0, -1, 0, -2, 0, 0, 10, 0, 0, 0, NEVER)).isZero();
    assertThat(Falls.returnToLine(0, 5, 0, 0, -10, 0, 2, 0, 0, 10, 0, 0, 0, NEVER))
        .isEqualTo(NEVER);
  }

  /** Seen from a line that moves, only the difference of the velocities counts. */
  @Test
  void theLineMayMove() {
    assertThat(Falls.returnToLine(5, 1, 1, 3, 7, 0, -2, 0, 0, 10, 0, 2, 4, NEVER)).isEqualTo(3);
    assertThat(Falls.returnToSide(1, 3, 7, 0, -2, 0, 0, 10, 0, 2, 4, NEVER)).isEqualTo(3);
    assertThat(Falls.returnToLine(0, 1, 1, 0, 7, 0, -2, 0, 0, 0, 0, 0, 4, NEVER)).isEqualTo(3);
    assertThat(Falls.returnToLine(5, 1, 1, 0, 4, 0, -2, 0, 0, 10, 0, 0, 4, NEVER)).isZero();
    assertThat(Falls.returnToLine(5, 1, 1, 0, 4, 0, 0, 0, 0, 10, 0, 0, 5, 9)).isEqualTo(NEVER);
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
              FallReturn.exact(Falls.disk(n[0], n[1], 0, n[2], n[3], gx, n[5], n[6], n[7], 0, 0, 0))
                  .time(T));
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
