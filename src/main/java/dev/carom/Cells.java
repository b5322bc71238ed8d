// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * Which circles have their centre in which square cell: a list for each cell. Rows follow each
 * other on a ring of cells, so the plane needs no edge; far cells that share a list only make a
 * search look at a circle in vain.
 */
final class Cells {

  static final int NONE = -1;

  private final int columns;
  private final int[] heads;

  /** The follower of circle i is at first + (i << spread). */
  private final int[] next;

  private final int first;
  private final int spread;

  /** Null where lists are short: there a circle is found in its list by going through it. */
  private final int[] previous;

  /**
   * The numbers of columns and rows are powers of two, at least 4.
   *
   * @param next room for the followers of all circles
   * @param previous room for those before them, or null for short lists
   */
  Cells(int columns, int rows, int[] next, int[] previous) {
    this(columns, rows, next, 0, 0, previous);
  }

  /** Short lists; followers stand among the ints of circles that collide. */
  Cells(int columns, int rows, Circles circles) {
    this(
        columns,
        rows,
        circles.codes,
        Circles.collidingCodesAt(0) + Circles.FOLLOWER,
        Circles.COLLIDING_CODES_SHIFT,
        null);
  }

  private Cells(int columns, int rows, int[] next, int first, int spread, int[] previous) {
    this.columns = columns;
    heads = new int[columns * rows];
    Arrays.fill(heads, NONE);
    this.next = next;
    this.first = first;
    this.spread = spread;
    this.previous = previous;
  }

  void add(int i, int column, int row) {
    int cell = index(column, row);
    int head = heads[cell];
    next[at(i)] = head;
    if (previous != null) {
      previous[i] = NONE;
      if (head != NONE) {
        previous[head] = i;
      }
    }
    heads[cell] = i;
  }

  void remove(int i, int column, int row) {
    int before = previous == null ? before(i, column, row) : previous[i];
    int after = next[at(i)];
    if (before == NONE) {
      heads[index(column, row)] = after;
    } else {
      next[at(before)] = after;
    }
    if (previous != null && after != NONE) {
      previous[after] = before;
    }
  }

  private int before(int i, int column, int row) {
    int before = NONE;
    for (int j = heads[index(column, row)]; j != i; j = next[at(j)]) {
      before = j;
    }
    return before;
  }

  /**
   * Finds the first circles of a cell's list and of the eight around it. Most cells are empty or
   * hold one circle, and which is which cannot be foretold: what is found is written down first,
   * without a branch, and kept by counting on.
   *
   * @param found room for all circles and 9 more, from the place {@code size} on
   * @return the place after the last one found
   */
  int around(int column, int row, int[] found, int size) {
    int place = place(column, row);
    int end = row(place - columns, found, size);
    end = row(place, found, end);
    return row(place + columns, found, end);
  }

  /** The same around circle i; where that is the first of its list, its follower stands for it. */
  int others(int i, int column, int row, int[] found, int size) {
    int place = place(column, row);
    int end = row(place - columns, found, size);
    int a = heads[index(place - 1)];
    int b = heads[index(place)];
    int c = heads[index(place + 1)];
    int difference = b ^ i;
    int follower = next[at(i)];
    int same = ~((difference | -difference) >> 31);
    end = three(a, b ^ ((b ^ follower) & same), c, found, end);
    return row(place + columns, found, end);
  }

  /** The same for a cell and those a step before and after it. */
  int beside(int column, int row, int dx, int dy, int[] found, int size) {
    int place = place(column, row);
    int step = place(dx, dy);
    int a = heads[index(place - step)];
    int b = heads[index(place)];
    int c = heads[index(place + step)];
    return three(a, b, c, found, size);
  }

  private int row(int place, int[] found, int size) {
    int a = heads[index(place - 1)];
    int b = heads[index(place)];
    int c = heads[index(place + 1)];
    return three(a, b, c, found, size);
  }

  private static int three(int a, int b, int c, int[] found, int size) {
    found[size] = a;
    int end = size + 1 + (a >> 31);
    found[end] = b;
    end += 1 + (b >> 31);
    found[end] = c;
    return end + 1 + (c >> 31);
  }

  /** Adds those that follow in the lists, and returns the place after the last. */
  int follow(int[] found, int from, int to) {
    int end = to;
    for (int k = from; k < end; k++) {
      int follower = next[at(found[k])];
      found[end] = follower;
      end += 1 + (follower >> 31);
    }
    return end;
  }

  /** Writes down where the lists of a cell and of the eight around it stand. */
  void placesAround(int column, int row, int[] places, int from) {
    int end = from;
    for (int r = row - 1; r <= row + 1; r++) {
      places[end++] = index(column - 1, r);
      places[end++] = index(column, r);
      places[end++] = index(column + 1, r);
    }
  }

  /** The same of a cell, the one a step on, and the three that are next to it then. */
  void placesAhead(int column, int row, int dx, int dy, int[] places, int from) {
    int c = column + 2 * dx;
    int r = row + 2 * dy;
    places[from] = index(column, row);
    places[from + 1] = index(column + dx, row + dy);
    places[from + 2] = index(c - dy, r - dx);
    places[from + 3] = index(c, r);
    places[from + 4] = index(c + dy, r + dx);
  }

  /** Puts the first circle of each list, or NONE, where its place is written. */
  void firsts(int[] places, int from, int to) {
    for (int k = from; k < to; k++) {
      places[k] = heads[places[k]];
    }
  }

  private int at(int i) {
    return first + (i << spread);
  }

  private int index(int column, int row) {
    return index(place(column, row));
  }

  /** By the length, so that compilers know that it is in range. */
  private int index(int place) {
    return place & (heads.length - 1);
  }

  /** A cell's place if the ring had no end; of a step, how far it leads. */
  private int place(int column, int row) {
    return row * columns + column;
  }
}
