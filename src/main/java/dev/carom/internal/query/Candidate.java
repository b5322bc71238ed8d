// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.ExactTime;
import dev.carom.internal.sweep.Hit;
import java.util.function.Supplier;

/**
 * An impact that may be the first one of a cast. Only its rounded time is computed at once.
 *
 * @param code the code of the obstacle or circle that is hit, see {@link Codes}
 * @param contact the detector's name of the contact, see {@code Contact}
 * @param time the correctly rounded time of impact
 * @param exactTime the exact time, computed only if rounded times leave the order open
 * @param hit the contact point and the normal, computed only for the first impact
 */
public record Candidate(
    int code, int contact, double time, Supplier<ExactTime> exactTime, Supplier<Hit> hit) {

  /** Whether it is exactly earlier than another one. */
  boolean isBefore(Candidate that) {
    return time < that.time
        || (time == that.time && exactTime.get().compare(that.exactTime.get()) < 0);
  }

  /** Whether it is exactly no later than the end maxTime of the window. */
  boolean isWithin(double maxTime) {
    return time < maxTime
        || (time == maxTime && exactTime.get().compare(ExactTime.of(maxTime)) <= 0);
  }
}
