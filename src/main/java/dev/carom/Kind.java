// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/** The kinds of things, by the ordinals of the public ones. */
final class Kind {

  static final int WALL = 0;
  static final int LINE = 1;
  static final int PEG = 2;
  static final int CIRCLE = 3;

  private static final String[] NAMES = {"wall", "line", "peg", "circle"};

  private Kind() {}

  /** What messages call thing i of a kind. */
  static String nameOf(int kind, int i) {
    return NAMES[kind] + " " + i;
  }
}
