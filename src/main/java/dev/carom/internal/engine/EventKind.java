// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

/** The kinds of events among circles that collide. */
public final class EventKind {

  /** A circle meets something that stands still, or the end of what is known of that. */
  static final int STATIC = 0;

  /** A circle meets another one. */
  static final int PAIR = 1;

  /** A circle is to be looked at anew after an edit. */
  static final int EDIT = 2;

  /** A circle leaves its cell; this kind and those above it tell over which edge. */
  public static final int CROSSING = 3;

  private EventKind() {}
}
