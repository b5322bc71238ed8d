// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The exact answer to a question.
 *
 * @param part what is hit
 * @param moment when; null for a miss
 * @param normal the unit normal; null for a miss
 */
public record Contact(Part part, Moment moment, Normal normal) {
  /** Nothing is hit. */
  public static final Contact MISS = new Contact(Part.NONE, null, null);

  public boolean hit() {
    return part != Part.NONE;
  }

  /** The correctly rounded time of impact, infinite for a miss. */
  public double time() {
    return hit() ? moment.nearest() : Double.POSITIVE_INFINITY;
  }

  /** This contact if its time is in the window, else a miss. */
  Contact within(double end) {
    return !hit() || moment.within(end) ? this : MISS;
  }

  /** The greatest error of a component of a given normal; infinite if it is not a number. */
  public double normalError(double nx, double ny) {
    double error = normal.error(nx, ny);
    return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
  }
}
