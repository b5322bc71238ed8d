// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.KindNumber;

/**
 * The kind of a thing: of that which a circle hits, and of the circle itself. Ids of each kind
 * count from 0. Of simultaneous impacts, those of the first kind in this list come first, after the
 * contacts that change nothing: with sensors, and of two circles of infinite mass.
 */
public enum Kind {
  /** A wall of the bounds: number 0 is the left one, 1 the right, 2 the bottom, 3 the top one. */
  WALL,
  /** A line of the scene. */
  LINE,
  /** A peg of the scene. */
  PEG,
  /** Another moving circle. */
  CIRCLE;

  private static final Kind[] ALL = values();

  /** Returns the kind with a given number, {@link #ordinal()}. */
  static Kind of(int number) {
    return ALL[number];
  }

  /** Returns the name that messages use for thing i of this kind. */
  String nameOf(int i) {
    return KindNumber.nameOf(ordinal(), i);
  }
}
