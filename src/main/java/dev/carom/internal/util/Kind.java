// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/** The kinds of things, by the ordinals of the public ones. */
public final class Kind {

  public static final int WALL = 0;
  public static final int LINE = 1;
  public static final int PEG = 2;
  public static final int CIRCLE = 3;

  private static final String[] NAMES = {"wall", "line", "peg", "circle"};

  private Kind() {}

  /** What messages call thing i of a kind. */
  public static String nameOf(int kind, int i) {
    return NAMES[kind] + " " + i;
  }
}
