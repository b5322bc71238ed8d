// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import java.util.Locale;

/**
 * What a very long run showed.
 *
 * @param impacts of the whole run
 * @param end the world's time at its end
 * @param escapes centres outside of the bounds at the end of a round, the most of all rounds
 * @param crossings flights of a centre, from impact to impact, through a line
 * @param overlaps pairs of colliding circles that are inside of each other at the end of a round,
 *     the most of all rounds
 * @param drift the energy's change relative to the start: of all circles together if they collide,
 *     else of the worst one
 * @param heapAtStart bytes in use after the first round
 * @param heapAtEnd bytes in use after the last one
 * @param nanosAtStart nanoseconds of the processor per impact: the median of the four rounds after
 *     the first, which warms up
 * @param nanosAtEnd the median of the last four rounds
 * @param leastNanos the least of all rounds but the first
 * @param mostNanos the most of them
 */
public record SoakResult(
    long impacts,
    double end,
    long escapes,
    long crossings,
    long overlaps,
    double drift,
    long heapAtStart,
    long heapAtEnd,
    double nanosAtStart,
    double nanosAtEnd,
    double leastNanos,
    double mostNanos) {

  /** The energy may have changed by so much. */
  public static final double MOST_DRIFT = 1e-11;

  /**
   * Whether nothing got through, and the energy is what it was. Times and heap are for a person.
   */
  public boolean holds() {
    return escapes == 0 && crossings == 0 && overlaps == 0 && Math.abs(drift) <= MOST_DRIFT;
  }

  /** A line for each figure. */
  public String render() {
    return String.format(
        Locale.ROOT,
        "impacts    %,d, to time %,.0f%n"
            + "escapes    %,d circles outside of the bounds%n"
            + "crossings  %,d flights through a line, %,d pairs inside of each other%n"
            + "energy     changed by %.1e of itself, at most %.0e expected%n"
            + "heap       %,d KiB in use at the start, %,d KiB at the end%n"
            + "CPU time   %,.1f ns per impact at the start, %,.1f ns at the end (rounds %,.1f .. %,.1f)%n",
        impacts,
        end,
        escapes,
        crossings,
        overlaps,
        drift,
        MOST_DRIFT,
        heapAtStart >> 10,
        heapAtEnd >> 10,
        nanosAtStart,
        nanosAtEnd,
        leastNanos,
        mostNanos);
  }
}
