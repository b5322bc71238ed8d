// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.SweptCircle;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The time of a side does not depend on where its refinement begins. */
class SideSweepTest {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Of px, py, vx, vy, ax, ay, bx and by. */
  private static double time(int side, double r, double... n) {
    return SideSweep.time(side, n[0], n[1], r, n[2], n[3], n[4], n[5], n[6], n[7], 0, 0, NEVER);
  }

  private static double refined(int side, double rough, double r, double... n) {
    return SideSweep.refined(
        side, n[0], n[1], r, n[2], n[3], n[4], n[5], n[6], n[7], 0, 0, rough, NEVER);
  }

  @Test
  void isTheSameFromAnyRoughTime() {
    SplittableRandom random = new SplittableRandom(8);
    int met = 0;
    for (int i = 0; i < 5_000; i++) {
      double scale = Math.scalb(1.0, random.nextInt(-20, 20));
      double[] n = random.doubles(8, -scale, scale).toArray();
      double r = scale * random.nextDouble() / 10;
      int contact = SegmentSweep.contact(n[0], n[1], r, n[2], n[3], n[4], n[5], n[6], n[7], 0, 0);
      if (contact == Contact.LEFT || contact == Contact.RIGHT) {
        met++;
        int side = contact == Contact.LEFT ? 1 : -1;
        double time = time(side, r, n);
        for (double error : new double[] {0, 0x1p-52, -0x1p-40, 0x1p-28, -0x1p-10, 1, -1}) {
          double rough = time * (1 + error);
          assertThat(refined(side, rough, r, n)).as("query %d from %s", i, rough).isEqualTo(time);
        }
      }
    }
    assertThat(met).isGreaterThan(200);
  }

  /**
   * The radius is as small as what the rough time lacks, and that leads to the other side of the
   * line: there, {@code h + r |w|} would cancel.
   */
  @ParameterizedTest
  @CsvSource({
    "-0.125, 1.125, 0x1.6a09e667f3bcdp-55, 0.375, -0.375, 1, 1",
    "-131072, 1179648, 0x1.6a09e667f3bcdp-35, 0.375, -0.375, 1048576, 1048576",
    "0x1.7dc59aa55f876p-1, 0x1.315e7de6f8af0p0, 0x1.bd5f834dbf0cdp-55, 0x1.ee5482b555045p-17, "
        + "-0x1.350387a1e478ep-17, 0x1.350387a1e478ep0, 0x1.ee5482b555045p0"
  })
  void theRadiusOfAPointButForRounding(
      String px, String py, String r, String vx, String vy, String bx, String by) {
    double[] n = Stream.of(px, py, r, vx, vy, bx, by).mapToDouble(Double::parseDouble).toArray();
    Fall fall = Falls.line(n[0], n[1], n[2], n[3], n[4], 0, 0, 0, 0, n[5], n[6], 0, 0);
    double time = FallSweep.exactTime(fall, Contact.LEFT).nearest();
    assertThat(new SweptCircle(n[0], n[1], n[2], n[3], n[4]).timeToLine(0, 0, n[5], n[6], 1e9))
        .isEqualTo(time);
    assertThat(
            new SweptCircle(n[0], n[1], n[2], 0, 0).timeToLine(0, 0, n[5], n[6], -n[3], -n[4], 1e9))
        .isEqualTo(time);
  }

  /** The square of a radius, or of a length, underflows, and what it is to take away does not. */
  @ParameterizedTest
  @CsvSource({
    "3e-160, 1.3e-160, -1e-160, -1e90, 0, 1e90, 0",
    "3e90, 1.3e90, -1e90, -1.3e-160, 0, 1.7e-160, 0",
    "3e90, 1.3e90, -1e90, -1.3e-163, 0, 1.7e-163, 0",
    "3, 1.3, -1, -1e-200, 0, 1e-200, 0",
    "3, 1.3, -1, -1e-320, 0, 1e-320, 0"
  })
  void squaresThatUnderflowAreNotTrusted(
      double py, double r, double vy, double ax, double ay, double bx, double by) {
    Fall fall = Falls.line(0, py, r, 0, vy, 0, 0, ax, ay, bx, by, 0, 0);
    double time = FallSweep.exactTime(fall, Contact.LEFT).nearest();
    assertThat(time).isCloseTo(1.7, within(1e-15));
    assertThat(new SweptCircle(0, py, r, 0, vy).timeToLine(ax, ay, bx, by, 9)).isEqualTo(time);
    assertThat(new SweptCircle(0, py, r, 0, vy).timeToLine(ax, ay, bx, by, 1.71)).isEqualTo(time);
  }
}
