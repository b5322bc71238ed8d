// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.util.Index;

/** The links of the lists of a {@link CellGrid} with several levels, in arrays of their own. */
public final class CellLinks {

  public final CellGrid cells;
  private final int[] next;

  /** Null where lists are short: a circle is then found by walking its list. */
  private final int[] previous;

  /**
   * @param next for each circle the next one in its list
   * @param previous for each circle the one before it, or null for short lists
   */
  public CellLinks(CellGrid cells, int[] next, int[] previous) {
    this.cells = cells;
    this.next = next;
    this.previous = previous;
  }

  public void add(int i, int cell) {
    int first = cells.first(cell);
    next[i] = first;
    if (previous != null) {
      previous[i] = Index.NONE;
      if (first != Index.NONE) {
        previous[first] = i;
      }
    }
    cells.setFirst(cell, i);
  }

  public void remove(int i, int cell) {
    int before = previous == null ? before(i, cell) : previous[i];
    int after = next[i];
    if (before == Index.NONE) {
      cells.setFirst(cell, after);
    } else {
      next[before] = after;
    }
    if (previous != null && after != Index.NONE) {
      previous[after] = before;
    }
  }

  private int before(int i, int cell) {
    int before = Index.NONE;
    for (int j = cells.first(cell); j != i; j = next[j]) {
      before = j;
    }
    return before;
  }

  /** The circle after circle i in its list, or NONE. */
  int next(int i) {
    return next[i];
  }

  /** Finds all circles in a cell and in the eight around it, as {@link CellGrid#around}. */
  public int around(int cell, int[] found, int size) {
    return follow(found, size, cells.around(cell, found, size));
  }

  /** The same for a cell and those a step before and after it. */
  int beside(int cell, int step, int[] found, int size) {
    return follow(found, size, cells.beside(cell, step, found, size));
  }

  /** Adds the followers of the circles found, and returns the index after the last. */
  private int follow(int[] found, int from, int to) {
    int end = to;
    for (int k = from; k < end; k++) {
      int follower = next[found[k]];
      found[end] = follower;
      end += 1 + (follower >> 31);
    }
    return end;
  }
}
