// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import java.util.Locale;

/**
 * How long a very long run was, and what it took.
 *
 * @param end the world's time at its end
 * @param heapAtStart bytes in use after the first round
 * @param heapAtEnd bytes in use after the last one
 * @param nanosAtStart nanoseconds of the processor per impact: the median of the four rounds after
 *     the first, which warms up
 * @param nanosAtEnd the median of the last four rounds
 * @param leastNanos the least of all rounds but the first
 * @param mostNanos the most of them
 */
public record SoakTimes(
    long impacts,
    double end,
    long heapAtStart,
    long heapAtEnd,
    double nanosAtStart,
    double nanosAtEnd,
    double leastNanos,
    double mostNanos) {

  /** A line for each figure. */
  public String render() {
    return String.format(
        Locale.ROOT,
        "impacts    %,d, to time %,.0f%n"
            + "heap       %,d KiB in use at the start, %,d KiB at the end%n"
            + "CPU time   %,.1f ns per impact at the start, %,.1f ns at the end (rounds %,.1f .. %,.1f)%n",
        impacts,
        end,
        heapAtStart >> 10,
        heapAtEnd >> 10,
        nanosAtStart,
        nanosAtEnd,
        leastNanos,
        mostNanos);
  }
}
