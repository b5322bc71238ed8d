// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.BoundingBox;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.Index;

/**
 * Which circles are near which: levels of {@link CellGrid}, one for each of the {@link
 * SizeClasses}, with cells a little wider than that level's largest diameter. A circle lists itself
 * on its own level and on every coarser one. Two circles that touch then have centres in cells that
 * are the same or next to each other on the level of the larger one, so a circle finds all that it
 * can touch among those listed around it on its own level, and among the larger ones of each
 * coarser level.
 */
public final class NeighborGrid {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static final long ONE = Double.doubleToRawLongBits(1);

  /** The cell of a circle that is not listed. */
  private static final double NOWHERE = Double.NaN;

  /** Beyond so many cells from the origin a place no longer tells one cell from the next. */
  private static final double FARTHEST = 0x1p48;

  /** Room that searches need beside that for all circles. */
  static final int SPARE = 9;

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

  /**
   * The cells of the first level, and their width; where that is the only one, circles are listed
   * in them.
   */
  private final CellGrid cells;

  private final double width;

  /**
   * Where there are several levels: circles of each, and smaller ones listed on it too; null where
   * there are none.
   */
  private final CellLinks[] own;

  private final CellLinks[] smaller;
  private final short[] levelOf;

  /** The cell of circle i on a coarser level k, as whole numbers, at [(k * count + i) * 2]. */
  private final double[] coarse;

  private final int count;
  private final CircleTable circles;
  private final double[] state;
  private final int[] codes;

  /** Of each level: columns and rows within which no wall is near; first, after last, for both. */
  private final double[] inside;

  public NeighborGrid(
      CircleTable circles, int[] ids, double[] walls, double diameters, double now) {
    this.circles = circles;
    state = circles.state;
    codes = circles.codes;
    count = circles.capacity();
    BoundingBox extent = BoundingBox.of(circles, ids, walls, now);
    originX = extent.left();
    originY = extent.bottom();
    sizes = new SizeClasses(circles, ids, extent, diameters);
    size = sizes.widths;
    levels = size.length;
    width = levels == 0 ? 0 : size[0];
    cells = levels == 0 ? null : cells(extent, width);
    own = new CellLinks[levels];
    smaller = new CellLinks[levels];
    levelOf = new short[count];
    int[] next = new int[levels == 1 ? 0 : count];
    for (int k = 0; k < levels; k++) {
      own[k] = new CellLinks(k == 0 ? cells : cells(extent, size[k]), next, null);
      smaller[k] =
          k == 0 ? null : new CellLinks(cells(extent, size[k]), new int[count], new int[count]);
    }
    for (int i = 0; i < count; i++) {
      codes[CircleTable.collidingCodesAt(i) + CircleTable.FOLLOWER] = Index.NONE;
    }
    coarse = new double[levels == 1 ? 0 : 2 * levels * count];
    inside = new double[4 * levels];
    for (int k = 0; k < levels; k++) {
      limit(k, sizes.radii[k] * (1 + 0x1p-10) + sizes.slack(), walls);
    }
    for (int i : ids) {
      enter(i, now);
    }
  }

  /** About as many cells as the extent takes, but no more than sixteen a circle. */
  private CellGrid cells(BoundingBox extent, double cellWidth) {
    int nx = powerOfTwo((extent.right() - extent.left()) / cellWidth + 2);
    int ny = powerOfTwo((extent.top() - extent.bottom()) / cellWidth + 2);
    while ((long) nx * ny > 16L * count + 64) {
      if (nx >= ny) {
        nx /= 2;
      } else {
        ny /= 2;
      }
    }
    nx = Math.max(4, nx);
    ny = Math.max(4, ny);
    return new CellGrid(nx, ny);
  }

  private static int powerOfTwo(double atLeast) {
    int n = 4;
    while (n < atLeast && n < 1 << 28) {
      n *= 2;
    }
    return n;
  }

  /** Finds the cells of a level all of whose places are further than that from every wall. */
  private void limit(int level, double distance, double[] w) {
    int k = 4 * level;
    double cellWidth = size[level];
    boolean open = w == null;
    inside[k] = open ? -NEVER : Math.ceil((w[ObstacleTable.LEFT] + distance - originX) / cellWidth);
    inside[k + 1] =
        open ? NEVER : Math.floor((w[ObstacleTable.RIGHT] - distance - originX) / cellWidth);
    inside[k + 2] =
        open ? -NEVER : Math.ceil((w[ObstacleTable.BOTTOM] + distance - originY) / cellWidth);
    inside[k + 3] =
        open ? NEVER : Math.floor((w[ObstacleTable.TOP] - distance - originY) / cellWidth);
  }

  /**
   * Lists a circle where it is at a given time, unless it is beyond the range of doubles.
   *
   * @return false if its radius is none for which these levels were made
   */
  public boolean enter(int i, double now) {
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
      double[] cellsOf = cellsOf(i, level);
      cellsOf[k] = column;
      cellsOf[k + 1] = row;
      if (there) {
        add(i, level, own[level].cells.cell(wrapped(column), wrapped(row)));
      }
    }
  }

  private void add(int i, int level, int cell) {
    if (level == levelOf(i)) {
      codes[CircleTable.collidingCodesAt(i) + CircleTable.CELL] = cell;
    }
    if (levels == 1) {
      cells.add(codes, i, cell);
    } else {
      list(i, level).add(i, cell);
    }
  }

  /**
   * Lists a circle anew where its new flight starts, if it is not listed there: it went on into
   * cells that a fast one enters at the same stored time.
   */
  public void comeBack(double[] s, int i) {
    int a = CircleTable.collidingAt(i);
    double cellWidth = width(i);
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double column = x - s[a + CircleTable.COLUMN] * cellWidth;
    double row = y - s[a + CircleTable.ROW] * cellWidth;
    if (column < 0 || column > cellWidth || row < 0 || row > cellWidth) {
      leave(i);
      enter(i, x, y);
    }
  }

  /** Takes a circle off all lists. */
  public void leave(int i) {
    for (int level = levelOf(i); level < levels; level++) {
      int k = cellAt(i, level);
      double[] cellsOf = cellsOf(i, level);
      if (isListed(cellsOf[k])) {
        remove(i, level, cell(i, level));
      }
      cellsOf[k] = NOWHERE;
      cellsOf[k + 1] = NOWHERE;
    }
  }

  private void remove(int i, int level, int cell) {
    if (levels == 1) {
      cells.remove(codes, i, cell);
    } else {
      list(i, level).remove(i, cell);
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
    return level == levelOf(i)
        ? CircleTable.collidingAt(i) + CircleTable.COLUMN
        : 2 * (level * count + i);
  }

  /** The cell of a circle on a level. */
  private int cell(int i, int level) {
    if (level == levelOf(i)) {
      return codes[CircleTable.collidingCodesAt(i) + CircleTable.CELL];
    }
    int k = cellAt(i, level);
    return own[level].cells.cell(wrapped(coarse[k]), wrapped(coarse[k + 1]));
  }

  /** The width of a cell of a circle's own level. */
  private double width(int i) {
    return levels == 1 ? width : size[levelOf[i]];
  }

  private CellLinks list(int i, int level) {
    return level == levelOf(i) ? own[level] : smaller[level];
  }

  private static int wrapped(double cell) {
    return (int) (long) cell;
  }

  /** Whether a circle meets no wall before it next leaves its cell. */
  public boolean isInside(double[] s, int i) {
    int a = CircleTable.collidingAt(i);
    int k = 4 * levelOf(i);
    double column = s[a + CircleTable.COLUMN];
    double row = s[a + CircleTable.ROW];
    return column >= inside[k]
        && column < inside[k + 1]
        && row >= inside[k + 2]
        && row < inside[k + 3];
  }

  /** When circle i next leaves a cell; keeps which way in its {@link CircleTable#WAY}. */
  public double nextCrossing(double[] s, int[] c, int i) {
    int a = CircleTable.collidingAt(i);
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double vx = s[a + FlightRow.VX];
    double vy = s[a + FlightRow.VY];
    double first =
        untilExit(x, y, vx, vy, s[a + CircleTable.COLUMN], s[a + CircleTable.ROW], width(i));
    int way = exit(x, y, vx, vy, s[a + CircleTable.COLUMN], s[a + CircleTable.ROW], width(i));
    if (levels > 1) {
      int own = levelOf(i);
      way += own * DIRECTIONS;
      for (int level = own + 1; level < levels; level++) {
        int k = cellAt(i, level);
        double until = untilExit(x, y, vx, vy, coarse[k], coarse[k + 1], size[level]);
        if (until < first) {
          first = until;
          way = level * DIRECTIONS + exit(x, y, vx, vy, coarse[k], coarse[k + 1], size[level]);
        }
      }
    }
    c[CircleTable.collidingCodesAt(i) + CircleTable.WAY] = way;
    return first < NEVER ? MovingCircle.sum(s[a + FlightRow.T], s[a + FlightRow.TL], first) : NEVER;
  }

  /** How long after the start of its flight a circle leaves a cell. */
  double untilCrossing(double[] s, int i) {
    int a = CircleTable.collidingAt(i);
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double vx = s[a + FlightRow.VX];
    double vy = s[a + FlightRow.VY];
    double first =
        untilExit(x, y, vx, vy, s[a + CircleTable.COLUMN], s[a + CircleTable.ROW], width(i));
    for (int level = levelOf(i) + 1; level < levels; level++) {
      int k = cellAt(i, level);
      first = Math.min(first, untilExit(x, y, vx, vy, coarse[k], coarse[k + 1], size[level]));
    }
    return first;
  }

  /** How long a circle takes to leave a cell. */
  private static double untilExit(
      double x, double y, double vx, double vy, double column, double row, double cellWidth) {
    return Math.min(untilEdge(x, vx, column, cellWidth), untilEdge(y, vy, row, cellWidth));
  }

  /** Over which edge it leaves the cell. */
  private static int exit(
      double x, double y, double vx, double vy, double column, double row, double cellWidth) {
    double dx = untilEdge(x, vx, column, cellWidth);
    double dy = untilEdge(y, vy, row, cellWidth);
    // Branch-free, as it is unpredictable: which edge is first, and the sign of the velocity.
    long vertical = Double.doubleToRawLongBits(dy - dx) >> 63;
    long right = Double.doubleToRawLongBits(vx);
    long v = right ^ ((right ^ Double.doubleToRawLongBits(vy)) & vertical);
    return (int) ((vertical & VERTICAL) | (v >>> 63));
  }

  private static double untilEdge(double p, double v, double cell, double size) {
    // The cell's upper edge is one further.
    double edge = (cell + oneIfUp(v)) * size;
    return Math.abs(cell) < FARTHEST && v != 0 ? (edge - p) / v : NEVER;
  }

  /** 1, or 0 if v has a minus sign. */
  private static double oneIfUp(double v) {
    return Double.longBitsToDouble(ONE & ~(Double.doubleToRawLongBits(v) >> 63));
  }

  /**
   * Moves circle i into the cell that it enters, and finds the circles in those now next to it that
   * were not, as {@link #find} does.
   *
   * @param found room for all circles and {@link #SPARE} more
   * @return how many were found
   */
  public int cross(double[] s, int[] c, int i, int way, int[] found) {
    // One step to the side, by arithmetic: the way cannot be foretold.
    int vertical = -((way & VERTICAL) >> 1);
    int sign = sign(way);
    if (levels > 1) {
      return cross(i, way >> DIRECTION_BITS, vertical, sign, found);
    }
    int a = CircleTable.collidingAt(i);
    int k = CircleTable.collidingCodesAt(i) + CircleTable.CELL;
    int cell = c[k];
    cells.remove(c, i, cell);
    int step = sign * cells.step(vertical);
    int entered = cell + step;
    cells.add(c, i, entered);
    c[k] = entered;
    s[a + CircleTable.COLUMN] += sign & ~vertical;
    s[a + CircleTable.ROW] += sign & vertical;
    return cells.beside(entered + step, cells.step(~vertical), found, 0);
  }

  private int cross(int i, int level, int vertical, int sign, int[] found) {
    int cell = cell(i, level);
    remove(i, level, cell);
    int k = cellAt(i, level);
    double[] cellsOf = cellsOf(i, level);
    cellsOf[k] += sign & ~vertical;
    cellsOf[k + 1] += sign & vertical;
    int step = sign * own[level].cells.step(vertical);
    add(i, level, cell + step);
    int ahead = cell + 2 * step;
    int aside = own[level].cells.step(~vertical);
    int end = own[level].beside(ahead, aside, found, 0);
    return hasSmaller(i, level) ? smaller[level].beside(ahead, aside, found, end) : end;
  }

  /** Whether a way goes up its axis or down: 1 or -1. */
  private static int sign(int way) {
    return 1 - ((way & 1) << 1);
  }

  /**
   * Finds all circles that circle i could touch before one of them leaves its cell, and maybe
   * itself; of each list the first one, whose followers are to be added, as {@link
   * CircleTable#FOLLOWER} tells. Where there are several levels it finds all, and none follows. Of
   * a circle that is not listed it finds some, which that does not meet.
   *
   * @param found room for all circles and {@link #SPARE} more
   * @return how many were found
   */
  public int find(int[] c, int i, int[] found) {
    return levels > 1
        ? findOnLevels(i, found)
        : cells.others(c, i, c[CircleTable.collidingCodesAt(i) + CircleTable.CELL], found);
  }

  private int findOnLevels(int i, int[] found) {
    int end = 0;
    for (int level = levelOf[i]; level < levels; level++) {
      if (!isListed(cellsOf(i, level)[cellAt(i, level)])) {
        return 0;
      }
      int cell = cell(i, level);
      end = own[level].around(cell, found, end);
      if (hasSmaller(i, level)) {
        end = smaller[level].around(cell, found, end);
      }
    }
    return end;
  }

  /** The cells of a circle's own level. */
  public CellGrid cells(int i) {
    return own[levelOf(i)].cells;
  }

  /** In which column of its own level circle i is. */
  public int column(int i) {
    return wrapped(state[CircleTable.collidingAt(i) + CircleTable.COLUMN]);
  }

  /** And in which row. */
  public int row(int i) {
    return wrapped(state[CircleTable.collidingAt(i) + CircleTable.ROW]);
  }

  /** By how many columns a way leads on: 1, 0, or -1. */
  public static int columnsOn(int way) {
    return sign(way) * (1 - ((way & VERTICAL) >> 1));
  }

  /** And by how many rows. */
  public static int rowsOn(int way) {
    return sign(way) * ((way & VERTICAL) >> 1);
  }

  private boolean hasSmaller(int i, int level) {
    return level == levelOf(i) && smaller[level] != null;
  }
}
