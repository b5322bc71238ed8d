// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.exact.UnitVector;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/**
 * How many questions about accelerated disks doubles and double-double answer, and how many exact
 * numbers. A bound that is larger than it was sends more of them up, and nothing else would notice.
 */
@EnabledIfSystemProperty(named = "dev.carom.rungs", matches = "true")
class ParabolaSweepTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final int QUERIES = 4_000;

  private final SplittableRandom random = new SplittableRandom(3);

  /** A disk at the origin that falls, and a thing at a distance of 1.05 to 6 radii. */
  private final double[] v = new double[2];

  private final double[] at = new double[2];
  private double r;
  private double g;

  private void draw() {
    r = random.nextDouble(1, 2);
    g = -random.nextDouble(0.1, 2);
    double angle = random.nextDouble(7);
    double far = r * random.nextDouble(1.05, 6);
    at[0] = far * Math.cos(angle);
    at[1] = far * Math.sin(angle);
    double lean = angle + random.nextDouble(-1.5, 1.5);
    double speed = random.nextDouble(1, 10);
    v[0] = speed * Math.cos(lean);
    v[1] = speed * Math.sin(lean);
  }

  /** Half an ulp of the start is no double. */
  @Test
  void aTimeAfterTheLeastDouble() {
    double[] n = {
      1.8218793876714408, 1.6334281234927437, 2.446907655393966, -1, -1, 0, -1,
      -6.856796655450329e-06, -4.641358343428964e-08, 1.21795643972811e-17, 0, 0
    };
    double time =
        Falls.timeOfDiskAfter(
            n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11],
            Double.MIN_VALUE, 10);
    double truth =
        FallSweep.exact(
                Falls.disk(
                    n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11]))
            .timeAfter(Double.MIN_VALUE, 10);
    assertThat(time).isEqualTo(truth).isLessThan(1e-30);
  }

  /** Place times speed overflows: the normal is left to exact numbers. */
  @Test
  void aNormalWhoseSlopeIsInfinite() {
    double x = -0x1p110 * 1.2345678;
    double y = 0x1p90 * 0.6;
    double r = 0x1p89;
    double v = 0x1p950 * 1.1;
    double t = Falls.timeOfDisk(x, y, r, v, 0, 0, -1, 0, 0, r, 0, 0, 1);
    assertThat(t).isLessThan(1e-250);
    assertThat(Falls.normal(x, y, r, v, 0, 0, -1, 0, 0, r, 0, 0, t)).isNull();
  }

  /** The square of the radius underflows, and that of the line is nearly as large. */
  @Test
  void aLongLineAndATinyDisk() {
    double a = 0x1p499;
    double r = 0x1.d68f698580a8bp-522;
    double y = 0x1.d68f6985808b4p-522;
    double time =
        Falls.timeOfLine(
            0, y, r, 0, -y * 0x1p-22, 0, y, -a, 0, a, 0, 0, 0, 100);
    assertThat(time).isZero();
  }

  /** It overlaps both ends of a short line by less than rounding, and leaves. */
  @Test
  void aDiskThatLeavesAShortLine() {
    double y = 1 - 306 * 0x1p-53;
    double vy = 0x1p-22 + 0x1p-31;
    double time =
        Falls.timeOfLine(
            -0x1p-22, y, 1, 1, vy, 0, -0x1p-26, 0, 0, 0x1p-30, 0, 0, 0, 100);
    assertThat(time).isEqualTo(NEVER);
  }

  /** A height that is the least double, of the wrong sign, times a speed of 2^700. */
  @Test
  void aDiskThatLeavesThroughALineOfTinyHeight() {
    double ax = 0x1.0000000000001p-2;
    double bx = 0x1.4000000000800p0;
    double by = 0x1.0000000002800p-980;
    double px = 0x1.0000000000002p-2;
    double py = 0x0.0010000000002p-1022;
    double time =
        Falls.timeOfLine(px, py, 0.1, 0, -0x1p700, 0, -1, ax, 0, bx, by, 0, 0, 1);
    assertThat(time).isEqualTo(NEVER);
  }

  /** The true time is 0.4, 0.6 or 1.4 times the least double: half an ulp is most of it. */
  @Test
  void theContactAtALeastTime() {
    double u = 0x1p-74;
    double r = 0x1p-70;
    double v = 0x1p1000;
    double y = 0x1.3333333333333p-75;
    assertThat(contact(0.5, y, 0, 0, -v, 1)).isEqualTo(Contact.LEFT);
    assertThat(contact(-1.2 * u, r + 1.4 * u, r, v, -v, 1)).isEqualTo(Contact.LEFT);
    assertThat(contact(-0.2 * u, r + 0.4 * u, r, v, -v, 0)).isEqualTo(Contact.LEFT);
  }

  /** The part of the contact of a falling disk with the line from 0 to 1 at k least times. */
  private static int contact(double px, double py, double r, double vx, double vy, int k) {
    double time = Falls.timeOfLine(px, py, r, vx, vy, 0, -1, 0, 0, 1, 0, 0, 0, 1);
    assertThat(time).isEqualTo(k * Double.MIN_VALUE);
    int contact =
        Falls.contact(px, py, r, vx, vy, 0, -1, 0, 0, 1, 0, 0, 0, time);
    return contact & ~Contact.NOW;
  }

  /** It comes back after 2.4 least times, and is beyond the end by then. */
  @Test
  void aReturnAfterALeastTime() {
    double px = -0x1.199999999999ap-50;
    double vx = 0x1p1023;
    double vy = 3 * Double.MIN_VALUE;
    double time = Falls.returnToLine(px, 1, 1, vx, vy, 0, -2.5, -1, 0, 0, 0, 0, 0, 1);
    assertThat(time).isEqualTo(NEVER);
  }

  /** The cube of the window is no double, and the acceleration is 2^499. */
  @Test
  void aWindowWhoseCubeUnderflows() {
    double g = -0x1p499;
    double T = 0x1p-360;
    double time =
        Falls.timeOfDisk(0x1p-222, 0, 0x1p-223, 0, 0x1p138, g, g, 0, 0, 0, 0, 0, T);
    assertThat(time).isBetween(0.625 * T, 0.75 * T);
  }

  /** The impact is after the start, though the time is rounded to 0. */
  @Test
  void aNormalAfterTheTime0() {
    double v = -0x1p1023;
    double t = Falls.timeOfDisk(0x1p-52, 0x1p-54, 0x1p-53, v, 0, 0, -1, 0, 0, 0, 0, 0, 1);
    assertThat(t).isZero();
    UnitVector n =
        Falls.normal(0x1p-52, 0x1p-54, 0x1p-53, v, 0, 0, -1, 0, 0, 0, 0, 0, t);
    assertThat(n).isNull();
  }

  @Test
  void ordinaryQuestionsAboutDisksNeedNoExactNumbers() {
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    int hits = 0;
    for (int i = 0; i < QUERIES; i++) {
      draw();
      double T = i % 2 == 0 ? 1 : NEVER;
      double time = Falls.timeOfDisk(0, 0, r, v[0], v[1], 0, g, at[0], at[1], 0, 0, 0, T);
      hits += time < NEVER ? 1 : 0;
    }
    assertThat(hits).isBetween(QUERIES / 5, 4 * QUERIES / 5);
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count() - before).isLessThanOrEqualTo(2);
  }

  @Test
  void ordinaryQuestionsAboutLinesNeedNoExactNumbers() {
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    int hits = 0;
    for (int i = 0; i < QUERIES; i++) {
      draw();
      // Across the way to it, so that the disk does not overlap the line.
      double length = random.nextDouble(0.2, 3);
      double ax = at[0] - length * at[1];
      double ay = at[1] + length * at[0];
      double bx = at[0] + length * at[1];
      double by = at[1] - length * at[0];
      double T = i % 2 == 0 ? 1 : NEVER;
      double time = Falls.timeOfLine(0, 0, r, v[0], v[1], 0, g, ax, ay, bx, by, 0, 0, T);
      if (time < NEVER) {
        Falls.contact(0, 0, r, v[0], v[1], 0, g, ax, ay, bx, by, 0, 0, time);
        hits++;
      }
    }
    assertThat(hits).isBetween(QUERIES / 5, 4 * QUERIES / 5);
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count() - before).isLessThanOrEqualTo(2);
  }

  /**
   * A line of length 0.2 to 10 through the origin, in any direction, and a disk of radius r on it:
   * on its side, or at an end at an angle of at most a quarter turn beyond it.
   *
   * @return ax, ay, bx, by, px, py, nx, ny: n is the normal
   */
  private double[] drawTouching(boolean atEnd) {
    double length = random.nextDouble(0.2, 10);
    double angle = random.nextDouble(-0.5, 0.5);
    double wx = Math.cos(angle);
    double wy = Math.sin(angle);
    double lean = atEnd ? random.nextDouble(0, Math.PI / 2) : 0;
    double s = atEnd ? length : length * random.nextDouble();
    double nx = Math.sin(lean) * wx - Math.cos(lean) * wy;
    double ny = Math.sin(lean) * wy + Math.cos(lean) * wx;
    double px = s * wx + r * nx;
    double py = s * wy + r * ny;
    return new double[] {0, 0, length * wx, length * wy, px, py, nx, ny};
  }

  /**
   * Asks for returns with a speed along the normal in a range; some hit, and exact numbers rest.
   */
  private void assertCertainReturns(boolean atEnd, double leastSpeed, double mostSpeed) {
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    int hits = 0;
    for (int i = 0; i < QUERIES; i++) {
      draw();
      double[] n = drawTouching(atEnd);
      double up = Math.exp(random.nextDouble(Math.log(leastSpeed), Math.log(mostSpeed)));
      double along = random.nextDouble(-3, 3);
      double vx = up * n[6] - along * n[7];
      double vy = up * n[7] + along * n[6];
      double T = i % 2 == 0 ? 1 : NEVER;
      double time =
          Falls.returnToLine(n[4], n[5], r, vx, vy, 0, g, n[0], n[1], n[2], n[3], 0, 0, T);
      if (time < NEVER) {
        Falls.contactOfReturn(
            n[4], n[5], r, vx, vy, 0, g, n[0], n[1], n[2], n[3], 0, 0, time);
        hits++;
      }
    }
    assertThat(hits).isBetween(QUERIES / 5, QUERIES);
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count() - before).isLessThanOrEqualTo(2);
  }

  @Test
  void ordinaryReturnsNeedNoExactNumbers() {
    assertCertainReturns(false, 0.01, 10);
    assertCertainReturns(true, 0.01, 10);
  }

  @Test
  void lowHopsNeedNoExactNumbers() {
    assertCertainReturns(false, 1e-8, 1e-3);
    assertCertainReturns(true, 1e-8, 1e-3);
  }

  /** A disk of half the size, or a line, that is passed; the next entry is asked for after each. */
  @Test
  void ordinaryEntriesNeedNoExactNumbers() {
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    int[] entries = new int[3];
    for (int i = 0; i < QUERIES; i++) {
      draw();
      double length = random.nextDouble(0.2, 10);
      double angle = random.nextDouble(-0.5, 0.5);
      double wx = length * Math.cos(angle);
      double wy = length * Math.sin(angle);
      double T = i % 4 < 2 ? 5 : NEVER;
      double s = -1;
      for (int k = 0; k < 3 && s < NEVER; k++) {
        s =
            i % 2 == 0
                ? Falls.timeOfLineAfter(
                    0, 0, r, v[0], v[1], 0, g, at[0] - wx, at[1] - wy, at[0] + wx, at[1] + wy, 0,
                    0, s, T)
                : Falls.timeOfDiskAfter(
                    0, 0, r, v[0], v[1], 0, g, at[0], at[1], r / 2, 0, 0, s, T);
        entries[k] += s < NEVER ? 1 : 0;
      }
    }
    assertThat(entries[0]).isGreaterThan(QUERIES / 5);
    assertThat(entries[1]).isPositive();
    assertThat(entries[2]).isZero();
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count() - before).isLessThanOrEqualTo(2);
  }

  /**
   * A disk with an acceleration of -10 against a line, in contact at the start within rounding, in
   * the order of the sweep without the velocity of the line; at last the window and the true time.
   * Seated in a V of two lines; falling along a vertical line and past its end; at the joint of two
   * lines.
   */
  private static final String CONTACTS =
      """
      -7.744168159939263e-17 1.6666666666666665 1 -0.046076151494304746 -0.06143486865907272 \
      0 0 30 40 0 Infinity
      -2.7755575615628914e-16 1.6666666666666663 1 3.1005740215122404 -4.134098695349652 \
      0 0 -30 40 0 Infinity
      -2.85050353000125e-16 1.6666666666666663 1 -1.0717815031037032 -1.4290420041382685 \
      0 0 30 40 Infinity 1.4137043003924613e-9
      4.29759936363746 7.396799151516613 1 -0.9288367676725362 -1.334012136669717 \
      0 0 30 40 Infinity 3.0980517859845595e-15
      0.5 5.55073634129931 0.5 0 -17.659284081220335 0 -2 0 99 0.5 Infinity
      0.4999999999999999 2.360289347663948 0.5 0 -11.437530131648066 0 -2 0 99 0.5 Infinity
      0.5 32.5982085649488 0.5 5.3985235635888694e-17 -9.227962351341052 \
      0 -2 0 99 1.1315750209084718 Infinity
      2.971771109349033 -18.76302434291932 1 -2.595118009107491 0.16384534779267987 \
      3.1286893008046137 -19.753766811902757 6.180339887498945 -19.021130325903073 \
      0.07361711290414859 Infinity
      """;

  @Test
  void contactsWithLinesAtTheStartNeedNoExactNumbers() {
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    for (String contact : CONTACTS.lines().toList()) {
      double[] n = Arrays.stream(contact.split(" +")).mapToDouble(Double::parseDouble).toArray();
      double time =
          Falls.timeOfLine(
              n[0], n[1], n[2], n[3], n[4], 0, -10, n[5], n[6], n[7], n[8], 0, 0, n[9]);
      assertThat(time).isEqualTo(n[10]);
    }
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count()).isEqualTo(before);
  }

  @Test
  void contactsWithDisksAtTheStartNeedNoExactNumbers() {
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    // All but touching a peg, it comes nearer slowly, or fast.
    double slow =
        Falls.timeOfDisk(
            11.416835685962972, 35.47793244230939, 0.5, 2.520933829792924, -7.075144539578793, 0,
            -10, 10.666666666666666, 35.2, 0.3, 0, 0, NEVER);
    assertThat(slow).isEqualTo(2.790313288981091e-13);
    double fast =
        Falls.timeOfDisk(
            26.13076570168882, 35.79397824517049, 0.5, -6.982579459609074, -6.683683962449991, 0,
            -10, 26.666666666666668, 35.2, 0.3, 0, 0, NEVER);
    assertThat(fast).isEqualTo(8.870896863064536e-15);
    // It flies off a peg along the tangent.
    double back =
        Falls.returnToDisk(
            3.9505440914875583, 33.398469857360446, 3.3650186085693945, 0.20842371307317462, 0,
            -10, 4, 32.6, 0, 0, NEVER);
    assertThat(back).isEqualTo(NEVER);
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count()).isEqualTo(before);
  }

  /** It falls past a disk or a point at exactly the distance at which it would graze it. */
  @Test
  void fallsPastATangentNeedNoExactNumbers() {
    long before = PrecisionCounter.EXACT_PARABOLAS.count();
    for (int i = 0; i < QUERIES; i++) {
      double y = random.nextDouble(2, 10);
      double vy = random.nextDouble(-5, 5);
      double r = random.nextInt(1, 64) / 64.0;
      double aside = random.nextBoolean() ? 1 : -1;
      assertThat(Falls.timeOfDisk(aside, y, 1 - r, 0, vy, 0, -10, 0, 0, r, 0, 0, NEVER))
          .isEqualTo(NEVER);
      assertThat(Falls.timeOfDisk(y, aside, 1, vy, 3, -10, 0, 0, 0, 0, 0, 3, NEVER))
          .isEqualTo(NEVER);
    }
    assertThat(PrecisionCounter.EXACT_PARABOLAS.count()).isEqualTo(before);
  }

}
