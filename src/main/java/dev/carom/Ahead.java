// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * Reads what the next events will need, for many of them at once: whom they concern, the lists of
 * the cells around, and the circles listed there. An event by itself waits for memory once for each
 * of these; the reads of many events do not depend on each other, so their waits overlap. Nothing
 * changes but what is in the cache.
 */
final class Ahead implements EventQueue.Outlook {

  /** From so many circles on their flights are more than a core's own cache holds: measured. */
  static final int LEAST_CIRCLES = 1 << 13;

  private final Circles circles;
  private final Neighbors neighbors;
  private final short[] kinds;
  private final int[] concerned = new int[2 * EventQueue.MOST_OUTLOOK];

  /** What was read comes together here, for else it need not be read. */
  @SuppressWarnings("UnusedVariable")
  private long sum;

  /** For circles with events of these kinds, as {@link Schedule} numbers them. */
  Ahead(Circles circles, Neighbors neighbors, short[] kinds) {
    this.circles = circles;
    this.neighbors = neighbors;
    this.kinds = kinds;
  }

  @Override
  public void next(int[] ids, int size) {
    long read = 0;
    for (int k = 0; k < size; k++) {
      concerned[k] = ids[k];
      read += flight(ids[k]) + kinds[ids[k]];
    }
    int end = size;
    for (int k = 0; k < size; k++) {
      if (kinds[ids[k]] == Schedule.PAIR) {
        concerned[end++] = circles.codes[Circles.collidingCodesAt(ids[k]) + Circles.PARTNER];
      }
    }
    for (int k = size; k < end; k++) {
      read += flight(concerned[k]);
    }
    for (int k = 0; k < end; k++) {
      read += lists(concerned[k]);
    }
    for (int k = 0; k < end; k++) {
      read += listed(concerned[k]);
    }
    sum += read;
  }

  private long flight(int i) {
    int a = Circles.collidingAt(i);
    return Double.doubleToRawLongBits(circles.state[a + Circles.X])
        + Double.doubleToRawLongBits(circles.state[a + Circles.MEETING])
        + circles.codes[Circles.collidingCodesAt(i)];
  }

  /** Reads the lists of cells around circle i, where it is or, if it crosses an edge, will be. */
  private int lists(int i) {
    int way = kinds[i] - Schedule.CROSSING;
    int column = neighbors.columnAfter(i, way);
    int row = neighbors.rowAfter(i, way);
    Cells cells = neighbors.cells(i);
    return (cells.head(column - 1, row - 1) + cells.head(column + 1, row - 1))
        + (cells.head(column - 1, row) + cells.head(column + 1, row))
        + (cells.head(column - 1, row + 1) + cells.head(column + 1, row + 1));
  }

  /** Reads the circles in these lists. */
  private long listed(int i) {
    int way = kinds[i] - Schedule.CROSSING;
    int column = neighbors.columnAfter(i, way);
    int row = neighbors.rowAfter(i, way);
    Cells cells = neighbors.cells(i);
    return row(cells, column, row - 1) + row(cells, column, row) + row(cells, column, row + 1);
  }

  private long row(Cells cells, int column, int row) {
    return first(cells, column - 1, row)
        + first(cells, column, row)
        + first(cells, column + 1, row);
  }

  private long first(Cells cells, int column, int row) {
    int j = Math.max(0, cells.head(column, row));
    return Double.doubleToRawLongBits(circles.state[Circles.collidingAt(j)]) + cells.next(j);
  }
}
