// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * Which circles have their centre in which square cell: a list for each cell. The plane is wrapped
 * around a torus of cells, so it needs no edge; far cells that share a list only make a search look
 * at a circle in vain.
 */
final class Cells {

  static final int NONE = -1;

  private final int maskX;
  private final int maskY;
  private final int shift;
  private final int[] heads;
  final int[] next;
  private final int[] previous;

  /** For circles 0..count - 1; the numbers of columns and rows are powers of two, at least 4. */
  Cells(int count, int columns, int rows) {
    maskX = columns - 1;
    maskY = rows - 1;
    shift = Integer.numberOfTrailingZeros(columns);
    heads = new int[columns * rows];
    Arrays.fill(heads, NONE);
    next = new int[count];
    previous = new int[count];
  }

  /** The first circle in a cell, whose followers are in {@link #next}, or NONE. */
  int first(int column, int row) {
    return heads[index(column, row)];
  }

  void add(int i, int column, int row) {
    int cell = index(column, row);
    int head = heads[cell];
    next[i] = head;
    previous[i] = NONE;
    if (head != NONE) {
      previous[head] = i;
    }
    heads[cell] = i;
  }

  void remove(int i, int column, int row) {
    if (previous[i] == NONE) {
      heads[index(column, row)] = next[i];
    } else {
      next[previous[i]] = next[i];
    }
    if (next[i] != NONE) {
      previous[next[i]] = previous[i];
    }
  }

  private int index(int column, int row) {
    return (column & maskX) | (row & maskY) << shift;
  }
}
