// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.SweptSphere;
import dev.carom.internal.exact.Dyadic;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SphereSweepTest {

  /** Overlapping, and moving across the line between them as far as doubles can: now, or never. */
  @Test
  void whoApproachesIsToldFromWhoDoesNot() {
    Random random = new Random(9);
    for (int i = 0; i < 3_000; i++) {
      double[] d = new double[3];
      double[] u = new double[3];
      double[] at = new double[3];
      for (int axis = 0; axis < 3; axis++) {
        d[axis] = 0.5 + random.nextDouble();
        u[axis] = random.nextDouble();
        at[axis] = random.nextDouble();
      }
      int last = i % 3;
      int one = (last + 1) % 3;
      int two = (last + 2) % 3;
      u[last] = -(u[one] * d[one] + u[two] * d[two]) / d[last];
      double[] n = {
        at[0] + d[0],
        at[1] + d[1],
        at[2] + d[2],
        9,
        u[0],
        u[1],
        u[2],
        at[0],
        at[1],
        at[2],
        9,
        0,
        0,
        0
      };
      double time =
          new SweptSphere(n[0], n[1], n[2], n[3], n[4], n[5], n[6])
              .timeToSphere(new SweptSphere(n[7], n[8], n[9], n[10], n[11], n[12], n[13]), 1);
      Dyadic drift = Dyadic.ZERO;
      for (int axis = 0; axis < 3; axis++) {
        Dyadic offset = Dyadic.difference(n[axis], n[7 + axis]);
        drift = drift.plus(offset.times(Dyadic.difference(n[4 + axis], n[11 + axis])));
      }
      assertThat(time)
          .as(() -> Arrays.toString(n))
          .isEqualTo(drift.sign() < 0 ? 0 : Double.POSITIVE_INFINITY);
    }
  }
}
