// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.util.List;
import java.util.Locale;

/**
 * The cost of some ticks.
 *
 * @param ticks how many, at 60 a second
 * @param frames the frames that they went on, in all
 * @param nanos the time that the world took, in all
 */
record TickCost(int ticks, double frames, long nanos, long impacts) {

  private static final double TICKS_A_SECOND = 60;
  private static final double NANOS_A_MICRO = 1e3;

  /** Lines of text: what a frame and an impact take. */
  List<String> lines() {
    if (ticks == 0) {
      return List.of();
    }
    String frame = number(nanos / NANOS_A_MICRO / frames) + " µs a frame, between drawings";
    String rate = number(impacts / (double) ticks * TICKS_A_SECOND) + " impacts a second";
    return impacts == 0
        ? List.of(frame, rate)
        : List.of(frame, rate, number(nanos / (double) impacts) + " ns an impact");
  }

  /** Three digits or more. */
  static String number(double x) {
    return String.format(Locale.ROOT, x < 10 ? "%.2f" : x < 100 ? "%.1f" : "%,.0f", x);
  }
}
