// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.WallSweep;
import dev.carom.internal.util.KindNumber;

/**
 * The codec of codes: one int for a {@link KindNumber} and the index of an obstacle of that kind,
 * or the slot of a moving circle. Each kind has a range of codes. The ranges stand in the order in
 * which simultaneous impacts are resolved: walls, lines, pegs, moving circles. No code is negative.
 */
public final class Codes {

  /** The codes of the walls are their ids; the upper wall of an axis has the odd one. */
  public static final int LEFT = WallSweep.LEFT;

  public static final int RIGHT = WallSweep.RIGHT;
  public static final int BOTTOM = WallSweep.BOTTOM;
  public static final int TOP = WallSweep.TOP;

  /** The number of walls of bounds, which have the first codes, used or not. */
  public static final int WALLS = 4;

  /** Where the range of each {@link KindNumber} begins; the last one ends with the ints. */
  private static final int[] FIRST = {0, WALLS, 1 << 28, 1 << 29};

  private static final int FIRST_LINE = WALLS;
  private static final int FIRST_PEG = 1 << 28;
  private static final int FIRST_CIRCLE = 1 << 29;

  private static final int PART_SHIFT = 28;

  private static final int RANK_SHIFT = 31;

  /** How many parts there are, those of moving circles not counted. */
  static final int PARTS = FIRST_CIRCLE >>> PART_SHIFT;

  private Codes() {}

  /** The code of number i of a {@link KindNumber}. */
  public static int of(int kind, int i) {
    return FIRST[kind] + i;
  }

  public static int line(int i) {
    return FIRST_LINE + i;
  }

  public static int peg(int i) {
    return FIRST_PEG + i;
  }

  /** The code of the moving circle in a slot. */
  public static int circle(int slot) {
    return FIRST_CIRCLE + slot;
  }

  /** The {@link KindNumber} of a code. */
  public static int kind(int code) {
    return code < FIRST_LINE
        ? KindNumber.WALL
        : code < FIRST_PEG
            ? KindNumber.LINE
            : code < FIRST_CIRCLE ? KindNumber.PEG : KindNumber.CIRCLE;
  }

  /** The index of a code within its kind. */
  public static int index(int code) {
    return code < FIRST_LINE
        ? code
        : code < FIRST_PEG
            ? code - FIRST_LINE
            : code < FIRST_CIRCLE ? code - FIRST_PEG : code - FIRST_CIRCLE;
  }

  /**
   * The part of the range of all codes in which a code is: each kind but walls has parts of its
   * own, and walls share that of lines.
   */
  static int part(int code) {
    return code >>> PART_SHIFT;
  }

  /** The slot of a moving circle, by its code. */
  public static int slot(int circle) {
    return circle - FIRST_CIRCLE;
  }

  /**
   * The rank of an impact among those of one time, the lowest first: by the code of the obstacle or
   * circle that is hit, then by the circle that hits it.
   */
  public static long rank(int code, int circle) {
    return (long) code << RANK_SHIFT | circle;
  }

  /** How many codes a {@link KindNumber} has. */
  public static int limit(int kind) {
    return kind == KindNumber.CIRCLE
        ? Integer.MAX_VALUE - FIRST_CIRCLE + 1
        : FIRST[kind + 1] - FIRST[kind];
  }

  public static boolean isWall(int code) {
    return code < FIRST_LINE;
  }

  public static boolean isLine(int code) {
    return code >= FIRST_LINE && code < FIRST_PEG;
  }

  /** Whether a code belongs to a kind that comes after lines. */
  public static boolean isAfterLines(int code) {
    return code >= FIRST_PEG;
  }

  public static boolean isCircle(int code) {
    return code >= FIRST_CIRCLE;
  }

  /** Whether a wall stands at an x coordinate; else it lies at a y coordinate. */
  public static boolean isVertical(int wall) {
    return wall <= RIGHT;
  }

  /** Whether a wall is the lower one of its axis: left or bottom. */
  public static boolean isLower(int wall) {
    return (wall & 1) == 0;
  }

  /** Which way a wall faces on its axis: 1 for the lower one, -1 for the upper one. */
  public static int inwards(int wall) {
    return 1 - 2 * (wall & 1);
  }
}
