// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** The later entries of an accelerated disk into a line or a disk, by examples. */
class LaterEntryTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** A disk of radius 1 thrown up with 8 from a height, g = -2, beside the line y = 0. */
  private static double line(double y, double vx, double s, double T) {
    return Falls.timeOfLineAfter(0, y, 1, vx, 8, 0, -2, -9, 0, 9, 0, 0, 0, s, T);
  }

  private static double disk(double y, double s, double T) {
    return Falls.timeOfDiskAfter(0, y, 1, 0, 8, 0, -2, 0, 0, 0, 0, 0, s, T);
  }

  /** From -8, at -1 after 1, at 1 between, at 8 after 4, at 1 again after 4 + sqrt 7. */
  @Test
  void aThrownDiskEntersALineTwice() {
    double down = 4 + Math.sqrt(7);
    assertThat(line(-8, 0, -1, NEVER)).isEqualTo(1);
    assertThat(line(-8, 0, 0.5, NEVER)).isEqualTo(1);
    assertThat(line(-8, 0, Math.nextDown(1.0), NEVER)).isEqualTo(1);
    assertThat(line(-8, 0, 1, NEVER)).isEqualTo(down);
    assertThat(line(-8, 0, 1.01, NEVER)).isEqualTo(down);
    assertThat(line(-8, 0, 5, NEVER)).isEqualTo(down);
    assertThat(line(-8, 0, 1, 6)).isEqualTo(NEVER);
    assertThat(line(-8, 0, down, NEVER)).isEqualTo(NEVER);
    assertThat(line(-8, 0, 6.7, NEVER)).isEqualTo(NEVER);
    assertThat(disk(-8, -1, NEVER)).isEqualTo(1);
    assertThat(disk(-8, 1, NEVER)).isEqualTo(down);
    assertThat(disk(-8, down, NEVER)).isEqualTo(NEVER);
  }

  @Test
  void contactAtTheStartIsNoEntry() {
    assertThat(line(-1, 0, -1, NEVER)).isBetween(7.7, 7.8); // touches, and enters
    assertThat(line(0.5, 0, -1, NEVER)).isBetween(7.9, 8.0);
    assertThat(disk(-1, -1, NEVER)).isBetween(7.7, 7.8);
    assertThat(disk(0.5, 0, NEVER)).isBetween(7.9, 8.0);
    assertThat(disk(0.5, 0, 7)).isEqualTo(NEVER);
  }

  /** It drifts beyond the end while it is above the line, and falls past or onto that end. */
  @Test
  void theSecondEntryMayBeAtAnEnd() {
    assertThat(line(-8, 2, 1, NEVER)).isEqualTo(NEVER);
    double drift = 9.6 / (4 + Math.sqrt(7));
    double onEnd = line(-8, drift, 1, NEVER);
    assertThat(onEnd).isBetween(6.65, 6.75);
    int contact = Falls.contact(0, -8, 1, drift, 8, 0, -2, -9, 0, 9, 0, 0, 0, onEnd);
    assertThat(contact).isEqualTo(Contact.END);
  }

  @Test
  void aStraightFlightEntersOnce() {
    assertThat(Falls.timeOfDiskAfter(0, -3, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 9)).isEqualTo(1);
    assertThat(Falls.timeOfDiskAfter(0, -3, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 9)).isEqualTo(NEVER);
    assertThat(Falls.timeOfDiskAfter(0, -2, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 9)).isEqualTo(NEVER);
    assertThat(Falls.timeOfLineAfter(0, -3, 1, 0, 1, 0, 0, -9, 0, 9, 0, 0, -1, -1, 9)).isEqualTo(1);
    assertThat(Falls.timeOfLineAfter(0, -3, 1, 0, 1, 0, 0, -9, 0, 9, 0, 0, -1, 1, 9))
        .isEqualTo(NEVER);
    assertThat(Falls.timeOfLineAfter(0, -1, 1, 0, 1, 0, 0, -9, 0, 9, 0, 0, -1, -1, 9))
        .isEqualTo(NEVER);
  }

  /**
   * At 4 the centre is highest beside the line, at just the radius, and passes there from the
   * region of the start to that of the side. The gap of the start falls to 0 and no further; that
   * of the side comes to 0 from below.
   */
  @Test
  void anEntryWhereTheCentrePassesToTheSideIsSeen() {
    for (double after : new double[] {-1, 1.6}) {
      assertThat(
              Falls.timeOfLineAfter(334, -1005, 363, 16, 258, -4, -4, 3, -5, 3, 3, 0, 0, after, 8))
          .isEqualTo(4);
    }
  }

  @Test
  void aGrazeIsNoEntry() {
    // At 1 exactly at the top of its flight.
    assertThat(Falls.timeOfDiskAfter(0, -17, 1, 0, 8, 0, -2, 0, 0, 0, 0, 0, -1, NEVER))
        .isEqualTo(NEVER);
    assertThat(Falls.timeOfLineAfter(0, -17, 1, 0, 8, 0, -2, -9, 0, 9, 0, 0, 0, -1, NEVER))
        .isEqualTo(NEVER);
    assertThat(Falls.timeOfLineAfter(0, -17, 1, 0, 8, 0, -2, 0, 0, 0, 0, 0, 0, -1, NEVER))
        .isEqualTo(NEVER);
  }
}
