// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

/** The kinds of events among circles that collide. */
public final class EventKind {

  /** A circle hits a static obstacle, or its prediction of the next one ends. */
  static final int STATIC = 0;

  /** Two circles collide. */
  static final int PAIR = 1;

  /** A circle needs a new prediction after an edit. */
  static final int EDIT = 2;

  /**
   * A circle leaves its cell. This value and those above it also encode the way, see {@link
   * CellExit}.
   */
  public static final int CROSSING = 3;

  private EventKind() {}
}
