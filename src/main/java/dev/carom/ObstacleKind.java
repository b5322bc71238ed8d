// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.util.Kind;

/**
 * The kinds of things: what a circle hits, and what ids belong to. Simultaneous impacts are taken
 * in this order.
 */
public enum ObstacleKind {
  /** A wall of the bounds: number 0 is the left one, 1 the right, 2 the bottom, 3 the top one. */
  WALL,
  /** A line of the scene. */
  LINE,
  /** A peg of the scene. */
  PEG,
  /** Another moving circle. */
  CIRCLE;

  private static final ObstacleKind[] ALL = values();

  /** The kind with a given number, {@link #ordinal()}. */
  static ObstacleKind of(int number) {
    return ALL[number];
  }

  /** What messages call thing i of this kind. */
  String nameOf(int i) {
    return Kind.nameOf(ordinal(), i);
  }
}
