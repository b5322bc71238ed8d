// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The contact of one circle, apart from its flight, in a row of doubles: some columns, then its
 * near pairs. Saves hold it, with ids of circles. {@code ContactCore} lists the columns once, and
 * an instance of this class saves or restores them, one after the other.
 */
public final class ContactRow {

  // The columns that others read, too. The clock: the length of a tick, its end, and that of an
  // uncut one; the place in the order of those awake, else -1; the margin.
  public static final int TAU = 5;
  public static final int END = 6;
  public static final int DUE = 7;
  public static final int RANK = 16;
  public static final int MARGIN = 19;

  /** The largest pull on any member, which decides what is slow. */
  public static final int PULL = 26;

  /** The number of columns. */
  public static final int SIZE = 27;

  // The columns of a pair: the id of the other circle (-1: a part of an obstacle), the key of the
  // part, the impulse, and two flags: whether it bore (1), whether the circle passes through (2).
  public static final int OTHER = 0;
  public static final int KEY = 1;
  public static final int IMPULSE = 2;
  public static final int FLAGS = 3;

  public static final int PAIR = 4;

  /** The most numbers of a row that a snapshot holds. */
  public static final int MOST = 1 << 24;

  private final double[] row;
  private final boolean reads;
  private int next;

  /** Begins with the first column of a row, which it reads or writes. */
  public ContactRow(double[] row, boolean reads) {
    this.row = row;
    this.reads = reads;
  }

  public boolean reads() {
    return reads;
  }

  /** The number of the next column: as read, or the given one, which is written. */
  public double number(double given) {
    return number(true, given);
  }

  /** As above, where a row has this column; the given number where it has none. */
  public double number(boolean has, double given) {
    int column = next++;
    if (has && !reads) {
      row[column] = given;
    }
    return has ? row[column] : given;
  }

  /** The number of near pairs in a row. */
  public static int pairs(double[] row) {
    return (row.length - SIZE) / PAIR;
  }
}
