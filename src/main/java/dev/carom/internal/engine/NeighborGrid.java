// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.BoundingBox;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.util.Index;

/**
 * The broad phase of moving circles: a hierarchical grid, with a level for each of the {@link
 * SizeClasses}. The cells of a level are a little wider than its largest diameter.
 *
 * <p>A circle is listed on its own level and on every coarser one. Two circles that touch have
 * their centres in the same cell or in neighboring ones on the level of the larger circle. So a
 * circle finds everything that it can touch in the cells around its own: all circles listed on its
 * own level, and on each coarser level the circles of that level.
 */
public final class NeighborGrid {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The cell of a circle that is not listed. */
  private static final double NOWHERE = Double.NaN;

  /** The numbers that a search may write beyond the circles that it finds. */
  static final int SPARE = 9;

  private final int levels;

  private final SizeClasses sizes;

  /** The width of a cell on each level. */
  private final double[] size;

  private final double originX;
  private final double originY;

  /** The cells of the first level, and their width. A single level needs no {@link CellLinks}. */
  private final CellGrid cells;

  private final double width;

  /** With several levels, of each: its own circles, and the smaller ones that it lists too. */
  private final CellLinks[] own;

  private final CellLinks[] smaller;
  private final short[] levelOf;

  /** The cell of circle i on a coarser level k, as whole numbers, at [(k * count + i) * 2]. */
  private final double[] coarse;

  private final int count;
  private final CircleTable circles;
  private final double[] state;
  private final int[] codes;

  /**
   * The cells of each level in which a circle meets no wall: the first column, the one after the
   * last, and the same for rows.
   */
  private final double[] inside;

  /** Whether circles may have accelerations. */
  private final boolean falls;

  private final FallingExit exitX = new FallingExit();
  private final FallingExit exitY = new FallingExit();

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
    falls = circles.allowsGravity();
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

  /** Cells that cover the extent, but at most about sixteen for each circle. */
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

  /** Finds the cells of a level that keep a distance from every wall. */
  private void limit(int level, double distance, double[] w) {
    int k = 4 * level;
    double cellWidth = size[level];
    boolean open = w == null;
    inside[k] = open ? -NEVER : Math.ceil((w[Codes.LEFT] + distance - originX) / cellWidth);
    inside[k + 1] = open ? NEVER : Math.floor((w[Codes.RIGHT] - distance - originX) / cellWidth);
    inside[k + 2] = open ? -NEVER : Math.ceil((w[Codes.BOTTOM] + distance - originY) / cellWidth);
    inside[k + 3] = open ? NEVER : Math.floor((w[Codes.TOP] - distance - originY) / cellWidth);
  }

  /**
   * Lists a circle where it is at a given time, unless it is beyond the range of doubles.
   *
   * @return false if no level was made for its radius, or the cells are too narrow so far away
   */
  public boolean enter(int i, double now) {
    int level = sizes.of(circles.radius(i));
    double x = circles.x(i, now);
    double y = circles.y(i, now);
    if (level < 0 || !sizes.reach(x, y)) {
      return false;
    }
    levelOf[i] = (short) level;
    if (falls) {
      state[CircleTable.collidingAt(i) + CircleTable.ENTERED] = circles.since(i, now);
    }
    enter(i, x - originX, y - originY);
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
   * Lists a circle in the cells where its new flight starts. As a rule it is there already; a fast
   * circle may have crossed further cells within one stored time.
   */
  public void comeBack(double[] s, int i) {
    int a = CircleTable.collidingAt(i);
    if (falls) {
      s[a + CircleTable.ENTERED] = 0;
    }
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

  /** Removes a circle from all lists. */
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

  /** The level of a circle; no memory is read if there is only one. */
  private int levelOf(int i) {
    return levels == 1 ? 0 : levelOf[i];
  }

  /** The array that holds the cell of a circle on a level: its column, then its row. */
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

  /** When circle i next leaves a cell; stores which {@linkplain CellExit way} in its row. */
  public double nextCrossing(double[] s, int[] c, int i) {
    if (!falls) {
      return nextCrossingStraight(s, c, i);
    }
    return levels == 1 ? nextCrossingOfFalling(s, c, i) : nextCrossingOnLevels(s, c, i);
  }

  /** The same without gravity. */
  private double nextCrossingStraight(double[] s, int[] c, int i) {
    int a = CircleTable.collidingAt(i);
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double vx = s[a + FlightRow.VX];
    double vy = s[a + FlightRow.VY];
    double column = s[a + CircleTable.COLUMN];
    double row = s[a + CircleTable.ROW];
    int own = levelOf(i);
    double cellWidth = width(i);
    double dx = CellExit.untilEdge(x, vx, column, cellWidth);
    double dy = CellExit.untilEdge(y, vy, row, cellWidth);
    double first = Math.min(dx, dy);
    int way = CellExit.way(own, dx, dy, vx, vy);
    for (int level = own + 1; level < levels; level++) {
      int k = cellAt(i, level);
      dx = CellExit.untilEdge(x, vx, coarse[k], size[level]);
      dy = CellExit.untilEdge(y, vy, coarse[k + 1], size[level]);
      if (Math.min(dx, dy) < first) {
        first = Math.min(dx, dy);
        way = CellExit.way(level, dx, dy, vx, vy);
      }
    }
    c[CircleTable.collidingCodesAt(i) + CircleTable.WAY] = way;
    return first < NEVER ? MovingCircle.sum(s[a + FlightRow.T], s[a + FlightRow.TL], first) : NEVER;
  }

  /** The same for one that may fall, in cells of a single level. */
  private double nextCrossingOfFalling(double[] s, int[] c, int i) {
    int a = CircleTable.collidingAt(i);
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double vx = s[a + FlightRow.VX];
    double vy = s[a + FlightRow.VY];
    double column = s[a + CircleTable.COLUMN];
    double row = s[a + CircleTable.ROW];
    double since = s[a + CircleTable.ENTERED];
    double dx = FallingExit.ahead(x, vx, circles.gx(i), since, column, width);
    double dy = FallingExit.ahead(y, vy, circles.gy(i), since, row, width);
    double first = Math.min(dx, dy);
    return Double.isNaN(first)
        ? nextCrossingOnLevels(s, c, i)
        : keepCrossing(s, c, i, first, CellExit.way(0, dx, dy, vx, vy));
  }

  /** The same for a circle that has cells on several levels, or may turn back in its cell. */
  private double nextCrossingOnLevels(double[] s, int[] c, int i) {
    int a = CircleTable.collidingAt(i);
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double vx = s[a + FlightRow.VX];
    double vy = s[a + FlightRow.VY];
    double since = s[a + CircleTable.ENTERED];
    double first = NEVER;
    int way = 0;
    for (int level = levelOf(i); level < levels; level++) {
      double[] cellsOf = cellsOf(i, level);
      int k = cellAt(i, level);
      exitX.find(x, vx, circles.gx(i), since, cellsOf[k], size[level]);
      exitY.find(y, vy, circles.gy(i), since, cellsOf[k + 1], size[level]);
      double soonest = Math.min(exitX.after, exitY.after);
      if (soonest < first) {
        first = soonest;
        way = CellExit.way(level, exitX.after, exitY.after, exitX.direction, exitY.direction);
      }
    }
    return keepCrossing(s, c, i, first, way);
  }

  /** Keeps when and which way a falling circle leaves its cell; returns the time. */
  private double keepCrossing(double[] s, int[] c, int i, double after, int way) {
    c[CircleTable.collidingCodesAt(i) + CircleTable.WAY] = way;
    int a = CircleTable.collidingAt(i);
    s[a + CircleTable.LEAVING] = after;
    return after < NEVER ? MovingCircle.sum(s[a + FlightRow.T], s[a + FlightRow.TL], after) : NEVER;
  }

  /** How long after the start of its flight circle i leaves a cell. */
  double untilCrossing(double[] s, int i) {
    int a = CircleTable.collidingAt(i);
    if (falls) {
      return s[a + CircleTable.LEAVING];
    }
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double vx = s[a + FlightRow.VX];
    double vy = s[a + FlightRow.VY];
    double column = s[a + CircleTable.COLUMN];
    double row = s[a + CircleTable.ROW];
    double cellWidth = width(i);
    double first =
        Math.min(
            CellExit.untilEdge(x, vx, column, cellWidth),
            CellExit.untilEdge(y, vy, row, cellWidth));
    for (int level = levelOf(i) + 1; level < levels; level++) {
      int k = cellAt(i, level);
      first = Math.min(first, CellExit.untilEdge(x, vx, coarse[k], size[level]));
      first = Math.min(first, CellExit.untilEdge(y, vy, coarse[k + 1], size[level]));
    }
    return first;
  }

  /**
   * Moves circle i into the next cell, and finds the circles in the cells that became neighbors, as
   * {@link #find} does.
   *
   * @param way the {@linkplain CellExit way} in which it leaves its cell
   * @param found room for all circles and {@link #SPARE} more
   * @return how many were found
   */
  public int cross(double[] s, int[] c, int i, int way, int[] found) {
    int vertical = CellExit.vertical(way);
    int sign = CellExit.sign(way);
    int a = CircleTable.collidingAt(i);
    if (falls) {
      s[a + CircleTable.ENTERED] = s[a + CircleTable.LEAVING];
    }
    if (levels > 1) {
      return cross(i, CellExit.level(way), vertical, sign, found);
    }
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

  /**
   * Finds all circles that circle i could touch before one of them leaves its cell, possibly
   * including itself. With a single level only the first circle of each list is found; {@link
   * CircleTable#FOLLOWER} leads to the others. With several levels all are found. For a circle that
   * is not listed, whatever is found does not meet it.
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

  /** The column of circle i on its own level. */
  public int column(int i) {
    return wrapped(state[CircleTable.collidingAt(i) + CircleTable.COLUMN]);
  }

  /** The row of circle i on its own level. */
  public int row(int i) {
    return wrapped(state[CircleTable.collidingAt(i) + CircleTable.ROW]);
  }

  private boolean hasSmaller(int i, int level) {
    return level == levelOf(i) && smaller[level] != null;
  }
}
