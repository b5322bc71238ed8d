// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * Which circles have their centre in which square cell: a list for each cell. Rows follow each
 * other on a ring of cells, so the plane needs no edge; far cells that share a list only make a
 * search look at a circle in vain. A cell is named by its {@link #cell}.
 *
 * <p>Here stand the first circles of the lists. Who follows stands among the ints of circles that
 * collide, and is found by going through the list; or, where lists may be long, in {@link
 * CellLinks}.
 */
public final class CellGrid {

  private static final int NONE = Index.NONE;

  private final int columns;
  private final int[] heads;

  /** The numbers of columns and rows are powers of two, at least 4. */
  public CellGrid(int columns, int rows) {
    this.columns = columns;
    heads = new int[columns * rows];
    Arrays.fill(heads, NONE);
  }

  /** A cell's place if the ring had no end. */
  public int cell(int column, int row) {
    return row * columns + column;
  }

  /** How far a step leads to the right, or, where vertical is -1 instead of 0, up. */
  public int step(int vertical) {
    return 1 ^ ((1 ^ columns) & vertical);
  }

  public int first(int cell) {
    return heads[index(cell)];
  }

  void setFirst(int cell, int i) {
    heads[index(cell)] = i;
  }

  /** Lists circle i, with the ints of all circles in hand. */
  public void add(int[] codes, int i, int cell) {
    int at = index(cell);
    codes[follower(i)] = heads[at];
    heads[at] = i;
  }

  /** Takes circle i off its list. */
  public void remove(int[] codes, int i, int cell) {
    int at = index(cell);
    int after = codes[follower(i)];
    int j = heads[at];
    if (j == i) {
      heads[at] = after;
      return;
    }
    while (codes[follower(j)] != i) {
      j = codes[follower(j)];
    }
    codes[follower(j)] = after;
  }

  private static int follower(int i) {
    return CircleTable.collidingCodesAt(i) + CircleTable.FOLLOWER;
  }

  /**
   * Finds the first circles of a cell's list and of the eight around it. Most cells are empty or
   * hold one circle, and which is which cannot be foretold: what is found is written down first,
   * without a branch, and kept by counting on.
   *
   * @param found room for all circles and 9 more, from the place {@code size} on
   * @return the place after the last one found
   */
  public int around(int cell, int[] found, int size) {
    int end = row(cell - columns, found, size);
    end = row(cell, found, end);
    return row(cell + columns, found, end);
  }

  /** The same around circle i; where that is the first of its list, its follower stands for it. */
  public int others(int[] codes, int i, int cell, int[] found) {
    int end = row(cell - columns, found, 0);
    int a = heads[index(cell - 1)];
    int b = heads[index(cell)];
    int c = heads[index(cell + 1)];
    int difference = b ^ i;
    int follower = codes[follower(i)];
    int same = ~((difference | -difference) >> 31);
    end = three(a, b ^ ((b ^ follower) & same), c, found, end);
    return row(cell + columns, found, end);
  }

  /** The same for a cell and those a step before and after it. */
  public int beside(int cell, int step, int[] found, int size) {
    int a = heads[index(cell - step)];
    int b = heads[index(cell)];
    int c = heads[index(cell + step)];
    return three(a, b, c, found, size);
  }

  private int row(int cell, int[] found, int size) {
    return beside(cell, 1, found, size);
  }

  private static int three(int a, int b, int c, int[] found, int size) {
    found[size] = a;
    int end = size + 1 + (a >> 31);
    found[end] = b;
    end += 1 + (b >> 31);
    found[end] = c;
    return end + 1 + (c >> 31);
  }

  /** Writes down where the lists of a cell and of the eight around it stand. */
  public void placesAround(int column, int row, int[] places, int from) {
    int end = from;
    for (int r = row - 1; r <= row + 1; r++) {
      places[end++] = index(column - 1, r);
      places[end++] = index(column, r);
      places[end++] = index(column + 1, r);
    }
  }

  /** The same of a cell, the one a step on, and the three that are next to it then. */
  public void placesAhead(int column, int row, int dx, int dy, int[] places, int from) {
    int c = column + 2 * dx;
    int r = row + 2 * dy;
    places[from] = index(column, row);
    places[from + 1] = index(column + dx, row + dy);
    places[from + 2] = index(c - dy, r - dx);
    places[from + 3] = index(c, r);
    places[from + 4] = index(c + dy, r + dx);
  }

  /** Puts the first circle of each list, or NONE, where its place is written. */
  public void firsts(int[] places, int from, int to) {
    for (int k = from; k < to; k++) {
      places[k] = heads[places[k]];
    }
  }

  private int index(int column, int row) {
    return index(cell(column, row));
  }

  /** By the length, so that compilers know that it is in range. */
  private int index(int cell) {
    return cell & (heads.length - 1);
  }
}
