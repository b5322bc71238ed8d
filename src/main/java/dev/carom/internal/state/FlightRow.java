// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The columns of a flight: its start position, velocity, start time, and the radius of the circle.
 * A row of any array of flights begins with them, in this order.
 */
public final class FlightRow {

  public static final int X = 0;
  public static final int Y = 1;
  public static final int VX = 2;
  public static final int VY = 3;

  /** The time of the start, as head and tail. */
  public static final int T = 4;

  public static final int TL = 5;
  public static final int RADIUS = 6;

  /** The number of columns. */
  public static final int SIZE = 7;

  private FlightRow() {}

  /** Writes the flight of a circle to the row that begins at k. */
  static void put(MovingCircle m, double[] rows, int k) {
    // The first and the last column first: then compilers check the range of the others with them.
    rows[k + X] = m.x;
    rows[k + RADIUS] = m.radius;
    rows[k + Y] = m.y;
    rows[k + VX] = m.vx;
    rows[k + VY] = m.vy;
    rows[k + T] = m.t;
    rows[k + TL] = m.tl;
  }

  /** Reads the flight of a circle from the row that begins at k. */
  static void get(MovingCircle m, double[] rows, int k) {
    m.x = rows[k + X];
    m.radius = rows[k + RADIUS];
    m.y = rows[k + Y];
    m.vx = rows[k + VX];
    m.vy = rows[k + VY];
    m.t = rows[k + T];
    m.tl = rows[k + TL];
  }
}
