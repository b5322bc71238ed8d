// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.List;

/**
 * The exact answer to a question.
 *
 * @param part what is hit
 * @param moment when; null for a miss
 * @param normals the unit normal, none for a miss; more than one only for walls whose times round
 *     to the same double, which are simultaneous
 */
public record Contact(Part part, Moment moment, List<Normal> normals) {
  /** Nothing is hit. */
  public static final Contact MISS = new Contact(Part.NONE, null, List.of());

  /** A hit. */
  static Contact of(Part part, Moment moment, Normal normal) {
    return new Contact(part, moment, List.of(normal));
  }

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
    return normals.stream()
        .mapToDouble(normal -> normal.error(nx, ny))
        .filter(error -> !Double.isNaN(error))
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }
}
