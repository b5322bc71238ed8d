// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static dev.carom.internal.exact.Fma.fma;

/**
 * Where a circle that falls leaves a cell, on one axis. It may turn back once: until then it moves
 * against gravity, from then on along it. An edge is passed once in each direction.
 */
final class FallingExit {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * While an axis keeps more than this part of its first speed, it is certainly before {@code -v /
   * g}, even as rounded.
   */
  private static final double GOING_ON = 0x1p-50;

  /** How long after the start of the flight it leaves the cell. */
  double after;

  /** 1 if it leaves towards larger coordinates, else -1. */
  double direction;

  /**
   * How long after the start of its flight a circle leaves a cell in the direction in which the
   * flight began, bit for bit as {@link #find} has it. NaN if it stands still or may have turned
   * back, or will before it leaves: few do. The direction is unpredictable, so it takes no branch.
   */
  static double ahead(double p, double v, double g, double since, double cell, CellAxis axis) {
    if (g == 0) {
      return CellExit.untilEdge(p, v, cell, axis);
    }
    double way = CellExit.edge(v, cell, axis) - p;
    double square = v * v + 2 * g * way;
    // The least normal number covers underflow of -v / g.
    boolean isAhead = fma(g, since + Double.MIN_NORMAL, v) * v > GOING_ON * (v * v) && square >= 0;
    return isAhead ? 2 * way / (v + Math.copySign(Math.sqrt(square), v)) : Double.NaN;
  }

  /**
   * Finds the exit from a cell.
   *
   * @param p the place at the start of the flight, from the origin of the cells
   * @param since the circle has been in this cell since this time of the flight, or longer
   * @param cell the column or the row
   */
  void find(double p, double v, double g, double since, double cell, CellAxis axis) {
    after = NEVER;
    if (g == 0) {
      direction = v < 0 ? -1 : 1;
      after = v == 0 ? NEVER : (edge(cell, direction, axis) - p) / v;
      return;
    }
    double down = Math.signum(g);
    if (v * down < 0 && since < -v / g) {
      double way = edge(cell, -down, axis) - p;
      double square = v * v + 2 * g * way;
      if (square >= 0) {
        direction = -down;
        after = 2 * way / (v - down * Math.sqrt(square));
        return;
      }
    }
    double way = edge(cell, down, axis) - p;
    double speed = Math.sqrt(Math.max(0, v * v + 2 * g * way));
    direction = down;
    after = v * down > 0 ? 2 * way / (v + down * speed) : (-v + down * speed) / g;
  }

  private static double edge(double cell, double direction, CellAxis axis) {
    return axis.edge(direction > 0 ? cell + 1 : cell);
  }
}
