// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import static dev.carom.internal.exact.Fma.fma;

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
 * <p>The path is searched piece after piece, each so short that it counts as straight: a band
 * covers the circle, and the cells are those along its middle. The lines in a cell are tested first
 * against that band, then against the narrower band of the part of the path in the cell. The {@link
 * FallNarrowPhase} tells the time of impact.
 */
public final class FallSearch {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Far more than the rounding of a radius, in units of it. */
  private static final double ROUNDING = 0x1p-40;

  /** In cells: added to the Manhattan length of a way, so that one of length 0 has ticks, too. */
  private static final double LEAST_WAY = 0x1p-20;

  /** Both lines of a pair, see {@link BroadPhase#near}. */
  private static final int BOTH = 3;

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

  /** The circle does not return to what it hit last before this time; 0 if that is not known. */
  private double returns;

  /** When the path enters the visited cell; NEVER outside of {@link #visit}. */
  private double enter;

  /** Impacts after this do not count: the end of the part searched, or the best one so far. */
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
    int cells = m.useLookahead() / HALVES;
    double known = path.isFinite() ? search(grid, m.cleared, needed, cells) : NEVER;
    if (best <= known && best != NEVER) {
      m.predict(best, bestCode, detector.contact(bestCode, best));
    } else {
      m.clearUpTo(known);
    }
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
      if (grid == null || !path.isResolved(grid, known)) {
        known = searchAll(known);
      } else if (path.isInside(grid, known)) {
        known = searchInside(grid, known, needed - known, Math.max(1, cells - visited));
      } else {
        known = searchOutside(grid, known);
      }
    }
    to = Math.min(known, best);
    considerMoving();
    considerEndOfSlide();
    return known;
  }

  /** Searches all the path from a time on. */
  private double searchAll(double from) {
    to = NEVER;
    path.takeChordAndBox(from, NEVER);
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
    path.takeChordAndBox(from, end);
    considerWalls();
    considerLoose();
    return end;
  }

  /** Searches a piece that begins inside the grid. Returns its end. */
  private double searchInside(Grid grid, double from, double wanted, int cells) {
    double duration = path.straighten(grid, from, wanted, cells);
    double end = from + duration;
    to = end;
    considerWalls();
    considerLoose();
    visited += walk(grid, from, duration, returns > end ? body.last : MovingCircle.NOTHING);
    enter = NEVER;
    return end;
  }

  /**
   * Visits the cells along the middle of a band, up to the best impact found. Times are whole
   * ticks, and a mask chooses the next cell, as in {@link BroadPhase}. Unlike there, a branch skips
   * the empty cells.
   *
   * @param spared an obstacle that is not hit in the piece, or NOTHING
   * @return the number of cells
   */
  private int walk(Grid grid, double from, double duration, int spared) {
    // Copies: a visit replaces the band by that of a part.
    double alongX = path.alongX;
    double alongY = path.alongY;
    double x = grid.columns(path.bandX);
    double y = grid.rows(path.bandY);
    int column = grid.column(x);
    int row = grid.row(y);
    double absX = Math.abs(alongX);
    double absY = Math.abs(alongY);
    double way = absX + absY + LEAST_WAY * grid.cell;
    double columnTicks = BroadPhase.TICKS * way / fma(way, BroadPhase.DRIFT, absX);
    double rowTicks = BroadPhase.TICKS * way / fma(way, BroadPhase.DRIFT, absY);
    double ticks = BroadPhase.TICKS * way * grid.perCell;
    double perTick = duration / ticks;
    // cross(p - band, along) is p.x crossX + p.y crossY + crossOfOrigin
    double crossX = alongY;
    double crossY = 0 - alongX;
    double crossOfOrigin = path.bandY * alongX - path.bandX * alongY;
    double clear = 2 * UnitVectors.lengthBound(absX, absY) * path.reach + Double.MIN_NORMAL;
    long nextX = (long) (Grid.toEdge(x - column, alongX) * columnTicks);
    long nextY = (long) (Grid.toEdge(y - row, alongY) * rowTicks);
    long perX = (long) columnTicks;
    long perY = (long) rowTicks;
    int nextRow = UnitVectors.sign(alongY) * grid.stride;
    int nextColumn = UnitVectors.sign(alongX) - nextRow;
    int cell = grid.number(column, row);
    long[] lists = grid.lists;
    double[] lines = obstacles.lines.values;
    double end = from + duration;
    long lead = nextX - nextY;
    long perBoth = perX + perY;
    long lastTick = lastTick(from, duration, ticks);
    long entered = 0;
    int cells = 1;
    while (true) {
      long list = lists[cell];
      long isColumn = lead >> 63;
      long left = nextY + (lead & isColumn);
      if (list != CellList.EMPTY) {
        if (list == CellList.OUTSIDE) {
          return cells;
        }
        int near = BroadPhase.near(list, lines, crossX, crossY, crossOfOrigin, clear, spared);
        if (near != 0) {
          visit(grid, list, near, from + entered * perTick, Math.min(end, from + left * perTick));
          lastTick = lastTick(from, duration, ticks);
        }
      }
      if (lastTick <= left) {
        return cells;
      }
      cells++;
      entered = left;
      nextY += perY & ~isColumn;
      lead += (perBoth & isColumn) - perY;
      cell += nextRow + (nextColumn & (int) isColumn);
    }
  }

  /** The last tick before the best impact so far, and two: one may be lost where ticks are cut. */
  private long lastTick(double from, double duration, double ticks) {
    double part = best < from + duration ? (best - from) / duration : 1;
    return (long) (part * ticks) + 2;
  }

  /** Considers what a cell lists, in a part of the path; of a pair of lines those that are near. */
  private void visit(Grid grid, long list, int near, double from, double end) {
    enter = from;
    to = Math.min(best, end);
    path.takeChord(from, to);
    if (near < 0) {
      considerList(grid, list);
    } else {
      considerLines(list, near);
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
      considerLines(pair, BOTH);
      return;
    }
    int first = CellList.first(pair);
    int second = CellList.second(pair);
    considerNear(first);
    if (second != first) {
      considerNear(second);
    }
  }

  /** Considers the lines of a pair that are near: bits as in {@link BroadPhase#near}. */
  private void considerLines(long pair, int near) {
    int first = CellList.first(pair);
    int second = CellList.second(pair);
    if ((near & 1) != 0) {
      considerLine(first);
    }
    if (near > 1 && second != first) {
      considerLine(second);
    }
  }

  /**
   * Considers a line that a cell lists. Without the test of the box: in a cell the chord rejects
   * nearly all lines that are out of reach.
   */
  private void considerLine(int code) {
    if (isDecided(code)) {
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
   * Considers an obstacle unless its row is out of reach of the piece. A list may still name a
   * removed one: its row is NaN, which no test rejects, and {@link #consider} leaves it out.
   */
  private void considerNear(int code) {
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
    if (!isDecided(code) && !isSkipped(code) && !obstacles.isGone(code)) {
      double middle = enter + 0.5 * (to - enter); // NaN outside of a visit: no time is expected
      offer(detector.time(code, middle, to), code);
    }
  }

  /** Whether an obstacle needs no test: it is the best so far, or cannot be hit again in time. */
  private boolean isDecided(int code) {
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
      if (enter < NEVER) { // the rest of the cell is shorter: a narrower band
        path.takeChord(enter, to);
      }
    }
  }
}
