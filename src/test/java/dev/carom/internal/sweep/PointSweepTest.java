// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The time at which an end is met is that at which a resting disk of no size is. */
class PointSweepTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * @param far how far from the origin: what the difference of two places loses counts
   * @param graze how near to a graze, of 1
   * @param radius of the way to the end
   * @param told of how many in a hundred one step tells at least
   */
  @ParameterizedTest
  @CsvSource({
    "0, 0.9, 0.2, 99",
    "1, 0.9, 0.9, 99",
    "1e3, 0.9, 1e-3, 99",
    "1e6, 1, 0.1, 1",
    "1, 0.99999, 0.5, 99",
    "3, 0, 1e-9, 0"
  })
  void isThatOfADiskOfNoSize(double far, double graze, double radius, int told) {
    SplittableRandom random = new SplittableRandom(7);
    int met = 0;
    int byOneStep = 0;
    for (int i = 0; i < 3_000; i++) {
      double way = 1 + random.nextDouble();
      double angle = 7 * random.nextDouble();
      double r = way * radius * (0.5 + 0.5 * random.nextDouble());
      double x = far * (random.nextDouble() - 0.5);
      double y = far * (random.nextDouble() - 0.5);
      double px = x + way * Math.cos(angle);
      double py = y + way * Math.sin(angle);
      double lean = Math.asin(graze * r / way) * (random.nextBoolean() ? 1 : -1);
      double speed = Math.scalb(1 + random.nextDouble(), random.nextInt(-20, 20));
      double vx = -speed * Math.cos(angle + lean);
      double vy = -speed * Math.sin(angle + lean);
      int contact = DiskSweep.contact(px, py, r, vx, vy, x, y, 0, 0, 0);
      if (contact == Contact.LATER) {
        met++;
        double time = DiskSweep.time(contact, px, py, r, vx, vy, x, y, 0, 0, 0, NEVER);
        double root = SegmentFilter.timeOfEnd(px, py, r, vx, vy, x, y);
        assertThat(PointSweep.time(px, py, r, vx, vy, x, y, root)).isEqualTo(time);
        byOneStep += PointSweep.firstStep(px, py, r, vx, vy, x, y, root) == time ? 1 : 0;
      }
    }
    assertThat(met).isGreaterThan(1_000);
    assertThat(100.0 * byOneStep / met).isGreaterThanOrEqualTo(told);
  }
}
