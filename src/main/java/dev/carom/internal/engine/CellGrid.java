// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * A grid of square cells, each with a list of the circles whose centre is in it. The cells of the
 * plane are wrapped onto an array: row after row on a ring. So the grid has no edge; distant cells
 * may share a list, which only adds candidates to a search. A cell is named by its number before
 * wrapping, see {@link #cell}.
 *
 * <p>This class holds the first circle of each list. The next one stands in the row of the circle,
 * {@link CircleTable#FOLLOWER}, or in {@link CellLinks} where lists may be long.
 */
public final class CellGrid {

  private static final int NONE = Index.NONE;

  private final int columns;
  private final int[] heads;

  /** A grid without circles; columns and rows are powers of two, at least 4. */
  public CellGrid(int columns, int rows) {
    this.columns = columns;
    heads = new int[columns * rows];
    Arrays.fill(heads, NONE);
  }

  int columns() {
    return columns;
  }

  int rows() {
    return heads.length / columns;
  }

  /** The number of a cell, before it is wrapped onto the ring. */
  public int cell(int column, int row) {
    return row * columns + column;
  }

  /** The difference of numbers from a cell to the one on its right; for vertical -1, above. */
  public int step(int vertical) {
    return 1 ^ ((1 ^ columns) & vertical);
  }

  public int first(int cell) {
    return heads[index(cell)];
  }

  void setFirst(int cell, int i) {
    heads[index(cell)] = i;
  }

  /** Adds circle i to the list of a cell; {@code codes} are the ints of all circles. */
  public void add(int[] codes, int i, int cell) {
    int at = index(cell);
    codes[follower(i)] = heads[at];
    heads[at] = i;
  }

  /** Removes circle i from the list of a cell. */
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
   * Finds the first circles of the lists of a cell and of the eight around it. Most lists are empty
   * or hold one circle, unpredictably. So every head is written, branch-free, and the count goes up
   * only for those that are circles.
   *
   * @param found room for all circles and 9 more, from index {@code size} on
   * @return the index after the last one found
   */
  public int around(int cell, int[] found, int size) {
    int end = row(cell - columns, found, size);
    end = row(cell, found, end);
    return row(cell + columns, found, end);
  }

  /** The same around circle i; its follower is found instead of itself, if it heads its list. */
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

  /** Writes the indices of the lists of a cell and of the eight around it. */
  public void listsAround(int column, int row, int[] lists, int from) {
    int end = from;
    for (int r = row - 1; r <= row + 1; r++) {
      lists[end++] = index(column - 1, r);
      lists[end++] = index(column, r);
      lists[end++] = index(column + 1, r);
    }
  }

  /** The same of a cell, of the next one in a direction, and of the three beyond that. */
  public void listsAhead(int column, int row, int dx, int dy, int[] lists, int from) {
    int c = column + 2 * dx;
    int r = row + 2 * dy;
    lists[from] = index(column, row);
    lists[from + 1] = index(column + dx, row + dy);
    lists[from + 2] = index(c - dy, r - dx);
    lists[from + 3] = index(c, r);
    lists[from + 4] = index(c + dy, r + dx);
  }

  /** Replaces each index of a list by the first circle of that list, or NONE. */
  public void firsts(int[] lists, int from, int to) {
    for (int k = from; k < to; k++) {
      lists[k] = heads[lists[k]];
    }
  }

  private int index(int column, int row) {
    return index(cell(column, row));
  }

  /** The index of a list; masked by the length, so that compilers drop the range check. */
  private int index(int cell) {
    return cell & (heads.length - 1);
  }
}
