// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** The later entries of an accelerated disk into a line or a disk, by examples. */
class LaterEntryTest {
  private static final double NEVER = Double.POSITIVE_INFINITY;

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
}
