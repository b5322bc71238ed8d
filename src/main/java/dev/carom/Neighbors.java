// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * Which circles are near which: levels of {@link Cells}, one for each of the {@link SizeClasses},
 * with cells a little wider than that level's largest diameter. A circle lists itself on its own
 * level and on every coarser one. Two circles that touch then have centres in cells that are the
 * same or next to each other on the level of the larger one, so a circle finds all that it can
 * touch among those listed around it on its own level, and among the larger ones of each coarser
 * level.
 */
final class Neighbors {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The cell of a circle that is not listed. */
  private static final double NOWHERE = Double.NaN;

  /** Beyond so many cells from the origin a place no longer tells one cell from the next. */
  private static final double FARTHEST = 0x1p48;

  // Directions in which a circle leaves a cell: right, left, up, down.
  private static final int VERTICAL = 2;
  private static final int DIRECTION_BITS = 2;
  private static final int DIRECTIONS = 1 << DIRECTION_BITS;

  private final int levels;

  private final SizeClasses sizes;

  /** The width of a cell on each level. */
  private final double[] size;
  private final double originX;
  private final double originY;

  /** Circles of each level, and smaller ones listed on it too; null where there are none. */
  private final Cells[] own;

  private final Cells[] smaller;
  private final short[] levelOf;

  /** The cell of circle i on a coarser level k, as whole numbers, at [(k * count + i) * 2]. */
  private final double[] coarse;

  private final int count;
  private final Circles circles;
  private final double[] state;

  /** Of each level: columns and rows within which no wall is near; first, after last, for both. */
  private final double[] inside;

  private int way;

  private double until;

  Neighbors(Circles circles, int[] ids, Bounds bounds, double diameters, double now) {
    this.circles = circles;
    state = circles.state;
    count = circles.capacity();
    Extent extent = Extent.of(circles, ids, bounds, now);
    originX = extent.left();
    originY = extent.bottom();
    sizes = new SizeClasses(circles, ids, extent, diameters);
    size = sizes.widths;
    levels = size.length;
    own = new Cells[levels];
    smaller = new Cells[levels];
    levelOf = new short[count];
    int[] next = new int[levels == 1 ? 0 : count];
    for (int k = 0; k < levels; k++) {
      own[k] = cells(extent, size[k], next, null);
      smaller[k] = k == 0 ? null : cells(extent, size[k], new int[count], new int[count]);
    }
    for (int i = 0; i < count; i++) {
      circles.codes[Circles.collidingCodesAt(i) + Circles.FOLLOWER] = Cells.NONE;
    }
    coarse = new double[levels == 1 ? 0 : 2 * levels * count];
    inside = new double[4 * levels];
    for (int k = 0; k < levels; k++) {
      limit(k, sizes.radii[k] * (1 + 0x1p-10) + sizes.slack(), bounds);
    }
    for (int i : ids) {
      enter(i, now);
    }
  }

  /**
   * About as many cells as the extent takes, but no more than sixteen a circle; if there is but one
   * level, with followers among the ints of the circles.
   */
  private Cells cells(Extent extent, double cell, int[] next, int[] previous) {
    int nx = powerOfTwo((extent.right() - extent.left()) / cell + 2);
    int ny = powerOfTwo((extent.top() - extent.bottom()) / cell + 2);
    while ((long) nx * ny > 16L * count + 64) {
      if (nx >= ny) {
        nx /= 2;
      } else {
        ny /= 2;
      }
    }
    nx = Math.max(4, nx);
    ny = Math.max(4, ny);
    return levels == 1 ? new Cells(nx, ny, circles) : new Cells(nx, ny, next, previous);
  }

  private static int powerOfTwo(double atLeast) {
    int n = 4;
    while (n < atLeast && n < 1 << 28) {
      n *= 2;
    }
    return n;
  }

  /** Finds the cells of a level all of whose places are further than that from every wall. */
  private void limit(int level, double distance, Bounds b) {
    int k = 4 * level;
    double cell = size[level];
    inside[k] = b == null ? -NEVER : Math.ceil((b.xmin() + distance - originX) / cell);
    inside[k + 1] = b == null ? NEVER : Math.floor((b.xmax() - distance - originX) / cell);
    inside[k + 2] = b == null ? -NEVER : Math.ceil((b.ymin() + distance - originY) / cell);
    inside[k + 3] = b == null ? NEVER : Math.floor((b.ymax() - distance - originY) / cell);
  }

  /**
   * Lists a circle where it is at a given time, unless it is beyond the range of doubles.
   *
   * @return false if its radius is none for which these levels were made
   */
  boolean enter(int i, double now) {
    int level = sizes.of(circles.radius(i));
    if (level < 0) {
      return false;
    }
    levelOf[i] = (short) level;
    enter(i, circles.x(i, now) - originX, circles.y(i, now) - originY);
    return true;
  }

  private void enter(int i, double x, double y) {
    boolean there = Math.abs(x) + Math.abs(y) < NEVER;
    for (int level = levelOf[i]; level < levels; level++) {
      double column = there ? Math.floor(x / size[level]) : NOWHERE;
      double row = there ? Math.floor(y / size[level]) : NOWHERE;
      int k = cellAt(i, level);
      double[] cells = cellsOf(i, level);
      cells[k] = column;
      cells[k + 1] = row;
      if (there) {
        list(i, level).add(i, wrapped(column), wrapped(row));
      }
    }
  }

  /**
   * Lists a circle anew where its new flight starts, if it is not listed there: it went on into
   * cells that a fast one enters at the same stored time.
   */
  void comeBack(int i) {
    int a = Circles.collidingAt(i);
    double cell = size[levelOf(i)];
    double x = state[a + Circles.X] - originX;
    double y = state[a + Circles.Y] - originY;
    double column = x - state[a + Circles.COLUMN] * cell;
    double row = y - state[a + Circles.ROW] * cell;
    if (column < 0 || column > cell || row < 0 || row > cell) {
      leave(i);
      enter(i, x, y);
    }
  }

  /** Takes a circle off all lists. */
  void leave(int i) {
    for (int level = levelOf(i); level < levels; level++) {
      int k = cellAt(i, level);
      double[] cells = cellsOf(i, level);
      if (isListed(cells[k])) {
        list(i, level).remove(i, wrapped(cells[k]), wrapped(cells[k + 1]));
      }
      cells[k] = NOWHERE;
      cells[k + 1] = NOWHERE;
    }
  }

  private static boolean isListed(double column) {
    return !Double.isNaN(column);
  }

  /** The level of a circle, without a look at memory where there is but one. */
  private int levelOf(int i) {
    return levels == 1 ? 0 : levelOf[i];
  }

  /** Where the cell of a circle on a level is kept: column, then row. */
  private double[] cellsOf(int i, int level) {
    return level == levelOf(i) ? state : coarse;
  }

  private int cellAt(int i, int level) {
    return level == levelOf(i) ? Circles.collidingAt(i) + Circles.COLUMN : 2 * (level * count + i);
  }

  private Cells list(int i, int level) {
    return level == levelOf(i) ? own[level] : smaller[level];
  }

  private static int wrapped(double cell) {
    return (int) (long) cell;
  }

  /** Whether a circle meets no wall before it next leaves its cell. */
  boolean isInside(int i) {
    int a = Circles.collidingAt(i);
    int k = 4 * levelOf(i);
    double column = state[a + Circles.COLUMN];
    double row = state[a + Circles.ROW];
    return column >= inside[k]
        && column < inside[k + 1]
        && row >= inside[k + 2]
        && row < inside[k + 3];
  }

  /** When circle i next leaves a cell. */
  double crossing(int i) {
    int a = Circles.collidingAt(i);
    double x = state[a + Circles.X] - originX;
    double y = state[a + Circles.Y] - originY;
    double vx = state[a + Circles.VX];
    double vy = state[a + Circles.VY];
    double first = NEVER;
    for (int level = levelOf(i); level < levels; level++) {
      double[] cells = cellsOf(i, level);
      int k = cellAt(i, level);
      double cell = size[level];
      double dx = untilEdge(x, vx, cells[k], cell);
      double dy = untilEdge(y, vy, cells[k + 1], cell);
      double least = Math.min(dx, dy);
      if (least < first) {
        first = least;
        // Which is first, and its sign, without a branch, as they cannot be foretold.
        long vertical = Double.doubleToRawLongBits(dy - dx) >> 63;
        long right = Double.doubleToRawLongBits(vx);
        long v = right ^ ((right ^ Double.doubleToRawLongBits(vy)) & vertical);
        way = level * DIRECTIONS + (int) ((vertical & VERTICAL) | (v >>> 63));
      }
    }
    until = first;
    return first < NEVER
        ? Mover.sum(state[a + Circles.T], state[a + Circles.TL], first)
        : NEVER;
  }

  /** How long after the start of its flight the crossing is that was asked for last. */
  double until() {
    return until;
  }

  /** Over which edge, and of which level, the crossing that was asked for last goes. */
  int way() {
    return way;
  }

  private static double untilEdge(double p, double v, double cell, double size) {
    // The cell's upper edge is one further.
    double edge = (cell + 0.5 + Math.copySign(0.5, v)) * size;
    return Math.abs(cell) < FARTHEST && v != 0 ? (edge - p) / v : NEVER;
  }

  /**
   * Moves circle i into the cell that it enters, and finds the circles in those now next to it that
   * were not, as {@link #find} does.
   *
   * @param found room for all circles and 9 more
   * @return how many were found
   */
  int cross(int i, int way, int[] found) {
    int level = way >> DIRECTION_BITS;
    int direction = way & (DIRECTIONS - 1);
    double[] cells = cellsOf(i, level);
    int k = cellAt(i, level);
    Cells list = list(i, level);
    int column = wrapped(cells[k]);
    int row = wrapped(cells[k + 1]);
    list.remove(i, column, row);
    // One step to the side, by arithmetic: the way cannot be foretold.
    int dy = direction >> 1;
    int dx = 1 - dy;
    int sign = sign(direction);
    cells[k] += sign * dx;
    cells[k + 1] += sign * dy;
    column += sign * dx;
    row += sign * dy;
    list.add(i, column, row);
    int c = column + sign * dx;
    int r = row + sign * dy;
    int end = own[level].beside(c, r, dy, dx, found, 0);
    if (levels == 1) {
      return end;
    }
    end = own[level].follow(found, 0, end);
    return hasSmaller(i, level)
        ? smaller[level].follow(found, end, smaller[level].beside(c, r, dy, dx, found, end))
        : end;
  }

  /** Whether a way goes up its axis or down: 1 or -1. */
  private static int sign(int way) {
    return 1 - ((way & 1) << 1);
  }

  /**
   * Finds all circles that circle i could touch before one of them leaves its cell, and maybe
   * itself; of each list the first one, whose followers are to be added, as {@link
   * Circles#FOLLOWER} tells. Where there are several levels it finds all, and none follows.
   *
   * @param found room for all circles and 9 more
   * @return how many were found
   */
  int find(int i, int[] found) {
    if (levels == 1) {
      int a = Circles.collidingAt(i);
      double column = state[a + Circles.COLUMN];
      return isListed(column)
          ? own[0].others(i, wrapped(column), wrapped(state[a + Circles.ROW]), found, 0)
          : 0;
    }
    int end = 0;
    for (int level = levelOf(i); level < levels; level++) {
      double[] cells = cellsOf(i, level);
      int k = cellAt(i, level);
      if (!isListed(cells[k])) {
        return 0;
      }
      int column = wrapped(cells[k]);
      int row = wrapped(cells[k + 1]);
      int from = end;
      end = own[level].follow(found, from, own[level].around(column, row, found, from));
      if (hasSmaller(i, level)) {
        from = end;
        end = smaller[level].follow(found, from, smaller[level].around(column, row, found, from));
      }
    }
    return end;
  }

  /** The lists of a circle's own level. */
  Cells cells(int i) {
    return own[levelOf(i)];
  }

  /** In which column of its own level circle i is. */
  int column(int i) {
    return wrapped(state[Circles.collidingAt(i) + Circles.COLUMN]);
  }

  /** And in which row. */
  int row(int i) {
    return wrapped(state[Circles.collidingAt(i) + Circles.ROW]);
  }

  /** By how many columns a way leads on: 1, 0, or -1. */
  static int columnsOn(int way) {
    return sign(way) * (1 - ((way & VERTICAL) >> 1));
  }

  /** And by how many rows. */
  static int rowsOn(int way) {
    return sign(way) * ((way & VERTICAL) >> 1);
  }

  private boolean hasSmaller(int i, int level) {
    return level == levelOf(i) && smaller[level] != null;
  }
}
