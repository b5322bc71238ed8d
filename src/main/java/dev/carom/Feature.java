// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * A {@code Feature} is the part of an obstacle that is hit. For a line it is the Voronoi region in
 * which the centre of the circle lies at contact.
 *
 * <p><img src="doc-files/line.svg" alt="Beside the line is its side; beyond the perpendiculars at
 * its ends a and b are its start and its end" style="max-width:100%">
 */
public enum Feature {
  /** The inside of a line, ends excluded, from either side; also a wall of bounds. */
  SIDE,
  /** The first end (ax, ay) of a line: the centre projects on it or before it. */
  START,
  /** The second end (bx, by) of a line: the centre projects on it or beyond it. */
  END,
  /** A peg, or another moving circle. */
  CIRCLE;

  private static final Feature[] ALL = values();

  /** Returns the feature with a given number, {@link #ordinal()}. */
  static Feature of(int number) {
    return ALL[number];
  }
}
