// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.Codes;

/**
 * The list of obstacles in a cell of a {@link Grid}, packed into a long:
 *
 * <ul>
 *   <li>0: an empty list.
 *   <li>Above 0: a pair of lines, 31 bits for the code of each. A line alone stands twice.
 *   <li>Below 0, the second code not 0: a pair of other obstacles.
 *   <li>Below 0, the second code 0: a longer list. The first code is its start in {@link
 *       Grid#pairs}.
 * </ul>
 *
 * <p>A longer list is a run of pairs, each of lines or of other obstacles. The sign is set in all
 * but the last pair.
 */
final class CellList {

  /** Marks the ring of cells outside of the grid, in place of a list. */
  static final long OUTSIDE = Long.MIN_VALUE;

  /** An empty list. */
  static final long EMPTY = 0;

  private static final long SIGN = Long.MIN_VALUE;

  private CellList() {}

  /** A pair of lines: two codes, the first one in the low bits. */
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
  static boolean isPairOfLines(long list) {
    return list >= 0;
  }

  /** Whether a pair, or a list that is no pair of lines, is a pair of other obstacles. */
  static boolean areOthers(long pair) {
    return Codes.isAfterLines(second(pair));
  }

  /** The start of a longer list. */
  static int start(long list) {
    return (int) list;
  }

  /** Code 0 or 1 of a pair of lines, branch-free. */
  static int code(long pair, int number) {
    return (int) (pair >>> (number * Integer.SIZE));
  }

  static int first(long pair) {
    return (int) pair;
  }

  static int second(long pair) {
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
  static boolean isMore(long pair) {
    return pair < 0;
  }
}
