// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import java.util.Locale;

/**
 * What a very long run of an elastic scene showed.
 *
 * @param escapes centres outside of the bounds at the end of a round, the most of all rounds
 * @param crossings flights of a centre, from impact to impact, through a line
 * @param overlaps pairs of colliding circles that are inside of each other at the end of a round,
 *     the most of all rounds
 * @param drift the energy's change relative to the start: of all circles together if they collide,
 *     else of the worst one
 */
public record SoakResult(
    SoakTimes times, long escapes, long crossings, long overlaps, double drift) {

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
    return times.render(
        String.format(
            Locale.ROOT,
            "escapes    %,d circles outside of the bounds%n"
                + "crossings  %,d flights through a line, %,d pairs inside of each other%n"
                + "energy     changed by %.1e of itself, at most %.0e expected%n",
            escapes,
            crossings,
            overlaps,
            drift,
            MOST_DRIFT));
  }
}
