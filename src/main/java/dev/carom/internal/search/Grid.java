// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.util.IntList;
import java.util.Arrays;

/**
 * A uniform grid over the lines and pegs of a scene. Each cell lists all obstacles that a circle of
 * at most a given radius could touch while its centre is in the cell.
 *
 * <p>Lists are made for cells that are larger by a margin. A path of at most 2^14 cells is followed
 * with an error below 2^-10 cells. So rounding can lead to a neighbor of the true cell only where
 * both lists hold what the circle can touch. The rest of the margin is for paths that bend: a piece
 * that leaves a straight line by no more than this rest counts as straight.
 */
public final class Grid {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Cells an axis at most. */
  private static final int MOST = 1 << 13;

  /** The margin of lists where circles fly straight, in cells. */
  static final double MARGIN = 0x1p-8;

  /** The margin where circles fall. More makes the straight pieces longer, but also the lists. */
  static final double MARGIN_OF_FALLS = 0x1p-5;

  /** The part of the margin that covers rounding, in cells. */
  private static final double ROUNDING = 0x1p-10;

  /** The most cells a unit of time with which times and cells convert; its inverse is the least. */
  private static final double MOST_PACE = 0x1p500;

  private static final double LEAST_SPEED = 0x1p-900;

  private static final double CELLS_EACH = 3;

  /** Beyond these sizes of coordinates, numbers of cells could overflow or underflow. */
  private static final double LARGEST = 0x1p400;

  private static final double SMALLEST = 0x1p-400;

  final double cell;
  final int columns;
  final int rows;

  /** The difference of the numbers of a cell and of the one in the next row. */
  final int stride;

  /** The list of each cell, by its number: a {@link CellList}. */
  final long[] lists;

  /** The pairs of longer lists, see {@link CellList}. */
  final long[] pairs;

  /**
   * Places so far from the origin are not resolved, nor speeds and accelerations outside of this
   * range.
   */
  private final double farthest;

  private final double slowest;
  private final double fastest;

  private final double xmin;
  private final double ymin;
  private final double xmax;
  private final double ymax;

  /** 1 / {@link #cell}, which multiplies where the walk cannot afford a division. */
  final double perCell;

  private final double margin;

  /** A path that leaves a straight line by no more than this counts as straight. */
  final double bend;

  /** The largest |x| + |y| of a place in the grid. */
  final double largestSum;

  private final ObstacleTable obstacles;

  /** The largest radius of a circle that it serves. */
  public final double radius;

  /**
   * Lists all obstacles for circles of up to the given radius.
   *
   * @param cell the size of a cell, or 0 to have it chosen
   * @param margin of the lists, in cells
   */
  Grid(ObstacleTable obstacles, double radius, double cell, double margin) {
    this.obstacles = obstacles;
    this.radius = radius;
    this.margin = margin;
    int[] codes =
        obstacles.kinds.stream()
            .flatMapToInt(kind -> kind.present().stream(code -> !obstacles.isStatic(code)))
            .toArray();
    double[] box = box(codes);
    double width = box[BoxTree.RIGHT] - box[BoxTree.LEFT];
    double height = box[BoxTree.TOP] - box[BoxTree.BOTTOM];
    this.cell = cell > 0 ? cell : chosen(width, height);
    xmin = box[BoxTree.LEFT] - this.cell;
    ymin = box[BoxTree.BOTTOM] - this.cell;
    columns = (int) Math.ceil(width / this.cell) + 2;
    rows = (int) Math.ceil(height / this.cell) + 2;
    xmax = xmin + columns * this.cell;
    ymax = ymin + rows * this.cell;
    perCell = 1 / this.cell;
    bend = (margin - ROUNDING) * this.cell;
    largestSum =
        Math.max(Math.abs(xmin), Math.abs(xmax)) + Math.max(Math.abs(ymin), Math.abs(ymax));
    stride = columns + 2;
    farthest = this.cell * 0x1p40 - (Math.abs(xmin) + Math.abs(ymin));
    slowest = Math.max(LEAST_SPEED, this.cell / MOST_PACE);
    fastest = this.cell * MOST_PACE;
    int[] starts = new int[columns * rows + 1];
    int[] listed = list(codes, starts);
    lists = new long[stride * (rows + 2)];
    pairs = pack(starts, listed);
  }

  /** Whether a grid can be made of obstacles with this largest coordinate. */
  static boolean serves(double extent) {
    return extent > SMALLEST && extent < LARGEST;
  }

  /** The pairs that longer lists take. */
  private static int room(int[] starts, int[] listed) {
    int room = 0;
    for (int i = 1; i < starts.length; i++) {
      int lines = firstOther(listed, starts[i - 1], starts[i]) - starts[i - 1];
      int others = starts[i] - starts[i - 1] - lines;
      room += isLong(lines, others) ? (lines + 1) / 2 + (others + 1) / 2 : 0;
    }
    return room;
  }

  private static boolean isLong(int lines, int others) {
    return lines + others > 2 || (lines > 0 && others > 0);
  }

  /** Packs the lists of all cells; returns the pairs of the longer ones. */
  private long[] pack(int[] starts, int[] listed) {
    Arrays.fill(lists, CellList.OUTSIDE);
    long[] all = new long[1 + room(starts, listed)];
    int end = 1; // a list at 0 would be OUTSIDE
    for (int i = 0; i < columns * rows; i++) {
      int from = starts[i];
      int to = starts[i + 1];
      int others = firstOther(listed, from, to);
      long list = CellList.EMPTY;
      if (isLong(others - from, to - others)) {
        list = CellList.startingAt(end);
        end = packPairs(listed, from, others, all, end);
        end = packPairs(listed, others, to, all, end);
        all[end - 1] = CellList.withoutMore(all[end - 1]);
      } else if (from < to) {
        list = CellList.ofPair(listed[from], listed[to - 1]);
      }
      lists[number(i % columns, i / columns)] = list;
    }
    return all;
  }

  private static int firstOther(int[] listed, int from, int to) {
    int k = from;
    while (k < to && Codes.isLine(listed[k])) {
      k++;
    }
    return k;
  }

  /** Appends codes in pairs, and returns the end. */
  private static int packPairs(int[] listed, int from, int to, long[] pairs, int end) {
    int k = end;
    for (int i = from; i < to; i += 2) {
      pairs[k++] = CellList.withMore(listed[i], listed[Math.min(i + 1, to - 1)]);
    }
    return k;
  }

  /** The number of a cell. */
  int number(int column, int row) {
    return (row + 1) * stride + column + 1;
  }

  /**
   * The size of a cell: {@link #CELLS_EACH} cells an obstacle, but none smaller than the radius.
   * Measured: some more or fewer cells cost the same.
   */
  private double chosen(double width, double height) {
    double fair = Math.sqrt(width * height / (CELLS_EACH * obstacles.staticSize()));
    double least = Math.max(width, height) / MOST;
    return Math.max(Math.max(fair, radius), least);
  }

  /** The box around all obstacles, grown by the radius: outside of it none can be hit. */
  private double[] box(int[] codes) {
    double[] box = {NEVER, NEVER, -NEVER, -NEVER};
    for (int code : codes) {
      ObstacleRows rows = obstacles.of(code);
      int k = rows.offset(code);
      double grown = radius + rows.shape.radius(rows.values, k);
      for (int end = k + rows.shape.coordinates; k < end; k += 2) {
        box[BoxTree.LEFT] = Math.min(box[BoxTree.LEFT], rows.values[k] - grown);
        box[BoxTree.BOTTOM] = Math.min(box[BoxTree.BOTTOM], rows.values[k + 1] - grown);
        box[BoxTree.RIGHT] = Math.max(box[BoxTree.RIGHT], rows.values[k] + grown);
        box[BoxTree.TOP] = Math.max(box[BoxTree.TOP], rows.values[k + 1] + grown);
      }
    }
    return box;
  }

  /**
   * Adds the codes of the obstacles that a circle could touch whose centre is within a distance of
   * a place on each axis; some may be there more than once.
   */
  void addNear(double x, double y, double distance, IntList into) {
    if (!meets(x - distance, y - distance, x + distance, y + distance)) {
      return;
    }
    int left = column(columns(x - distance));
    int right = column(columns(x + distance));
    int top = row(rows(y + distance));
    for (int row = row(rows(y - distance)); row <= top; row++) {
      for (int column = left; column <= right; column++) {
        addListed(lists[number(column, row)], into);
      }
    }
  }

  private void addListed(long list, IntList into) {
    if (CellList.isPairOfLines(list) || CellList.areOthers(list)) {
      addPair(list, into);
    } else {
      int k = CellList.start(list);
      addPair(pairs[k], into);
      while (CellList.isMore(pairs[k])) {
        k++;
        addPair(pairs[k], into);
      }
    }
  }

  private static void addPair(long pair, IntList into) {
    int first = CellList.first(pair);
    int second = CellList.second(pair);
    if (!Codes.isWall(first)) {
      into.add(first);
    }
    if (second != first && !Codes.isWall(second)) {
      into.add(second);
    }
  }

  /** Reads the lists of the cells around a place, to have them in the cache. */
  public long around(double x, double y) {
    int cell = number(column(columns(x)), row(rows(y)));
    return (lists[cell - stride - 1] + lists[cell - stride + 1])
        + (lists[cell - 1] + lists[cell + 1])
        + (lists[cell + stride - 1] + lists[cell + stride + 1]);
  }

  int cells() {
    return columns * rows;
  }

  /**
   * Whether a path from this place can be followed. The place is at most about 2^40 cells from the
   * origin, so that its rounding stays far below the margin. The Manhattan speed is in the range in
   * which times and cells convert. One axis may be slower: 1 / |v| overflows only far below that
   * range.
   */
  boolean resolves(double x, double y, double speed) {
    return Math.abs(x) + Math.abs(y) < farthest && speed > slowest && speed < fastest;
  }

  /**
   * The same as {@link #resolves}, for a path with an acceleration.
   *
   * @param size |x| + |y| is at most this
   * @param speed the Manhattan speed is at most this; it may be 0
   * @param pull the Manhattan size of the acceleration; it may be 0
   */
  boolean resolvesFall(double size, double speed, double pull) {
    return size < farthest && speed < fastest && pull < fastest && (pull > slowest || pull == 0);
  }

  boolean contains(double x, double y) {
    return x >= xmin && x <= xmax && y >= ymin && y <= ymax;
  }

  /** Whether a box overlaps the grid. */
  boolean meets(double left, double bottom, double right, double top) {
    return right >= xmin && left <= xmax && top >= ymin && bottom <= ymax;
  }

  /**
   * The time at which a path from (x, y) along (vx, vy) is first inside, at {@code from} or later;
   * {@code +infinity} if it never is.
   */
  double entry(double x, double y, double vx, double vy, double from) {
    double enter = Math.max(enter(x, vx, xmin, xmax, from), enter(y, vy, ymin, ymax, from));
    double leave = Math.min(leave(x, vx, xmin, xmax), leave(y, vy, ymin, ymax));
    return enter <= leave ? enter : NEVER;
  }

  private static double enter(double p, double v, double low, double high, double from) {
    if (v == 0) {
      return p >= low && p <= high ? from : NEVER;
    }
    return Math.max(from, ((v < 0 ? high : low) - p) / v);
  }

  private static double leave(double p, double v, double low, double high) {
    return v == 0 ? NEVER : ((v < 0 ? low : high) - p) / v;
  }

  /** The number of columns between the left edge of the grid and x; negative beyond it. */
  double columns(double x) {
    return (x - xmin) * perCell;
  }

  double rows(double y) {
    return (y - ymin) * perCell;
  }

  /** The column that has so many before it; for a place outside of the grid the nearest one. */
  int column(double columnsBefore) {
    return Math.max(0, Math.min(columns - 1, (int) columnsBefore));
  }

  int row(double rowsBefore) {
    return Math.max(0, Math.min(rows - 1, (int) rowsBefore));
  }

  /** The distance of a place in a cell of size 1 from the edge through which v leaves the cell. */
  static double toEdge(double place, double v) {
    return Math.abs(place - 0.5 - Math.copySign(0.5, v));
  }

  /** Lists the codes of each cell, in two passes over the obstacles: counts, then fills. */
  private int[] list(int[] codes, int[] starts) {
    int cells = columns * rows;
    int[] counts = new int[cells + 1];
    for (int code : codes) {
      visit(code, counts, null);
    }
    for (int i = 0; i < cells; i++) {
      starts[i + 1] = starts[i] + counts[i];
      counts[i] = starts[i];
    }
    int[] listed = new int[starts[cells]];
    for (int code : codes) {
      visit(code, counts, listed);
    }
    return listed;
  }

  /** Puts a code into the list of every cell that it can reach into, or only counts it. */
  private void visit(int code, int[] counts, int[] listed) {
    ObstacleRows rows = obstacles.of(code);
    double[] values = rows.values;
    int k = rows.offset(code);
    double ax = values[k + ObstacleShape.X];
    double ay = values[k + ObstacleShape.Y];
    double bx = values[k + rows.shape.toEnd + ObstacleShape.X];
    double by = values[k + rows.shape.toEnd + ObstacleShape.Y];
    double grown = radius + rows.shape.radius(values, k) + margin * cell;
    int left = column(columns(Math.min(ax, bx) - grown));
    int right = column(columns(Math.max(ax, bx) + grown));
    int bottom = row(rows(Math.min(ay, by) - grown));
    int top = row(rows(Math.max(ay, by) + grown));
    // Only the direction counts: in units of its size squares do not underflow.
    int size = Math.getExponent(Math.max(Math.abs(bx - ax), Math.abs(by - ay)));
    double wx = Math.scalb(bx - ax, -size);
    double wy = Math.scalb(by - ay, -size);
    // A cell's centre c is out of reach if |cross(w, c - a)| > grown |w| + (|wx| + |wy|) cell / 2.
    double strip =
        (grown * Math.sqrt(wx * wx + wy * wy) + (Math.abs(wx) + Math.abs(wy)) * cell / 2)
            * (1 + 0x1p-20);
    for (int row = bottom; row <= top; row++) {
      double dy = ymin + (row + 0.5) * cell - ay;
      for (int column = left; column <= right; column++) {
        double dx = xmin + (column + 0.5) * cell - ax;
        if (!(Math.abs(wx * dy - wy * dx) > strip)) {
          int i = row * columns + column;
          if (listed != null) {
            listed[counts[i]] = code;
          }
          counts[i]++;
        }
      }
    }
  }
}
