// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.PrecisionCounters;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.SegmentFilter;
import dev.carom.internal.sweep.UnitVectors;
import dev.carom.internal.util.Kind;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The broad phase of a flight among obstacles: walks the cells along the path, rejects the
 * obstacles that are certainly missed, and leaves the others to the {@link NarrowPhase}.
 *
 * <p>It extends the narrow phase, so that both share the numbers of the flight.
 */
public final class BroadPhase extends NarrowPhase {

  /** Ticks in which a cell is crossed at the Manhattan speed. */
  static final double TICKS = 0x1p30;

  /**
   * Each axis counts as faster by this part of the Manhattan speed, so that none rests: by 2^-16
   * cells on a path of 2^14 cells.
   */
  static final double DRIFT = 0x1p-30;

  /** The margin of the lists covers this part of a cell beyond the visited ones. */
  private static final double NEAR_CELLS = 0x1p-10;

  /** Least speed, and least speed times size, for which the bounds cover underflow. */
  private static final double LEAST_SAFE = 0x1p-900;

  /** No overflow up to this: a sum of two cross products is at most 8 times as large. */
  private static final double MOST_SAFE = 0x1p1020;

  /** A window lasts for so many more steps like the one at which it begins. */
  private static final int STEPS_OF_WINDOW = 64;

  private final CodeSet loose;

  /** The middle of the bounds, and its distances from the walls. */
  private final double middleX;

  private final double middleY;
  private final double halfWidth;
  private final double halfHeight;

  /** No coordinate of a line, a peg or the bounds is larger. */
  private double extent;

  /** |vx| + |vy|: computed sooner than |v| or the larger of the two. */
  private double manhattanSpeed;

  /** A little less than 1 / |vx| and 1 / |vy|, see {@link #DRIFT}. */
  private double perVx;

  private double perVy;

  /**
   * Coefficients of the cross product of (x, y) less the start, and v: {@code x crossX + y crossY +
   * crossOfOrigin}. All three are 0 where errors are not bounded; then no line is rejected.
   */
  private double crossX;

  private double crossY;
  private double crossOfOrigin;

  /** A line is certainly missed if both its ends lie further than this on one side, times 2 |v|. */
  private double clear;

  /** A circle whose centre is further than this from a wall certainly does not touch it. */
  private double inset;

  /**
   * A time at or shortly before the impact with the next wall on each axis. The impact itself is
   * computed only if nothing comes before.
   */
  private double aheadX;

  private double aheadY;

  /** The obstacles that move, indexed over a window of time. */
  private final MotionWindow window = new MotionWindow();

  /** Searches among obstacles; those in the given list are in no grid. */
  public BroadPhase(ObstacleTable obstacles, CodeSet loose) {
    super(obstacles);
    this.loose = loose;
    double[] w = obstacles.walls;
    middleX = w == null ? 0 : w[Codes.LEFT] / 2 + w[Codes.RIGHT] / 2;
    middleY = w == null ? 0 : w[Codes.BOTTOM] / 2 + w[Codes.TOP] / 2;
    halfWidth = w == null ? NEVER : w[Codes.RIGHT] / 2 - w[Codes.LEFT] / 2;
    halfHeight = w == null ? NEVER : w[Codes.TOP] / 2 - w[Codes.BOTTOM] / 2;
    lookAgainAtAll();
  }

  /** A search among the same obstacles as another one, in its initial state. */
  BroadPhase(BroadPhase other) {
    super(other.obstacles);
    loose = other.loose;
    middleX = other.middleX;
    middleY = other.middleY;
    halfWidth = other.halfWidth;
    halfHeight = other.halfHeight;
    extent = other.extent;
    readAgain();
  }

  /** Notes that a line or a peg was added, moved or removed. */
  public void lookAgain(int code) {
    window.changed(obstacles.motions(), code);
    extent = Math.max(extent, obstacles.extent(code));
    readAgain();
  }

  /** Notes that any obstacle may have changed. */
  public void lookAgainAtAll() {
    double ofBounds =
        obstacles.walls == null
            ? 0
            : Math.max(Math.abs(middleX) + halfWidth, Math.abs(middleY) + halfHeight);
    extent = Math.max(obstacles.extent(), ofBounds);
    window.changedAll();
    readAgain();
  }

  /**
   * Searches the path of a circle further: up to its next impact, or beyond the time asked for.
   *
   * @param grid the grid of the obstacles, or null to test each of them
   * @param needed the time, from the start of the flight, up to which the path must be known
   */
  public void extend(MovingCircle body, Grid grid, double needed) {
    if (!moving) {
      extendAmongStatic(body, grid, needed);
      return;
    }
    double from = body.cleared;
    double end = window.end - obstacles.epoch() - body.t - body.tl;
    if (obstacles.epoch() + body.t + from >= window.begin && from < end) { // in the window
      body.lookahead = MovingCircle.EDITED_LOOKAHEAD; // no further than the window
      extendAmongStatic(body, grid, Math.max(needed, end));
      extendAmongMoving(body, from, end);
    } else {
      extendAmongStatic(body, grid, needed);
      considerMoving(body.cleared);
      keep(body, body.cleared);
    }
  }

  private void extendAmongStatic(MovingCircle body, Grid grid, double needed) {
    start(body);
    measure();
    if (!canHit()) {
      body.cleared = NEVER;
      body.next = MovingCircle.NOTHING;
      return;
    }
    double ahead = wallAhead();
    // The last cell before the wall is visited in any case, and its list reaches up to the wall.
    double from = Math.min(body.cleared, ahead);
    double known = explore(body, grid, from, needed, ahead);
    if (known >= ahead) {
      walls();
      known = best;
      if (grid != null && isFar(ahead, grid)) {
        known = explore(body, grid, Math.max(body.cleared, ahead), needed, best);
      }
    }
    if (known == best && known != NEVER) {
      body.predict(best, bestCode, bestContact);
    } else {
      body.clearUpTo(known);
    }
  }

  /**
   * Considers the moving obstacles whose boxes the path meets, up to the time until which it is
   * known among the others, and no further than the window of time goes.
   */
  private void extendAmongMoving(MovingCircle body, double from, double end) {
    double known = Math.min(body.cleared, end);
    window.find(
        obstacles, fma(vx, from, px), fma(vy, from, py), fma(vx, known, px), fma(vy, known, py), r);
    considerFound(known);
    keep(body, known);
  }

  /** Stores the first impact up to a time; without one, that the path is known free up to there. */
  private void keep(MovingCircle body, double known) {
    if (best <= known && best != NEVER) {
      body.predict(best, bestCode, bestContact);
    } else if (known < body.cleared) {
      body.clearUpTo(known);
    }
  }

  /** Considers each moving obstacle. */
  private void considerMoving(double limit) {
    for (int i = 0; i < obstacles.motions().count(); i++) {
      considerMoving(i, limit);
    }
  }

  private void considerFound(double limit) {
    for (int word = 0; word < window.found.length; word++) {
      for (long bits = window.found[word]; bits != 0; bits &= bits - 1) {
        considerMoving(word * Long.SIZE + Long.numberOfTrailingZeros(bits), limit);
      }
    }
  }

  /**
   * Prepares for searches from a time on, for a step that ends at a given time. The window lasts
   * for more such steps.
   */
  public void beginStep(double now, double end) {
    if (moving && !(now >= window.begin && end < window.end)) {
      double length = Math.max(end - now, Math.ulp(end));
      window.open(now, end + STEPS_OF_WINDOW * length);
    }
  }

  /** The same as {@link #extend}, past sensors. */
  public void extendPastSensors(MovingCircle body, Grid grid, double needed) {
    setPassesSensors(true);
    try {
      extend(body, grid, needed);
    } finally {
      setPassesSensors(false);
    }
  }

  /**
   * Finds the first impact of a circle, sensors ignored. Impacts of equal rounded times are
   * compared exactly; among exactly equal times the smallest code is first.
   *
   * @param body receives the impact: {@code next}, {@code contact} and {@code cleared}; {@code
   *     next} is NOTHING if it is later than the end by rounded times
   */
  public void cast(MovingCircle body, Grid grid, double end) {
    setOrdersExactly(true);
    try {
      do {
        extendPastSensors(body, grid, end);
      } while (body.next == MovingCircle.NOTHING && body.cleared <= end && body.cleared < NEVER);
    } finally {
      setOrdersExactly(false);
    }
  }

  /**
   * Whether the first impact found is so much later than the estimated time of the wall that the
   * walk skipped cells between. A circle that all but touches a wall and drifts towards it slowly
   * needs this.
   */
  private boolean isFar(double ahead, Grid grid) {
    return (best - ahead) * manhattanSpeed > NEAR_CELLS * grid.cell;
  }

  /**
   * Searches lines and pegs; returns the time until which the path is known, or that of the wall
   * ahead.
   */
  private double explore(MovingCircle body, Grid grid, double from, double needed, double ahead) {
    if (grid != null && grid.resolves(px, py, manhattanSpeed)) {
      for (int i = 0; i < loose.size; i++) {
        consider(loose.codes[i]);
      }
      return walk(grid, from, needed, ahead, body.useLookahead());
    }
    if (obstacles.size() == 0) {
      return ahead;
    }
    considerEach();
    settle();
    return best;
  }

  private void considerEach() {
    for (int kind = 0; kind < obstacles.kinds.size(); kind++) {
      LiveCodes present = obstacles.kinds.get(kind).present();
      for (int i = 0; i < present.size(); i++) {
        if (!moving || !obstacles.moves(present.get(i))) {
          considerOne(present.get(i));
        }
      }
    }
  }

  private void considerOne(int code) {
    if (!Codes.isLine(code)) {
      consider(code);
    } else if (near(CellList.pair(code, code)) != 0) {
      look(code);
    }
  }

  /** Computes the error bounds of the flight from its speed and size. */
  private void measure() {
    double absVx = Math.abs(vx);
    double absVy = Math.abs(vy);
    manhattanSpeed = absVx + absVy;
    perVx = 1 / fma(manhattanSpeed, DRIFT, absVx);
    perVy = 1 / fma(manhattanSpeed, DRIFT, absVy);
    double length = UnitVectors.lengthBound(absVx, absVy);
    // cross(a - p, v) errs by at most 4 u of the terms of cross(p, v), 2 u of those of cross(a, v),
    // u = 2^-53: by 4 u |v| times the size below. Sum and difference of two, by twice that and
    // their rounding, 11 u; with 2 r |v| and its sum, 14 u more: 36 u in all, 64 are left for them.
    double size = Math.abs(px) + Math.abs(py) + extent + r;
    double scale = length * size;
    boolean ordinary = manhattanSpeed > LEAST_SAFE && scale > LEAST_SAFE && scale < MOST_SAFE;
    inset = ordinary ? r + fma(0x1p-48, size, Double.MIN_NORMAL) : NEVER;
    clear = ordinary ? 2 * length * inset : NEVER;
    crossX = ordinary ? vy : 0;
    crossY = ordinary ? 0 - vx : 0;
    crossOfOrigin = ordinary ? py * vx - px * vy : 0;
    double ofAll = SegmentFilter.margin(length, size);
    margin = special || jam != null ? ofAll + NEVER : ofAll;
  }

  /** A time at or shortly before the impact with the next wall. */
  private double wallAhead() {
    if (!bounded) {
      return NEVER;
    }
    // Distances from the walls ahead, branch-free. They err by less
    // than 16 u of the size, reciprocals and products included.
    double x = halfWidth - Math.copySign(1, vx) * (px - middleX);
    double y = halfHeight - Math.copySign(1, vy) * (py - middleY);
    aheadX = (x - inset) * perVx;
    aheadY = (y - inset) * perVy;
    double t = Math.min(aheadX, aheadY);
    return t > 0 ? t : 0; // NaN if a distance is beyond the doubles
  }

  /** Considers the two walls ahead; the one that is later by estimate only if it may come first. */
  private void walls() {
    if (!bounded) {
      return;
    }
    if (aheadX < aheadY) {
      considerWall(px, vx, Codes.LEFT);
      if (!(aheadY > best)) {
        considerWall(py, vy, Codes.BOTTOM);
      }
    } else {
      considerWall(py, vy, Codes.BOTTOM);
      if (!(aheadX > best)) {
        considerWall(px, vx, Codes.LEFT);
      }
    }
  }

  /**
   * Visits the cells along the path, from the time {@code from} on. It ends when the best impact or
   * the wall ahead lies in a visited cell, when the path is known for {@code lookahead} halves of a
   * cell beyond the needed time, or where the grid ends.
   *
   * <p>Times are whole ticks. So a mask, and not an unpredictable branch, chooses between the next
   * column and the next row. A path of 2^14 cells is rounded to ticks as often: by less than 2^-15
   * cells in all.
   *
   * @return the time until which the path is known
   */
  private double walk(Grid grid, double from, double needed, double ahead, int lookahead) {
    double start = grid.contains(px, py) ? from : grid.entry(px, py, vx, vy, from);
    // The estimated time of a wall that is all but touched is 0, but another obstacle that the
    // circle touches may come before it.
    if (!(start <= ahead) || start == NEVER) {
      settle();
      return Math.min(best, ahead);
    }
    double x = grid.columns(px);
    double y = grid.rows(py);
    if (start != 0) { // else the first cell is known before v is
      x = grid.columns(fma(vx, start, px));
      y = grid.rows(fma(vy, start, py));
    }
    int column = grid.column(x);
    int row = grid.row(y);
    double ticks = manhattanSpeed * TICKS;
    double rate = ticks * grid.perCell;
    // Ticks until the next column and the next row, and ticks from each to the one after it.
    double columnTicks = ticks * perVx;
    double rowTicks = ticks * perVy;
    long nextX = (long) (Grid.toEdge(x - column, vx) * columnTicks);
    long nextY = (long) (Grid.toEdge(y - row, vy) * rowTicks);
    long perX = (long) columnTicks;
    long perY = (long) rowTicks;
    int nextRow = UnitVectors.sign(vy) * grid.stride;
    int nextColumn = UnitVectors.sign(vx) - nextRow;
    int cell = grid.number(column, row);
    long[] lists = grid.lists;
    // Two ticks beyond: one may be lost where times are cut to ticks.
    double enough = Math.max((needed - start) * rate, lookahead * (TICKS / 2)) + 2;
    double most = Math.min((ahead - start) * rate, enough);
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
        visit(grid, list, near);
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
   * Which lines of a pair may be hit: bit 0 for the first one, bit 1 for the second; -1 for other
   * lists. This has one branch only, as one for rejected lines would be unpredictable.
   *
   * @param crossX with crossY and crossOfOrigin the coefficients of the distance from the middle of
   *     the path, times a length
   * @param clear twice the distance beyond which a line is missed, times that length
   * @param spared the code of an obstacle that is not hit, or NOTHING
   */
  static int near(
      long list,
      double[] lines,
      double crossX,
      double crossY,
      double crossOfOrigin,
      double clear,
      int spared) {
    if (!CellList.isPairOfLines(list)) {
      return -1;
    }
    int first = CellList.first(list);
    int second = CellList.second(list);
    return isNear(first, lines, crossX, crossY, crossOfOrigin, clear, spared)
        | (isNear(second, lines, crossX, crossY, crossOfOrigin, clear, spared) << 1);
  }

  /**
   * The same for the flight under search. An empty list has no branch of its own, as that would be
   * unpredictable.
   */
  private int near(long list) {
    if (CellList.isPairOfLines(list)) {
      count(list);
    }
    return near(list, lines, crossX, crossY, crossOfOrigin, clear, last);
  }

  /**
   * 0 if both ends of a line lie on the same side of the path, further from it than the radius, or
   * if the line is spared; else 1. For the row of a wall the result may be either.
   */
  private static int isNear(
      int code,
      double[] lines,
      double crossX,
      double crossY,
      double crossOfOrigin,
      double clear,
      int spared) {
    // Reads of the first and the last number first spare the range checks of those between.
    int k = code * LineShape.ROW;
    double ax = lines[k + LineShape.AX];
    double by = lines[k + LineShape.BY];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double a = fma(ay, crossY, fma(ax, crossX, crossOfOrigin));
    double b = fma(by, crossY, fma(bx, crossX, crossOfOrigin));
    // min(|a|, |b|) if they have one sign, without a branch: (|a + b| - |a - b|) / 2
    double beyond = Math.abs(a + b) - (Math.abs(a - b) + clear);
    int other = code ^ spared; // 0 if the line is spared
    int isSpared = ((other - 1) & ~other) >>> 31;
    return (int) (Double.doubleToRawLongBits(beyond) >>> 63) & ~isSpared;
  }

  /** Tests the obstacles that a cell lists; in a pair of lines only those that are near. */
  private void visit(Grid grid, long list, int near) {
    if (near > 0) {
      look(list, near);
    } else if (CellList.areOthers(list)) {
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
        long lines = CellList.withoutMore(pair);
        int near = near(lines);
        if (near != 0) {
          look(lines, near);
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

  /** The codes of all obstacles that touch a circle at its place, and perhaps of others near it. */
  public int[] near(MovingCircle body, Grid grid) {
    if (grid == null) {
      return obstacles.codes().toArray();
    }
    ObstacleMotions motions = obstacles.motions();
    IntStream others =
        IntStream.concat(
            Arrays.stream(loose.codes, 0, loose.size),
            IntStream.range(0, motions.count()).map(motions::code));
    return IntStream.concat(
            obstacles.codes(Kind.WALL), IntStream.concat(others, grid.listedAt(body.x, body.y)))
        .filter(code -> Codes.isWall(code) || !obstacles.isGone(code))
        .sorted()
        .distinct()
        .toArray();
  }

  private static void count(long pair) {
    if (PrecisionCounters.COUNT != null && pair != 0) {
      PrecisionCounters.COUNT.pairTests += CellList.first(pair) == CellList.second(pair) ? 1 : 2;
    }
  }

  private void look(long pair, int near) {
    look(CellList.code(pair, ~near & 1));
    if (near == 3) {
      look(CellList.second(pair));
    }
  }
}
