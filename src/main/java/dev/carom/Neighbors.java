// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.TreeMap;

/**
 * Which circles are near which: levels of {@link Cells}, one for each power of two among the radii,
 * with cells a little wider than that level's largest diameter. A circle lists itself on its own
 * level and on every coarser one. Two circles that touch then have centres in cells that are the
 * same or next to each other on the level of the larger one, so a circle finds all that it can
 * touch among those listed around it on its own level, and among the larger ones of each coarser
 * level.
 */
final class Neighbors {

  /** Told of each circle found. */
  interface Visitor {
    void visit(int i, int j);
  }

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Wider than a diameter, so that a crossing may be noticed late by rounding. */
  private static final double SLACK = 1 + 0x1p-20;

  /** Beyond so many cells from the origin a place no longer tells one cell from the next. */
  private static final double FARTHEST = 0x1p48;

  private final int levels;
  private final double[] size;

  /** Circles of each level, and smaller ones listed on it too; null where there are none. */
  private final Cells[] own;

  private final Cells[] smaller;
  private final int[] levelOf;

  /** The cell of circle i on level k at [k * count + i], as whole numbers. */
  private final double[] columns;

  private final double[] rows;
  private final int count;
  private final Circles circles;

  // Of each circle: when it next leaves a cell, on which level, and towards where.
  private final double[] crossings;
  private final int[] crossedLevels;
  private final int[] directions;

  Neighbors(Circles circles, Bounds bounds, double diameters) {
    this.circles = circles;
    count = circles.count;
    TreeMap<Integer, Double> largest = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      double radius = circles.radius(i);
      largest.merge(Math.getExponent(radius), radius, Math::max);
    }
    levels = largest.size();
    size = largest.values().stream().mapToDouble(r -> 2 * r * SLACK * diameters).toArray();
    own = new Cells[levels];
    smaller = new Cells[levels];
    levelOf = new int[count];
    for (int k = 0; k < levels; k++) {
      own[k] = cells(k, bounds);
      smaller[k] = k == 0 ? null : cells(k, bounds);
    }
    columns = new double[levels * count];
    rows = new double[levels * count];
    crossings = new double[count];
    crossedLevels = new int[count];
    directions = new int[count];
    Integer[] exponents = largest.keySet().toArray(Integer[]::new);
    for (int i = 0; i < count; i++) {
      levelOf[i] = java.util.Arrays.binarySearch(exponents, Math.getExponent(circles.radius(i)));
      enter(i);
    }
  }

  /** About as many cells as the bounds take, but no more than four a circle. */
  private Cells cells(int level, Bounds bounds) {
    double fair = Math.sqrt(count);
    double wide = bounds == null ? fair : (bounds.xmax() - bounds.xmin()) / size[level] + 2;
    double high = bounds == null ? fair : (bounds.ymax() - bounds.ymin()) / size[level] + 2;
    int nx = powerOfTwo(wide);
    int ny = powerOfTwo(high);
    while ((long) nx * ny > 8L * count + 64) {
      if (nx >= ny) {
        nx /= 2;
      } else {
        ny /= 2;
      }
    }
    return new Cells(count, Math.max(4, nx), Math.max(4, ny));
  }

  private static int powerOfTwo(double atLeast) {
    int n = 4;
    while (n < atLeast && n < 1 << 28) {
      n *= 2;
    }
    return n;
  }

  private void enter(int i) {
    int k = i * Circles.STATE;
    for (int level = levelOf[i]; level < levels; level++) {
      double column = Math.floor(circles.state[k + Circles.X] / size[level]);
      double row = Math.floor(circles.state[k + Circles.Y] / size[level]);
      columns[level * count + i] = column;
      rows[level * count + i] = row;
      list(i, level).add(i, wrapped(column), wrapped(row));
    }
  }

  private Cells list(int i, int level) {
    return level == levelOf[i] ? own[level] : smaller[level];
  }

  private static int wrapped(double cell) {
    return (int) (long) cell;
  }

  /** When circle i next leaves a cell; set by {@link #newFlight} and {@link #cross}. */
  double crossing(int i) {
    return crossings[i];
  }

  /** Finds when a circle on a new flight next leaves a cell. */
  void newFlight(int i) {
    double[] state = circles.state;
    int k = i * Circles.STATE;
    double x = state[k + Circles.X];
    double y = state[k + Circles.Y];
    double vx = state[k + Circles.VX];
    double vy = state[k + Circles.VY];
    double first = NEVER;
    for (int level = levelOf[i]; level < levels; level++) {
      double cell = size[level];
      double dx = untilEdge(x, vx, columns[level * count + i], cell);
      double dy = untilEdge(y, vy, rows[level * count + i], cell);
      double least = Math.min(dx, dy);
      if (least < first) {
        first = least;
        crossedLevels[i] = level;
        directions[i] = dx <= dy ? (vx > 0 ? 0 : 1) : (vy > 0 ? 2 : 3);
      }
    }
    crossings[i] = state[k + Circles.T] + first;
  }

  private static double untilEdge(double p, double v, double cell, double size) {
    if (v == 0 || !(Math.abs(cell) < FARTHEST)) {
      return NEVER;
    }
    return ((v > 0 ? cell + 1 : cell) * size - p) / v;
  }

  /** Moves circle i into the cell that it enters, and visits those now next to it that were not. */
  void cross(int i, Visitor visitor) {
    int level = crossedLevels[i];
    int at = level * count + i;
    double column = columns[at];
    double row = rows[at];
    Cells list = list(i, level);
    list.remove(i, wrapped(column), wrapped(row));
    int direction = directions[i];
    int dx = direction == 0 ? 1 : direction == 1 ? -1 : 0;
    int dy = direction == 2 ? 1 : direction == 3 ? -1 : 0;
    column += dx;
    row += dy;
    columns[at] = column;
    rows[at] = row;
    list.add(i, wrapped(column), wrapped(row));
    for (int side = -1; side <= 1; side++) {
      int nextColumn = wrapped(column) + (dx != 0 ? dx : side);
      int nextRow = wrapped(row) + (dy != 0 ? dy : side);
      visitCell(i, level, nextColumn, nextRow, visitor);
    }
    newFlight(i);
  }

  /** Visits all circles that circle i could touch before one of them leaves its cell. */
  void visitAll(int i, Visitor visitor) {
    for (int level = levelOf[i]; level < levels; level++) {
      int column = wrapped(columns[level * count + i]);
      int row = wrapped(rows[level * count + i]);
      for (int dy = -1; dy <= 1; dy++) {
        for (int dx = -1; dx <= 1; dx++) {
          visitCell(i, level, column + dx, row + dy, visitor);
        }
      }
    }
  }

  private void visitCell(int i, int level, int column, int row, Visitor visitor) {
    visitList(i, own[level], column, row, visitor);
    if (level == levelOf[i] && smaller[level] != null) {
      visitList(i, smaller[level], column, row, visitor);
    }
  }

  private static void visitList(int i, Cells cells, int column, int row, Visitor visitor) {
    for (int j = cells.first(column, row); j != Cells.NONE; j = cells.next[j]) {
      if (j != i) {
        visitor.visit(i, j);
      }
    }
  }
}
