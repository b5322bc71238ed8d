// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The time of a side does not depend on where its refinement begins. */
class SideSweepTest {

  @Test
  void isTheSameFromAnyRoughTime() {
    SplittableRandom random = new SplittableRandom(8);
    int met = 0;
    for (int i = 0; i < 5_000; i++) {
      double scale = Math.scalb(1.0, random.nextInt(-20, 20));
      double[] n = random.doubles(8, -scale, scale).toArray();
      double r = scale * random.nextDouble() / 10;
      int contact = SegmentSweep.contact(n[0], n[1], r, n[2], n[3], n[4], n[5], n[6], n[7]);
      if (contact == SegmentSweep.LEFT || contact == SegmentSweep.RIGHT) {
        met++;
        int side = contact == SegmentSweep.LEFT ? 1 : -1;
        double time = SideSweep.time(side, n[0], n[1], r, n[2], n[3], n[4], n[5], n[6], n[7]);
        for (double error : new double[] {0, 0x1p-52, -0x1p-40, 0x1p-28, -0x1p-10, 1, -1}) {
          double rough = time * (1 + error);
          assertThat(
                  SideSweep.refined(side, n[0], n[1], r, n[2], n[3], n[4], n[5], n[6], n[7], rough))
              .as("query %d from %s", i, rough)
              .isEqualTo(time);
        }
      }
    }
    assertThat(met).isGreaterThan(200);
  }
}
