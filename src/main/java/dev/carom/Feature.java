// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The part of an obstacle that is hit: for a line, the Voronoi region in which the centre of the
 * circle lies at contact.
 *
 * <p><img src="doc-files/line.svg" alt="Beside the line is its side; beyond the perpendiculars at
 * its ends a and b are its start and its end" style="max-width:100%">
 */
public enum Feature {
  /** The open inside of a line, from either side; also a wall of bounds. */
  SIDE,
  /** The first end (ax, ay) of a line: the centre projects on it or before it. */
  START,
  /** The second end (bx, by) of a line: the centre projects on it or beyond it. */
  END,
  /** A peg, a single endpoint, or another moving circle. */
  CIRCLE;

  private static final Feature[] ALL = values();

  /** The feature with a given number, {@link #ordinal()}. */
  static Feature of(int number) {
    return ALL[number];
  }
}
