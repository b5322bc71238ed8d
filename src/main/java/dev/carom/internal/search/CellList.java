// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.Codes;

/**
 * What a cell of a {@link Grid} lists, in a long. Above 0 it is a pair of lines, 31 bits for the
 * code of each; a line alone stands twice. 0, twice the code of a wall, stands for nothing. Below 0
 * it is a pair of other obstacles; or the place where a longer list starts in {@link Grid#pairs},
 * with 0 in place of the second code.
 *
 * <p>In a longer list the pairs follow each other, of lines and of others, the sign set in all but
 * the last one.
 */
public final class CellList {

  /** In place of a list: outside of the grid, which one ring of such cells surrounds. */
  static final long OUTSIDE = Long.MIN_VALUE;

  /** An empty list. */
  static final long EMPTY = 0;

  private static final long SIGN = Long.MIN_VALUE;

  private CellList() {}

  /** A pair of lines: two codes, the first one lowest. */
  static long pair(int first, int second) {
    return ((long) second << Integer.SIZE) | first;
  }

  /** A list of one pair: of lines, or of other obstacles. */
  static long ofPair(int first, int second) {
    return (Codes.isLine(second) ? 0 : SIGN) | pair(first, second);
  }

  /** A list that starts at a place, which is above 0. */
  static long startingAt(int place) {
    return SIGN | place;
  }

  /** Whether a list is a pair of lines, or empty. */
  public static boolean isPairOfLines(long list) {
    return list >= 0;
  }

  /** Whether a pair, or a list that is no pair of lines, is a pair of other obstacles. */
  public static boolean areOthers(long pair) {
    return Codes.isAfterLines(second(pair));
  }

  /** Where a longer list starts. */
  public static int start(long list) {
    return (int) list;
  }

  /** The code that is number 0 or 1 of a pair of lines, without a branch. */
  static int code(long pair, int number) {
    return (int) (pair >>> (number * Integer.SIZE));
  }

  public static int first(long pair) {
    return (int) pair;
  }

  public static int second(long pair) {
    return (int) (pair >>> Integer.SIZE) & Integer.MAX_VALUE;
  }

  // In a longer list.

  /** A pair that another one follows. */
  static long withMore(int first, int second) {
    return SIGN | pair(first, second);
  }

  /** A pair that none follows. */
  static long withoutMore(long pair) {
    return pair & ~SIGN;
  }

  /** Whether another pair follows. */
  public static boolean isMore(long pair) {
    return pair < 0;
  }
}
