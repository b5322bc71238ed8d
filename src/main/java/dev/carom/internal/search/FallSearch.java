// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.UnitVectors;

/**
 * Finds the next impact of a circle that falls or slides: the search of {@link BroadPhase} for
 * paths that are parabolas.
 *
 * <p>The path is searched piece after piece. Each piece is so short that it counts as straight, so
 * its cells are those along a line. The lines that a cell lists are considered if they are near
 * that line, and then if they are near the part of the path in the cell. The {@link
 * FallNarrowPhase} tells the time of impact.
 */
public final class FallSearch {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Far more than the rounding of a radius, in units of it. */
  private static final double ROUNDING = 0x1p-40;

  /** Ticks in which a path along an axis crosses a cell. */
  private static final double TICKS = 0x1p30;

  /** As in {@link BroadPhase}: each axis counts as faster by this part, so that none rests. */
  private static final double DRIFT = 0x1p-30;

  /** In cells: a piece counts as longer by this, so that it has a length. */
  private static final double LEAST_WAY = 0x1p-20;

  /** {@link MovingCircle#lookahead} counts halves of cells; a fall searches whole ones. */
  private static final int HALVES = 2;

  private final ObstacleTable obstacles;
  private final FallNarrowPhase detector;
  private final FallPath path = new FallPath();

  /** The obstacles that are in no grid. */
  private final CodeSet loose;

  private boolean passesSensors;

  // The flight under search.
  private MovingCircle body;
  private boolean filtered;
  private boolean bounded;

  /** Before this time of the flight it cannot return to what was hit last. */
  private double returns;

  /** The start of the part of the path in a cell; NEVER for questions about longer parts. */
  private double enter;

  /** The time up to which impacts are asked for: the end of that part, or the best one so far. */
  private double to;

  /** The number of cells that the search has visited. */
  private int visited;

  private double best;
  private int bestCode;
  private boolean isBestSensor;

  /** Searches among obstacles; those in the given list are in no grid. */
  public FallSearch(ObstacleTable obstacles, CodeSet loose) {
    this.obstacles = obstacles;
    this.loose = loose;
    detector = new FallNarrowPhase(obstacles);
  }

  /**
   * Searches the path of a circle further: up to its next impact, or beyond the time asked for.
   *
   * @param grid the grid of the obstacles, or null to test each of them
   * @param needed the time, from the start of the flight, up to which the path must be known
   */
  public void extend(MovingCircle m, Grid grid, double needed) {
    start(m);
    int cells = m.lookahead / HALVES;
    m.lookahead = Math.min(2 * m.lookahead, 1 << 28);
    double known = path.isInRange() ? search(grid, m.cleared, needed, cells) : NEVER;
    if (best <= known && best != NEVER) {
      m.next = bestCode;
      m.contact = detector.contact(bestCode, best);
      known = best;
    } else {
      m.next = MovingCircle.NOTHING;
      m.contact = known == m.cleared ? m.contact : 0; // a sensor met there stays reported
    }
    m.cleared = known;
  }

  /** The same, without sensors. */
  public void extendPastSensors(MovingCircle m, Grid grid, double needed) {
    passesSensors = true;
    try {
      extend(m, grid, needed);
    } finally {
      passesSensors = false;
    }
  }

  /** Whether a flight, followed for ever from its start, meets a line or a peg. */
  public boolean meets(MovingCircle m, int code) {
    start(m);
    detector.senseAgain();
    to = NEVER;
    consider(code);
    return best != NEVER;
  }

  private void start(MovingCircle m) {
    body = m;
    path.start(m);
    filtered = obstacles.areFiltered() || m.filter != Filter.DEFAULT;
    bounded = obstacles.wallsFor(m.filter) != null;
    enter = NEVER;
    best = NEVER;
    bestCode = MovingCircle.NOTHING;
    detector.start(m);
    returns = detector.earliestReturn();
  }

  // The pieces.

  /** Searches from a time on. Returns the time up to which all impacts are found. */
  private double search(Grid grid, double from, double needed, int cells) {
    double known = path.isAtRest() ? NEVER : from;
    visited = 0;
    while (known < NEVER && best > known && (visited <= cells || known <= needed)) {
      enter = NEVER;
      if (grid == null || !path.isResolved(grid, known)) {
        known = searchAll(known);
      } else if (path.isInside(grid, known)) {
        known = searchInside(grid, known, needed - known, Math.max(1, cells - visited));
      } else {
        known = searchOutside(grid, known);
      }
    }
    enter = NEVER;
    to = Math.min(known, best);
    considerMoving();
    considerEndOfSlide();
    return known;
  }

  /** Searches all the path from a time on. */
  private double searchAll(double from) {
    to = NEVER;
    path.enclose(from, NEVER);
    considerWalls();
    considerEach();
    return NEVER;
  }

  /** Searches the part of the path that is outside of the grid. Returns its end. */
  private double searchOutside(Grid grid, double from) {
    double end = path.entry(grid, from);
    if (Double.isNaN(end)) {
      return searchAll(from);
    }
    to = end;
    path.enclose(from, end);
    considerWalls();
    considerLoose();
    return end;
  }

  /** Searches a piece that begins inside the grid. Returns its end. */
  private double searchInside(Grid grid, double from, double needed, int cells) {
    double length = path.straighten(grid, from, needed, cells);
    double end = from + length;
    to = end;
    considerWalls();
    considerLoose();
    walk(grid, from, length, returns > end ? body.last : MovingCircle.NOTHING);
    return end;
  }

  /**
   * Visits the cells along the line near a piece, up to the best impact found. Times are whole
   * ticks, and a mask chooses the next cell, as in {@link BroadPhase}. Unlike there, a branch skips
   * the empty cells.
   *
   * @param passed the code of a line that is not hit in the piece
   */
  private void walk(Grid grid, double from, double length, int passed) {
    double alongX = path.alongX;
    double alongY = path.alongY;
    double x = grid.columns(path.lineX);
    double y = grid.rows(path.lineY);
    int column = grid.column(x);
    int row = grid.row(y);
    double absX = Math.abs(alongX);
    double absY = Math.abs(alongY);
    double manhattan = absX + absY;
    double way = manhattan + LEAST_WAY * grid.cell;
    double columnTicks = TICKS * way / Math.fma(way, DRIFT, absX);
    double rowTicks = TICKS * way / Math.fma(way, DRIFT, absY);
    double ticks = TICKS * way * grid.perCell;
    double perTick = length / ticks;
    // cross(p - line, along) is p.x crossX + p.y crossY + crossOfOrigin
    double crossX = alongY;
    double crossY = 0 - alongX;
    double crossOfOrigin = path.lineY * alongX - path.lineX * alongY;
    // |along| <= large + (sqrt(2) - 1) small
    double least = 0.5857 * Math.max(absX, absY) + 0.4143 * manhattan;
    double clear = 2 * least * path.reach + Double.MIN_NORMAL;
    long nextX = (long) (toEdge(x - column, alongX) * columnTicks);
    long nextY = (long) (toEdge(y - row, alongY) * rowTicks);
    long perX = (long) columnTicks;
    long perY = (long) rowTicks;
    int nextRow = UnitVectors.sign(alongY) * grid.stride;
    int nextColumn = UnitVectors.sign(alongX) - nextRow;
    int cell = grid.number(column, row);
    long[] lists = grid.lists;
    double[] lines = obstacles.lines.values;
    double end = from + length;
    long lead = nextX - nextY;
    long perBoth = perX + perY;
    long last = (long) (part(from, length) * ticks) + 2;
    long entered = 0;
    while (true) {
      long list = lists[cell];
      long isColumn = lead >> 63;
      long left = nextY + (lead & isColumn);
      visited++;
      if (list != CellList.EMPTY) {
        if (list == CellList.OUTSIDE) {
          return;
        }
        int near = near(list, lines, crossX, crossY, crossOfOrigin, clear, passed);
        if (near != 0) {
          visit(grid, list, near, from + entered * perTick, Math.min(end, from + left * perTick));
          last = (long) (part(from, length) * ticks) + 2;
        }
      }
      if (last <= left) {
        return;
      }
      entered = left;
      nextY += perY & ~isColumn;
      lead += (perBoth & isColumn) - perY;
      cell += nextRow + (nextColumn & (int) isColumn);
    }
  }

  /** The part of a piece that is before the best impact so far. */
  private double part(double from, double length) {
    return best < from + length ? (best - from) / length : 1;
  }

  /** The distance of a place in a cell of size 1 from the edge through which v leaves the cell. */
  private static double toEdge(double place, double v) {
    return Math.abs(place - 0.5 - Math.copySign(0.5, v));
  }

  /**
   * Which lines of a pair may be hit: bit 0 for the first one, bit 1 for the second; -1 for others.
   */
  private static int near(
      long list,
      double[] lines,
      double crossX,
      double crossY,
      double crossOfOrigin,
      double clear,
      int passed) {
    if (!CellList.isPairOfLines(list)) {
      return -1;
    }
    int first = CellList.first(list);
    int second = CellList.second(list);
    return isNear(first, lines, crossX, crossY, crossOfOrigin, clear, passed)
        | (isNear(second, lines, crossX, crossY, crossOfOrigin, clear, passed) << 1);
  }

  /**
   * 0 if both ends of a line lie on the same side of the path and out of its reach, or if the line
   * is passed; else 1. Branch-free.
   */
  private static int isNear(
      int code,
      double[] lines,
      double crossX,
      double crossY,
      double crossOfOrigin,
      double clear,
      int passed) {
    int k = code * LineShape.ROW;
    double ax = lines[k + LineShape.AX];
    double by = lines[k + LineShape.BY];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double a = Math.fma(ay, crossY, Math.fma(ax, crossX, crossOfOrigin));
    double b = Math.fma(by, crossY, Math.fma(bx, crossX, crossOfOrigin));
    // min(|a|, |b|) if they have one sign, without a branch: (|a + b| - |a - b|) / 2
    double beyond = Math.abs(a + b) - (Math.abs(a - b) + clear);
    int other = code ^ passed; // 0 if the line is passed
    int isPassed = ((other - 1) & ~other) >>> 31;
    return (int) (Double.doubleToRawLongBits(beyond) >>> 63) & ~isPassed;
  }

  /**
   * Considers the obstacles that a cell lists, in a part of the path; of a pair those that are
   * near.
   */
  private void visit(Grid grid, long list, int near, double from, double end) {
    enter = from;
    to = Math.min(best, end);
    path.draw(from, to);
    if (near < 0) {
      considerList(grid, list);
      return;
    }
    int first = CellList.first(list);
    int second = CellList.second(list);
    if ((near & 1) != 0) {
      considerLine(first);
    }
    if (near > 1 && second != first) {
      considerLine(second);
    }
  }

  // The candidates.

  private void considerWalls() {
    if (!bounded) {
      return;
    }
    double[] walls = obstacles.walls;
    if (path.left <= walls[Codes.LEFT]) {
      considerWall(Codes.LEFT);
    }
    if (path.right >= walls[Codes.RIGHT]) {
      considerWall(Codes.RIGHT);
    }
    if (path.bottom <= walls[Codes.BOTTOM]) {
      considerWall(Codes.BOTTOM);
    }
    if (path.top >= walls[Codes.TOP]) {
      considerWall(Codes.TOP);
    }
  }

  private void considerWall(int code) {
    if (!isSkipped(code)) {
      offer(detector.wallTime(code, to), code);
    }
  }

  private void considerEach() {
    for (int kind = 0; kind < obstacles.kinds.size(); kind++) {
      LiveCodes present = obstacles.kinds.get(kind).present();
      for (int i = 0; i < present.size(); i++) {
        if (!obstacles.moves(present.get(i))) {
          considerNear(present.get(i));
        }
      }
    }
  }

  private void considerLoose() {
    for (int i = 0; i < loose.size; i++) {
      considerNear(loose.codes[i]);
    }
  }

  /** Considers a list that is no pair of lines. */
  private void considerList(Grid grid, long list) {
    if (CellList.areOthers(list)) {
      considerPair(list);
      return;
    }
    int k = CellList.start(list);
    do {
      considerPair(grid.pairs[k]);
    } while (CellList.isMore(grid.pairs[k++]));
  }

  private void considerPair(long pair) {
    if (!CellList.areOthers(pair)) {
      considerLines(pair);
      return;
    }
    int first = CellList.first(pair);
    int second = CellList.second(pair);
    considerNear(first);
    if (second != first) {
      considerNear(second);
    }
  }

  private void considerLines(long pair) {
    int first = CellList.first(pair);
    int second = CellList.second(pair);
    considerLine(first);
    if (second != first) {
      considerLine(second);
    }
  }

  /**
   * Considers a line that a cell lists, as {@link #considerNear} does: there, the chord alone tells
   * nearly all lines that are out of reach of the path in the cell.
   */
  private void considerLine(int code) {
    if (isPassed(code)) {
      return;
    }
    int k = obstacles.lines.offset(code);
    double[] v = obstacles.lines.values;
    double ax = v[k + LineShape.AX];
    double ay = v[k + LineShape.AY];
    double bx = v[k + LineShape.BX];
    double by = v[k + LineShape.BY];
    if (!path.isBeside(ax, ay, bx, by, 0)) {
      consider(code);
    }
  }

  /**
   * Considers an obstacle at rest unless it is out of reach of the piece. A list may also name one
   * that was moved or removed: the row of that has NaN, for which no test of its reach is true.
   */
  private void considerNear(int code) {
    if (Codes.isWall(code)) {
      return;
    }
    ObstacleRows rows = obstacles.of(code);
    int k = rows.offset(code);
    int end = k + rows.shape.toEnd;
    double[] v = rows.values;
    double radius = rows.shape.radius(v, k) * (1 + ROUNDING);
    double ax = v[k + ObstacleShape.X];
    double ay = v[k + ObstacleShape.Y];
    double bx = v[end + ObstacleShape.X];
    double by = v[end + ObstacleShape.Y];
    if (!path.isBesideBox(ax, ay, bx, by, radius) && !path.isBeside(ax, ay, bx, by, radius)) {
      consider(code);
    }
  }

  private void considerMoving() {
    ObstacleMotions motions = obstacles.motions();
    for (int i = 0; i < motions.count(); i++) {
      consider(motions.code(i));
    }
  }

  /** Considers an obstacle other than a wall. */
  private void consider(int code) {
    if (!isPassed(code) && !isSkipped(code) && !obstacles.isGone(code)) {
      double middle = enter + 0.5 * (to - enter);
      offer(detector.time(code, middle, to), code);
    }
  }

  /** Whether an obstacle is not to be asked again, or not yet. */
  private boolean isPassed(int code) {
    return code == bestCode || (code == body.last && returns > to);
  }

  private boolean isSkipped(int code) {
    return code == body.support
        || (filtered && !Filter.meet(body.filter, obstacles.filter(code)))
        || (body.jam != null && (body.jam.makesInert(code) || body.jam.isCrushedBy(code)))
        || (passesSensors && obstacles.isSensor(code));
  }

  /** Considers the end of a slide, which comes after all impacts at the same time. */
  private void considerEndOfSlide() {
    double t = detector.endOfSlide();
    if (t <= to && t < best) {
      best = t;
      bestCode = body.support;
    }
  }

  /** Takes an impact if it is in the piece, and before the best one so far. */
  private void offer(double t, int code) {
    if (!(t <= to) || t == NEVER) {
      return;
    }
    boolean sensor = obstacles.isSensor(code);
    boolean isFirst = t < best;
    if (t == best) { // sensors first, since they change nothing
      isFirst = sensor == isBestSensor ? code < bestCode : sensor;
    }
    if (isFirst) {
      best = t;
      to = t;
      bestCode = code;
      isBestSensor = sensor;
      if (enter < NEVER) {
        path.draw(enter, to);
      }
    }
  }
}
