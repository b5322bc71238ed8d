// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

/** The kinds of obstacles and circles. The values equal the ordinals of the public enum. */
public final class KindNumber {

  public static final int WALL = 0;
  public static final int LINE = 1;
  public static final int PEG = 2;
  public static final int CIRCLE = 3;

  private static final String[] NAMES = {"wall", "line", "peg", "circle"};

  private KindNumber() {}

  /** The name of thing i of a kind in messages, as "line 3". */
  public static String nameOf(int kind, int i) {
    return NAMES[kind] + " " + i;
  }
}
