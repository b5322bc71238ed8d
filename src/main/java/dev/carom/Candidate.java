// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Optional;
import java.util.function.Supplier;

/**
 * An impact that may be the first one of a cast. Only its rounded time is computed at once.
 *
 * @param time the correctly rounded time of impact
 * @param exactTime the exact one, asked for where the rounded one leaves the order open
 * @param impact the impact itself, asked for if it is the first one
 */
record Candidate(double time, Supplier<ExactTime> exactTime, Supplier<Impact> impact) {

  /** The same of a thing under its id. */
  Candidate of(ObstacleKind itsKind, int itsId) {
    return new Candidate(time, exactTime, () -> impact.get().of(itsKind, itsId));
  }

  /** Whether it is exactly earlier than another one. */
  boolean isBefore(Candidate that) {
    return time < that.time
        || (time == that.time && exactTime.get().compare(that.exactTime.get()) < 0);
  }

  /** The impact, empty if it is exactly later than the end T of the window. */
  Optional<Impact> until(double T) {
    boolean within = time < T || (time == T && exactTime.get().compare(ExactTime.of(T)) <= 0);
    return within ? Optional.of(impact.get()) : Optional.empty();
  }
}
