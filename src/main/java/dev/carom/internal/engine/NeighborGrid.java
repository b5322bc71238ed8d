// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.BoundingBox;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;

/**
 * The broad phase of moving circles: a hierarchical grid, with a level for each of the {@link
 * SizeClasses}. The cells of a level are a little wider than its largest diameter, and wider still
 * far away, see {@link CellAxis}.
 *
 * <p>A circle is listed on its own level and on every coarser one. Two circles that touch have
 * their centres in the same cell or in neighboring ones on the level of the larger circle. So a
 * circle finds everything that it can touch in the cells around its own: all circles listed on its
 * own level, and on each coarser level the circles of that level.
 */
public final class NeighborGrid {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** The numbers that a search may write beyond the circles that it finds. */
  static final int SPARE = 9;

  private final int levels;

  private final SizeClasses sizes;

  /** The columns of each level, and likewise the rows, counted from the origin. */
  private final CellAxis[] axes;

  /** The only one of them, if there is a single level: reading it needs no range check. */
  private final CellAxis single;

  private final double originX;
  private final double originY;

  /** The cells of the first level. A single level needs no {@link CellLinks}. */
  private final CellGrid cells;

  /** With several levels, of each: its own circles, and the smaller ones that it lists too. */
  private final CellLinks[] own;

  private final CellLinks[] smaller;
  private final short[] levelOf;

  /** The cell of circle i on a coarser level k, as whole numbers, at [(k * count + i) * 2]. */
  private final double[] coarse;

  /** The only circle that these cells are for; NONE if there are several. */
  private final int only;

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
    only = ids.length == 1 ? ids[0] : Index.NONE;
    BoundingBox extent = BoundingBox.of(circles, ids, walls, now);
    double before = only == Index.NONE ? 0 : SizeClasses.ENDLESS / 2;
    originX = extent.left() - before;
    originY = extent.bottom() - before;
    sizes = new SizeClasses(circles, ids, extent, diameters);
    levels = sizes.widths.length;
    cells = levels == 0 ? null : cells(extent, sizes.widths[0]);
    axes = new CellAxis[levels];
    own = new CellLinks[levels];
    smaller = new CellLinks[levels];
    levelOf = new short[count];
    falls = circles.allowsGravity();
    int[] next = new int[levels == 1 ? 0 : count];
    for (int k = 0; k < levels; k++) {
      double width = sizes.widths[k];
      axes[k] = new CellAxis(width, powerOfTwo(extent.side() / width));
      own[k] = new CellLinks(k == 0 ? cells : cells(extent, width), next, null);
      smaller[k] =
          k == 0 ? null : new CellLinks(cells(extent, width), new int[count], new int[count]);
    }
    for (int i = 0; i < count; i++) {
      codes[CircleTable.collidingCodesAt(i) + CircleTable.FOLLOWER] = Index.NONE;
    }
    single = levels == 1 ? axes[0] : null;
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
    int nx = powerOfTwo(extent.width() / cellWidth + 2);
    int ny = powerOfTwo(extent.height() / cellWidth + 2);
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
    boolean open = w == null;
    CellAxis axis = axes[level];
    inside[k] = open ? -NEVER : axis.cell(w[Codes.LEFT] + distance - originX) + 1;
    inside[k + 1] = open ? NEVER : axis.cell(w[Codes.RIGHT] - distance - originX);
    inside[k + 2] = open ? -NEVER : axis.cell(w[Codes.BOTTOM] + distance - originY) + 1;
    inside[k + 3] = open ? NEVER : axis.cell(w[Codes.TOP] - distance - originY);
  }

  /**
   * Lists a circle where it is at a given time.
   *
   * @return false if no level was made for its radius, or the cells for one other circle
   */
  public boolean enter(int i, double now) {
    if (only != Index.NONE && i != only) {
      return false;
    }
    int level = sizes.of(circles.radius(i));
    if (level < 0) {
      return false;
    }
    levelOf[i] = (short) level;
    if (falls) {
      state[CircleTable.collidingAt(i) + CircleTable.ENTERED] = circles.since(i, now);
    }
    enter(i, circles.x(i, now) - originX, circles.y(i, now) - originY);
    return true;
  }

  private void enter(int i, double x, double y) {
    for (int level = levelOf[i]; level < levels; level++) {
      int k = cellAt(i, level);
      double[] cellsOf = cellsOf(i, level);
      cellsOf[k] = axes[level].cell(x);
      cellsOf[k + 1] = axes[level].cell(y);
      add(i, level, own[level].cells.cell(wrapped(cellsOf[k]), wrapped(cellsOf[k + 1])));
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
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    CellAxis axis = axis(i);
    if (!axis.holds(s[a + CircleTable.COLUMN], x) || !axis.holds(s[a + CircleTable.ROW], y)) {
      leave(i);
      enter(i, x, y);
    }
  }

  /** Removes a circle from all lists. */
  public void leave(int i) {
    for (int level = levelOf(i); level < levels; level++) {
      remove(i, level, cell(i, level));
    }
  }

  private void remove(int i, int level, int cell) {
    if (levels == 1) {
      cells.remove(codes, i, cell);
    } else {
      list(i, level).remove(i, cell);
    }
  }

  /** The level of a circle; no memory is read if there is only one. */
  private int levelOf(int i) {
    return levels == 1 ? 0 : levelOf[i];
  }

  private CellAxis axis(int i) {
    return levels == 1 ? single : axes[levelOf[i]];
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

  /** Whether more than half of the circles are outside the region, where cells are wide. */
  boolean isRegionLeft(LiveCodes present) {
    int far = 0;
    for (int k = 0; k < present.size(); k++) {
      far += isFar(present.get(k)) ? 1 : 0;
    }
    return 2 * far > present.size();
  }

  private boolean isFar(int i) {
    int a = CircleTable.collidingAt(i);
    CellAxis axis = axis(i);
    return axis.isFar(state[a + CircleTable.COLUMN]) || axis.isFar(state[a + CircleTable.ROW]);
  }

  /** When circle i next leaves a cell; stores which {@linkplain CellExit way} in its row. */
  public double nextCrossing(double[] s, int[] c, int i) {
    int a = CircleTable.collidingAt(i);
    double x = s[a + FlightRow.X] - originX;
    double y = s[a + FlightRow.Y] - originY;
    double vx = s[a + FlightRow.VX];
    double vy = s[a + FlightRow.VY];
    double gx = circles.gx(i);
    double gy = circles.gy(i);
    double since = s[a + CircleTable.ENTERED];
    int own = levelOf(i);
    CellAxis axis = axis(i);
    double dx = FallingExit.ahead(x, vx, gx, since, s[a + CircleTable.COLUMN], axis);
    double dy = FallingExit.ahead(y, vy, gy, since, s[a + CircleTable.ROW], axis);
    double first = Math.min(dx, dy);
    int way = CellExit.way(own, dx, dy, vx, vy);
    for (int level = own + 1; level < levels; level++) {
      int k = cellAt(i, level);
      dx = FallingExit.ahead(x, vx, gx, since, coarse[k], axes[level]);
      dy = FallingExit.ahead(y, vy, gy, since, coarse[k + 1], axes[level]);
      if (Math.min(dx, dy) < first) {
        way = CellExit.way(level, dx, dy, vx, vy);
      }
      first = Math.min(first, Math.min(dx, dy));
    }
    return Double.isNaN(first) ? nextCrossingOfTurning(s, c, i) : keepCrossing(s, c, i, first, way);
  }

  /** The same for a circle that may turn back in its cell. */
  private double nextCrossingOfTurning(double[] s, int[] c, int i) {
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
      exitX.find(x, vx, circles.gx(i), since, cellsOf[k], axes[level]);
      exitY.find(y, vy, circles.gy(i), since, cellsOf[k + 1], axes[level]);
      double soonest = Math.min(exitX.after, exitY.after);
      if (soonest < first) {
        first = soonest;
        way = CellExit.way(level, exitX.after, exitY.after, exitX.direction, exitY.direction);
      }
    }
    return keepCrossing(s, c, i, first, way);
  }

  /** Keeps when and which way a circle leaves its cell; returns the time. */
  private static double keepCrossing(double[] s, int[] c, int i, double after, int way) {
    c[CircleTable.collidingCodesAt(i) + CircleTable.WAY] = way;
    int a = CircleTable.collidingAt(i);
    s[a + CircleTable.LEAVING] = after;
    return after < NEVER ? MovingCircle.sum(s[a + FlightRow.T], s[a + FlightRow.TL], after) : NEVER;
  }

  /** How long after the start of its flight circle i leaves a cell, by {@link #nextCrossing}. */
  static double untilCrossing(double[] s, int i) {
    return s[CircleTable.collidingAt(i) + CircleTable.LEAVING];
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
      int cell = cell(i, level);
      end = own[level].around(cell, found, end);
      if (hasSmaller(i, level)) {
        end = smaller[level].around(cell, found, end);
      }
    }
    return end;
  }

  /**
   * Adds the circles that may be nearer to a place than a given distance, each once.
   *
   * @param distance from the place to the circle, not to its centre
   */
  void addNear(double x, double y, double distance, IntList into) {
    for (int level = 0; level < levels; level++) {
      double half = distance + sizes.radii[level] + sizes.slack();
      CellGrid grid = own[level].cells;
      CellAxis axis = axes[level];
      double left = axis.cell(x - originX - half);
      double bottom = axis.cell(y - originY - half);
      double columns = axis.cell(x - originX + half) - left + 1;
      double rows = axis.cell(y - originY + half) - bottom + 1;
      int width = (int) Math.min(columns, grid.columns());
      // Row after row on a ring: columns beyond a whole row stand in the rows above.
      double above = Math.floor((columns - 1) / grid.columns());
      int height = (int) Math.min(rows + above, grid.rows());
      for (int row = 0; row < height; row++) {
        for (int column = 0; column < width; column++) {
          int cell = grid.cell(wrapped(left) + column, wrapped(bottom) + row);
          addListed(level, grid.first(cell), into);
        }
      }
    }
  }

  private void addListed(int level, int first, IntList into) {
    for (int i = first; i != Index.NONE; ) {
      into.add(i);
      i =
          levels == 1
              ? codes[CircleTable.collidingCodesAt(i) + CircleTable.FOLLOWER]
              : own[level].next(i);
    }
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
