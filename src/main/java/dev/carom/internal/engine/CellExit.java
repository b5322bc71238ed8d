// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

/**
 * Where a circle leaves a cell: when, and over which edge.
 *
 * <p>The edge and the level of the cell are one int, a <i>way</i>: bit 0 is set for an exit towards
 * smaller coordinates, bit 1 for an exit up or down, and the level stands above them. Which way
 * comes next is unpredictable, so everything here is branch-free.
 */
final class CellExit {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static final long ONE = Double.doubleToRawLongBits(1);

  private static final int NEGATIVE = 1;
  private static final int VERTICAL = 2;
  private static final int LEVEL_SHIFT = 2;

  private CellExit() {}

  /**
   * The way in which a circle leaves a cell of a level.
   *
   * @param dx how long it takes to the edge ahead on its left or right
   * @param dy how long it takes to the edge ahead above or below
   */
  static int way(int level, double dx, double dy, double vx, double vy) {
    // All bits are set if the exit is up or down; then v is vy, else vx.
    long vertical = Double.doubleToRawLongBits(dy - dx) >> 63;
    long horizontal = Double.doubleToRawLongBits(vx);
    long v = horizontal ^ ((horizontal ^ Double.doubleToRawLongBits(vy)) & vertical);
    return level << LEVEL_SHIFT | (int) ((vertical & VERTICAL) | (v >>> 63));
  }

  /**
   * How long a circle takes on one axis to the edge of its cell that is ahead.
   *
   * @param p its place, from the origin of the cells
   * @param cell the column or the row of the cell
   */
  static double untilEdge(double p, double v, double cell, CellAxis axis) {
    double way = edge(v, cell, axis) - p;
    return v != 0 ? way / v : NEVER;
  }

  /** The edge of a cell towards which a velocity points, on one axis. */
  static double edge(double v, double cell, CellAxis axis) {
    return axis.edge(cell + oneIfPositive(v)); // a cell ends where the next one begins
  }

  /** 1, or 0 if v has a minus sign. */
  private static double oneIfPositive(double v) {
    return Double.longBitsToDouble(ONE & ~(Double.doubleToRawLongBits(v) >> 63));
  }

  /** The level of the cell that is left. */
  static int level(int way) {
    return way >> LEVEL_SHIFT;
  }

  /** All bits for an exit up or down, no bit for one to the left or right. */
  static int vertical(int way) {
    return -((way & VERTICAL) >> 1);
  }

  /** 1 for an exit towards larger coordinates, -1 towards smaller ones. */
  static int sign(int way) {
    return 1 - ((way & NEGATIVE) << 1);
  }

  /** How many columns further the next cell is: 1, 0 or -1. */
  static int columns(int way) {
    return sign(way) & ~vertical(way);
  }

  /** How many rows further the next cell is: 1, 0 or -1. */
  static int rows(int way) {
    return sign(way) & vertical(way);
  }
}
