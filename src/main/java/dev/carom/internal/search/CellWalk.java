// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.UnitVectors;

/**
 * The walk of a grid along a straight line: it visits the cells one after the other, rejects the
 * lines that are certainly missed, and shows the others to the search that extends it. It extends
 * {@link FirstImpact}, so that all share the numbers of the flight.
 */
abstract class CellWalk extends FallTimes {

  /** Ticks in which a cell is crossed at the Manhattan speed. */
  static final double TICKS = 0x1p30;

  /**
   * Each axis counts as faster by this part of the Manhattan speed, so that none rests: by 2^-16
   * cells on a path of 2^14 cells.
   */
  private static final double DRIFT = 0x1p-30;

  /** The obstacles at rest that are in no grid. */
  final CodeSet loose;

  /** Whether any obstacle moves, or moved before. */
  boolean moving;

  /** The path that the circle takes. */
  final FallPath path = new FallPath();

  /** The rows of the lines, by their codes. */
  double[] lines;

  /** The way in a unit of time. */
  private double wayX;

  private double wayY;

  /** |vx| + |vy|: computed sooner than |v| or the larger of the two. */
  double manhattanSpeed;

  /** A little less than 1 / |vx| and 1 / |vy|, see {@link #DRIFT}. */
  double perVx;

  double perVy;

  /**
   * Coefficients of the cross product of (x, y) less a point of the line, and v: {@code x crossX +
   * y crossY + crossOfOrigin}. All three are 0 where errors are not bounded; then nothing is
   * rejected.
   */
  double crossX;

  double crossY;
  double crossOfOrigin;

  /** A line is certainly missed if both its ends lie further than this on one side, times 2 |v|. */
  double clear;

  /** The code of a line that is not hit along the way, or NOTHING. */
  int spared;

  CellWalk(ObstacleTable obstacles, CodeSet loose) {
    super(obstacles);
    this.loose = loose;
  }

  @Override
  void start(MovingCircle m) {
    super.start(m);
    lines = obstacles.lines.values;
    moving = obstacles.areMoving();
  }

  // What the searches do with the obstacles.

  /**
   * Searches among the obstacles at rest.
   *
   * @param needed the time up to which the path must be known
   * @return the time up to which all impacts are found
   */
  abstract double search(Grid grid, double needed);

  /** Finds the moving obstacles that the path may meet between two times in a window. */
  final void findMoving(MotionWindow window, double from, double end) {
    path.start(body);
    path.takeChordAndBox(from, end);
    window.find(obstacles, path.left, path.bottom, path.right, path.top);
  }

  /**
   * Considers number i of the obstacles that move, up to a time or to its arrival. For a flight
   * that starts then it is at rest, which the engine says once the flight goes on.
   */
  final void considerMoving(int i, double end) {
    double start = obstacles.epoch() + body.t;
    double arrival = obstacles.motions().until(i) - start - body.tl;
    if (arrival > 0) {
      considerMotion(i, Math.min(end, arrival));
    }
  }

  /** Considers number i of the obstacles that move, up to a time, as if it never stopped. */
  abstract void considerMotion(int i, double end);

  /** Considers an obstacle at rest, whose place no filter tells. */
  abstract void considerOnly(int code);

  /** Forgets what was hit or reported before the flight. */
  abstract void forgetHits();

  /** Notes that the walk visits a cell that lists something, between two ticks. */
  void enter(long entered, long left) {}

  /** Considers a line that a cell lists. */
  abstract void look(int line);

  /** Considers an obstacle other than a wall. */
  abstract void consider(int code);

  /** Computes the time of the best impact exactly, if it is rough. */
  void settle() {}

  /** Considers each obstacle at rest. */
  final void considerEach() {
    for (int kind = 0; kind < obstacles.kinds.size(); kind++) {
      LiveCodes present = obstacles.kinds.get(kind).present();
      for (int i = 0; i < present.size(); i++) {
        if (!moving || !obstacles.moves(present.get(i))) {
          consider(present.get(i));
        }
      }
    }
  }

  final void considerLoose() {
    for (int i = 0; i < loose.size; i++) {
      consider(loose.codes[i]);
    }
  }

  // The walk.

  /** Takes the way in a unit of time, whose Manhattan length counts as not less than its own. */
  final void head(double toX, double toY, double length) {
    wayX = toX;
    wayY = toY;
    manhattanSpeed = length;
    perVx = 1 / fma(length, DRIFT, Math.abs(toX));
    perVy = 1 / fma(length, DRIFT, Math.abs(toY));
  }

  /** The ticks of that way. */
  final double ticks(Grid grid) {
    return manhattanSpeed * TICKS * grid.perCell;
  }

  /**
   * Visits the cells along the way taken. It ends when the best impact or a given time lies in a
   * visited cell, after so many ticks, or where the grid ends.
   *
   * <p>Times are whole ticks. So a mask, and not an unpredictable branch, chooses between the next
   * column and the next row. A path of 2^14 cells is rounded to ticks as often: by less than 2^-15
   * cells in all.
   *
   * @param x where it starts, in columns of the grid
   * @param y the same in rows
   * @param start the time at which it is there
   * @param rate the ticks in a unit of time
   * @param ahead the path need not be known beyond this time
   * @return the time until which the path is known
   */
  final double walk(
      Grid grid, double x, double y, double start, double rate, double mostTicks, double ahead) {
    int column = grid.column(x);
    int row = grid.row(y);
    double ticks = manhattanSpeed * TICKS;
    // Ticks until the next column and the next row, and ticks from each to the one after it.
    double columnTicks = ticks * perVx;
    double rowTicks = ticks * perVy;
    long nextX = (long) (Grid.toEdge(x - column, wayX) * columnTicks);
    long nextY = (long) (Grid.toEdge(y - row, wayY) * rowTicks);
    long perX = (long) columnTicks;
    long perY = (long) rowTicks;
    int nextRow = UnitVectors.sign(wayY) * grid.stride;
    int nextColumn = UnitVectors.sign(wayX) - nextRow;
    int cell = grid.number(column, row);
    long[] lists = grid.lists;
    double most = Math.min((ahead - start) * rate, mostTicks);
    long end = (long) Math.min((latest - start) * rate, most);
    // The ticks by which the next column comes after the next row, and the change by a step.
    long lead = nextX - nextY;
    long perBoth = perX + perY;
    long list = lists[cell];
    int near = near(list);
    while (true) {
      if (near != 0) {
        if (list == CellList.OUTSIDE) {
          settle();
          return Math.min(best, ahead);
        }
        enter(Math.max(nextY - perY, nextY + lead - perX), nextY + (lead & (lead >> 63)));
        if (near > 0) {
          look(list, near);
        } else {
          visit(grid, list);
        }
        end = (long) Math.min((latest - start) * rate, most);
      }
      do {
        // The lesser of the two, branch-free: Math.min compiles to a branch that is unpredictable
        // here.
        long isColumn = lead >> 63;
        long left = nextY + (lead & isColumn);
        if (end <= left) {
          settle();
          double first = Math.min(best, ahead);
          return (long) ((first - start) * rate) <= left ? first : start + left / rate;
        }
        nextY += perY & ~isColumn;
        lead += (perBoth & isColumn) - perY;
        cell += nextRow + (nextColumn & (int) isColumn);
        list = lists[cell];
        near = near(list);
      } while (near == 0);
    }
  }

  /**
   * Shows what a cell lists, unless that is a pair of lines, which the walk looks at itself:
   * through this method each of them would cost two calls.
   */
  private void visit(Grid grid, long list) {
    if (CellList.areOthers(list)) {
      considerOthers(list);
    } else {
      visitAll(grid.pairs, CellList.start(list));
    }
  }

  private void visitAll(long[] pairs, int from) {
    int k = from;
    long pair;
    do {
      pair = pairs[k++];
      if (CellList.areOthers(pair)) {
        considerOthers(pair);
      } else {
        long pairOfLines = CellList.withoutMore(pair);
        int near = near(pairOfLines);
        if (near != 0) {
          look(pairOfLines, near);
        }
      }
    } while (CellList.isMore(pair));
  }

  private void considerOthers(long pair) {
    count(pair);
    int first = CellList.first(pair);
    int second = CellList.second(pair);
    consider(first);
    if (second != first) {
      consider(second);
    }
  }

  /**
   * Shows the lines of a pair that are near; a line alone stands twice, and is shown once. One call
   * in a loop, as a compiler that copies its body twice makes slower code.
   */
  private void look(long pair, int near) {
    int number = ~near & 1;
    int last = CellList.first(pair) == CellList.second(pair) ? number : near >>> 1;
    for (; number <= last; number++) {
      look(CellList.code(pair, number));
    }
  }

  /**
   * Which lines of a pair may be hit: bit 0 for the first one, bit 1 for the second; -1 for other
   * lists. It has one branch only: one for rejected lines would be unpredictable, and so would one
   * for empty lists.
   */
  final int near(long list) {
    if (!CellList.isPairOfLines(list)) {
      return -1;
    }
    count(list);
    return isNear(CellList.first(list)) | (isNear(CellList.second(list)) << 1);
  }

  /**
   * 0 if both ends of a line lie on the same side of the path, further from it than the radius, or
   * if the line is spared; else 1. For the row of a wall the result may be either.
   */
  private int isNear(int code) {
    // Reads of the first and the last number first spare the range checks of those between.
    int k = code * LineShape.ROW;
    double ax = lines[k + LineShape.AX];
    double by = lines[k + LineShape.BY];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double a = ay * crossY + (ax * crossX + crossOfOrigin);
    double b = by * crossY + (bx * crossX + crossOfOrigin);
    // min(|a|, |b|) if they have one sign, without a branch: (|a + b| - |a - b|) / 2
    double beyond = Math.abs(a + b) - (Math.abs(a - b) + clear);
    int other = code ^ spared; // 0 if the line is spared
    int isSpared = ((other - 1) & ~other) >>> 31;
    return (int) (Double.doubleToRawLongBits(beyond) >>> 63) & ~isSpared;
  }

  private static void count(long pair) {
    if (PrecisionCounter.IS_COUNTING && pair != 0) {
      PrecisionCounter.PAIR_TESTS.add(CellList.first(pair) == CellList.second(pair) ? 1 : 2);
    }
  }
}
