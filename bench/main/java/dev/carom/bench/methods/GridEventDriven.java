// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Scene;

/** The event-driven loop with a grid: a circle asks only the lines of the cells on its way. */
class GridEventDriven extends EventDriven {

  /** Null for a scene without lines. */
  private final LineGrid grid;

  GridEventDriven(Scene scene, LineDetector detector) {
    super(scene, detector);
    grid = lines > 0 ? new LineGrid(this) : null;
  }

  /** From cell to cell, until one is left after the first impact found so far, or the grid is. */
  @Override
  int search(int i, double wallTime, int wall) {
    if (grid == null) {
      return super.search(i, wallTime, wall);
    }
    double px = x[i];
    double py = y[i];
    double ux = vx[i];
    double uy = vy[i];
    double first = wallTime;
    int what = wall;
    double start = grid.holds(px, py) ? 0 : grid.entry(px, py, ux, uy);
    boolean inside = start < Double.POSITIVE_INFINITY;
    int column = inside ? grid.column(px + start * ux) : 0;
    int row = inside ? grid.row(py + start * uy) : 0;
    int right = ux > 0 ? 1 : 0;
    int up = uy > 0 ? 1 : 0;
    double nextX = ux == 0 ? NEVER : (grid.xmin + (column + right) * grid.cell - px) / ux;
    double nextY = uy == 0 ? NEVER : (grid.ymin + (row + up) * grid.cell - py) / uy;
    double eachX = grid.cell / Math.abs(ux);
    double eachY = grid.cell / Math.abs(uy);
    while (inside) {
      int c = row * grid.columns + column;
      for (int n = grid.starts[c]; n < grid.starts[c + 1]; n++) {
        int k = grid.listed[n];
        double t = test(i, k, first);
        if (t < first) {
          first = t;
          what = k;
        }
      }
      inside = Math.min(nextX, nextY) < first;
      if (nextX < nextY) {
        column += 2 * right - 1;
        nextX += eachX;
        inside &= column >= 0 && column < grid.columns;
      } else {
        row += 2 * up - 1;
        nextY += eachY;
        inside &= row >= 0 && row < grid.rows;
      }
    }
    due[i] = first;
    return what;
  }
}
