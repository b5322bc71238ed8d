// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The exact answer to a question.
 *
 * @param part what is hit
 * @param moment when; null for a miss
 * @param normal the unit normal; null for a miss
 */
public record Contact(Part part, Moment moment, Normal normal) implements Truth {
  /** Nothing is hit. */
  public static final Contact MISS = new Contact(Part.NONE, null, null);

  @Override
  public double time() {
    return hit() ? moment.nearest() : Double.POSITIVE_INFINITY;
  }

  /** This contact if its time is in the window, else a miss. */
  Contact within(double end) {
    return !hit() || moment.within(end) ? this : MISS;
  }

  @Override
  public double errorInUlps(double candidate) {
    return moment.errorInUlps(candidate);
  }
}
