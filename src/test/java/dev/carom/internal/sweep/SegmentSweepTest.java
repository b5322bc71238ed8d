// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.exact.ExactSigns;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Side or end: paths that nearly pass through the corner between the two. */
class SegmentSweepTest {
  private static final int QUESTIONS = 4_000;

  private final Random random = new Random(2);

  private double number() {
    return random.nextBoolean() ? 0.5 + random.nextDouble() : -0.5 - random.nextDouble();
  }

  /**
   * From the left of a line that starts at the origin, of any length, nearly through the corner
   * above that, often so slowly that squares underflow: ax ay bx by px py r vx vy.
   */
  private double[] next() {
    double angle = random.nextDouble() * 2 * Math.PI;
    double wx = Math.cos(angle);
    double wy = Math.sin(angle);
    double r = 0.5 + random.nextDouble();
    double along = number();
    // At the corner, which is r above the start, less a way along v; then to the side, by a little.
    double vx = wy + along * wx;
    double vy = -wx + along * wy;
    double off = Math.scalb(number(), -random.nextInt(60));
    double way = 1 + random.nextDouble();
    double px = -wy * r - way * vx + off * wx;
    double py = wx * r - way * vy + off * wy;
    double length = Math.scalb(1.0, random.nextInt(400));
    double speed = Math.scalb(1.0, -random.nextInt(560));
    return new double[] {0, 0, wx * length, wy * length, px, py, r, vx * speed, vy * speed};
  }

  private static int contact(double[] n) {
    return SegmentSweep.contact(n[4], n[5], n[6], n[7], n[8], n[0], n[1], n[2], n[3], 0, 0);
  }

  private static int corner(double[] n, double x, double y) {
    return ExactSigns.NUMBERS.corner(
        1, n[4], n[5], x, y, n[7], n[8], 0, 0, n[2], n[3], n[0], n[1], n[6]);
  }

  @Test
  void nearTheCornerTheSideIsHitIfThePathPassesWithin() {
    int hits = 0;
    for (int i = 0; i < QUESTIONS; i++) {
      double[] n = next();
      int contact = contact(n);
      boolean side = corner(n, n[0], n[1]) > 0 && corner(n, n[2], n[3]) < 0;
      assertThat(contact == Contact.LEFT).as(() -> Arrays.toString(n)).isEqualTo(side);
      hits += side ? 1 : 0;
    }
    assertThat(hits).isBetween(QUESTIONS / 4, QUESTIONS * 3 / 4);
  }
}
