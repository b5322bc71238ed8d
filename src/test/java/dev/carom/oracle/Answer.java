// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The answer of a detector.
 *
 * @param time the time of impact, infinite for none
 * @param part the feature, {@link Part#NONE} for a miss
 * @param nx the normal; NaN for a miss
 * @param ny the normal; NaN for a miss
 */
public record Answer(double time, Part part, double nx, double ny) {
  /** Nothing is hit. */
  public static final Answer MISS =
      new Answer(Double.POSITIVE_INFINITY, Part.NONE, Double.NaN, Double.NaN);

  public boolean hit() {
    return part != Part.NONE;
  }
}
