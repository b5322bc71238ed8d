// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The filter answers as the detector does, or leaves the answer open. */
class SegmentFilterTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private int told;

  /** Whole numbers, or nearly, so that paths often lead just to a limit. */
  private static double[] query(SplittableRandom random, double blur) {
    double[] q = new double[9];
    for (int i = 0; i < q.length; i++) {
      q[i] = random.nextInt(-12, 13) + blur * random.nextInt(-1, 2);
    }
    q[2] = Math.abs(q[2]);
    return q;
  }

  private void look(double[] q, double scale, double size) {
    double px = scale * q[0];
    double py = scale * q[1];
    double r = scale * q[2];
    double vx = q[3];
    double vy = q[4];
    double ax = scale * q[5];
    double ay = scale * q[6];
    double bx = scale * q[7];
    double by = scale * q[8];
    double margin = SegmentFilter.margin(Math.abs(vx) + Math.abs(vy), size);
    int contact = SegmentFilter.contact(px, py, r, vx, vy, ax, ay, bx, by, margin);
    if (contact != Contact.DOUBT) {
      told++;
      assertThat(contact).isEqualTo(SegmentSweep.contact(px, py, r, vx, vy, ax, ay, bx, by, 0, 0));
    }
    if (contact > Contact.MISS) {
      double time = SegmentSweep.time(contact, px, py, r, vx, vy, ax, ay, bx, by, 0, 0, NEVER);
      assertThat(SegmentFilter.time(contact, px, py, r, vx, vy, ax, ay, bx, by))
          .isCloseTo(time, within(time * SegmentFilter.TIME_ERROR / 4));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0x1p-45, 0x1p-30, 0x1p-24, 0x1p-20, 0.3})
  void whatIsToldIsCertain(double blur) {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 20_000; i++) {
      look(query(random, blur), 1, 64);
    }
    assertThat(told).isGreaterThan(10_000);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0x1p-1000, 0x1p-160, 0x1p-140, 0x1p140, 0x1p160, 0x1p900})
  void soItIsOfAnySize(double scale) {
    SplittableRandom random = new SplittableRandom(8);
    for (int i = 0; i < 1000; i++) {
      look(query(random, 0x1p-30), scale, 64 * scale);
    }
    assertThat(told > 500).isEqualTo(scale > 0x1p-99 && scale < 0x1p150);
  }

  /** As far away as the bounds of errors allow for, by all that is listed for a flight. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 1e3, 1e5, 1e6})
  void whatIsToldFarFromTheOriginIsCertain(double far) {
    SplittableRandom random = new SplittableRandom(9);
    for (int i = 0; i < 20_000; i++) {
      double[] q = query(random, 0.3);
      double angle = 7 * random.nextDouble();
      double along = q[2] * (1 + (random.nextInt(9) - 4) * 0x1p-40 * far);
      // The path leads by a corner of the line, or by its end, or nearly so.
      q[5] = q[0] + 9 * q[3] - along * Math.sin(angle);
      q[6] = q[1] + 9 * q[4] + along * Math.cos(angle);
      double length = 5 << random.nextInt(10);
      q[7] = q[5] + length * Math.cos(angle);
      q[8] = q[6] + length * Math.sin(angle);
      for (int k : new int[] {0, 5, 7}) {
        q[k] += far;
        q[k + 1] -= far;
      }
      look(q, 1, 4 * far + 256 + 2 * length);
    }
    assertThat(told).isGreaterThan(1_000);
  }

  /** Nearly touched at the start, nearly passed along, or nearly grazed at an end. */
  @ParameterizedTest
  @ValueSource(doubles = {0x1p-20, 1, 0x1p10, 0x1p20})
  void whatIsNearALimitIsNotToldWrongly(double unit) {
    SplittableRandom random = new SplittableRandom(10);
    for (int i = 0; i < 40_000; i++) {
      double angle = 7 * random.nextDouble();
      double ux = Math.cos(angle);
      double uy = Math.sin(angle);
      double length = Math.scalb(1 + random.nextDouble(), random.nextInt(20));
      double r = random.nextDouble();
      double ax = random.nextDouble();
      double ay = random.nextDouble();
      double along = (random.nextInt(3) - 0.5) * length;
      double away = r * nearly(random, 1);
      double px = ax + along * ux - away * uy;
      double py = ay + along * uy + away * ux;
      double speed = random.nextDouble() - 0.5;
      double aside = random.nextInt(3) * 0.1 * nearly(random, 1) - 0.1;
      double vx = speed * ux - aside * uy;
      double vy = speed * uy + aside * ux;
      if (random.nextBoolean()) { // past the start, at a distance that is nearly r
        double way = Math.scalb(1.0, random.nextInt(20));
        px = ax + way * ux - away * uy;
        py = ay + way * uy + away * ux;
        vx = -ux;
        vy = -uy;
        double turn = 6 * random.nextDouble() - 3;
        ux = Math.cos(angle + turn);
        uy = Math.sin(angle + turn);
      }
      double fast = Math.scalb(1.0, random.nextInt(-20, 20));
      double[] q = {px, py, r, fast * vx, fast * vy, ax, ay, ax + length * ux, ay + length * uy};
      double farthest = Math.abs(ax) + Math.abs(ay) + length;
      look(q, unit, unit * (Math.abs(px) + Math.abs(py) + r + farthest));
    }
    assertThat(told).isGreaterThan(1_000);
  }

  /** A number that differs by some or by many of its last places, or by more. */
  private static double nearly(SplittableRandom random, double x) {
    return x + (random.nextInt(9) - 4) * Math.scalb(x, -4 - random.nextInt(50));
  }

  @Test
  void whatIsHitIsLeftInDoubtByAnInfiniteMargin() {
    assertThat(SegmentFilter.contact(0, 0, 1, 2, 0, 4, -3, 4, 3, NEVER)).isEqualTo(Contact.DOUBT);
    assertThat(SegmentFilter.contact(0, 0, 1, -2, 0, 4, -3, 4, 3, NEVER)).isEqualTo(Contact.MISS);
  }

  /** The loss of r^2 or w.w by underflow is large beside the square of a small distance. */
  @Test
  void whatUnderflowsBesideLargeNumbersIsLeftInDoubt() {
    assertThat(hit(-0x1p-539, 0x1p-690, 0x1p-540, 1, 0x1p-10, 0x1p500)).isPositive();
    assertThat(hit(-0x1p501, 0x1p400, 0x1p500, 0x1p152, 0x1p142, 0x1p-540)).isPositive();
  }

  /** The contact with a level line from the origin; the filter may leave it open. */
  private static int hit(double px, double py, double r, double vx, double vy, double bx) {
    double size = Math.abs(px) + Math.abs(py) + r + bx;
    double margin = SegmentFilter.margin(vx + vy, size);
    int told = SegmentFilter.contact(px, py, r, vx, vy, 0, 0, bx, 0, margin);
    int contact = SegmentSweep.contact(px, py, r, vx, vy, 0, 0, bx, 0, 0, 0);
    assertThat(told).isIn(contact, Contact.DOUBT);
    return contact;
  }
}
