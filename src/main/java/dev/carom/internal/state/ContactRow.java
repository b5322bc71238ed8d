// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * What contact knows of one circle, apart from its flight, in a row of doubles: some columns, then
 * its near pairs. This is the state that saves and restores; circles have their ids there.
 */
public final class ContactRow {

  // The momentum by mass, its rate of change, and the time to which it belongs.
  public static final int VX = 0;
  public static final int VY = 1;
  public static final int AX = 2;
  public static final int AY = 3;
  public static final int MOMENT = 4;

  // The clock: the length of a tick (0 before its start), its end, and that of an uncut one.
  public static final int TAU = 5;
  public static final int END = 6;
  public static final int DUE = 7;

  public static final int FRESH = 8;

  // Rest: where, since when, in which frame, and the load.
  public static final int CALM_X = 9;
  public static final int CALM_Y = 10;
  public static final int CALM_SINCE = 11;
  public static final int FRAME_X = 12;
  public static final int FRAME_Y = 13;
  public static final int LOAD = 14;

  /** Whether it lost a neighbour. */
  public static final int LOST = 15;

  // The list of near pairs: its place in the order (-1 unless it is awake), where it was listed,
  // its margin, when the list was made, how fast things move, and whether the list is good.
  public static final int RANK = 16;
  public static final int LIST_X = 17;
  public static final int LIST_Y = 18;
  public static final int MARGIN = 19;
  public static final int LIST_TIME = 20;
  public static final int FASTEST = 21;
  public static final int LISTED = 22;

  /** No member flies faster. */
  public static final int LONGEST = 23;

  /** In units of gravity: the rate at which the momentum is shown. */
  public static final int RISE = 24;

  /** How often the last tick was cut to a quarter. */
  public static final int CUTS = 25;

  /** The number of these columns. */
  public static final int SIZE = 26;

  // The columns of a pair: the id of the other circle (-1: a part of an obstacle), the key of the
  // part, the impulse, and two flags: whether it bore (1), whether the circle passes through (2).
  public static final int OTHER = 0;
  public static final int KEY = 1;
  public static final int IMPULSE = 2;
  public static final int FLAGS = 3;

  public static final int PAIR = 4;

  /** The most numbers of a row that a snapshot holds. */
  public static final int MOST = 1 << 24;

  private ContactRow() {}

  /** The number of near pairs in a row. */
  public static int pairs(double[] row) {
    return (row.length - SIZE) / PAIR;
  }
}
