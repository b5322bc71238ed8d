// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.UnitVectors;

/**
 * Finds the next impact of a circle that falls or slides, on a path that is a parabola.
 *
 * <p>The path is searched piece after piece, each so short that it counts as straight: a band
 * covers the circle, and the cells are those along its middle. The lines in a cell are tested first
 * against that band, then against the narrower band of the part of the path in the cell. {@link
 * FallTimes} tells the time of impact.
 */
final class FallSearch extends CellWalk {

  /** Far more than the rounding of a radius, in units of it. */
  private static final double ROUNDING = 0x1p-40;

  /** In cells: added to the Manhattan length of a piece, so that one of length 0 has ticks, too. */
  private static final double LEAST_LENGTH = 0x1p-20;

  /** {@link MovingCircle#lookahead} counts halves of cells; a fall searches whole ones. */
  private static final int HALVES = 2;

  /** The circle does not return to what it hit last before this time; 0 if that is not known. */
  private double returns;

  // The straight piece under search: its start and end, and the duration of a tick.
  private double pieceStart;
  private double pieceEnd;
  private double perTick;

  /** When the path enters the visited cell; NEVER outside of the walk. */
  private double enter;

  /** The number of cells that the search has walked along. */
  private double visited;

  /** Impacts after this do not count: the end of the part searched, or the best one so far. */
  private double to;

  FallSearch(ObstacleTable obstacles, CodeSet loose) {
    super(obstacles, loose);
  }

  @Override
  void start(MovingCircle m) {
    super.start(m);
    fall.flight(px, py, r, vx, vy, m.gx, m.gy);
    unhittable = m.support;
    path.start(m);
    returns = earliestReturn();
    enter = NEVER;
    to = NEVER;
  }

  @Override
  void forgetHits() {
    sensed = -1;
  }

  // The pieces.

  @Override
  double search(Grid grid, double needed) {
    int cells = body.useLookahead() / HALVES;
    visited = 0;
    double known = path.isAtRest() ? NEVER : body.cleared;
    take(endOfSlide(), body.support, 0);
    while (known < NEVER && best > known && (visited <= cells || known <= needed)) {
      if (grid == null || !path.isResolved(grid, known)) {
        known = searchAll(known);
      } else if (path.isInside(grid, known)) {
        known = searchInside(grid, known, needed - known, Math.max(1, cells - visited));
      } else {
        known = searchOutside(grid, known);
      }
    }
    return known;
  }

  /** Searches all the path from a time on. */
  private double searchAll(double from) {
    takePiece(from, NEVER);
    considerEach();
    return NEVER;
  }

  /** Searches the part of the path that is outside of the grid. Returns its end. */
  private double searchOutside(Grid grid, double from) {
    double end = path.entry(grid, from);
    if (Double.isNaN(end)) {
      return searchAll(from);
    }
    takePiece(from, end);
    considerLoose();
    return end;
  }

  private void takePiece(double from, double end) {
    to = Math.min(best, end);
    path.takeChordAndBox(from, end);
    crossX = 0; // the chord may be endless, so the walk's filter rejects nothing
    crossY = 0;
    crossOfOrigin = 0;
    clear = NEVER;
    considerWalls();
  }

  /** Searches a piece that begins inside the grid. Returns its end. */
  private double searchInside(Grid grid, double from, double wanted, double cells) {
    double duration = path.straighten(grid, from, wanted, cells);
    double end = from + duration;
    to = Math.min(best, end);
    considerWalls();
    considerLoose();
    spared = returns > end ? body.last : MovingCircle.NOTHING;
    double known = walkAlong(grid, from, duration);
    enter = NEVER;
    return known;
  }

  /** Walks along the middle of the band of a piece. */
  private double walkAlong(Grid grid, double from, double duration) {
    double absX = Math.abs(path.alongX);
    double absY = Math.abs(path.alongY);
    // cross(p - band, along) is p.x crossX + p.y crossY + crossOfOrigin
    crossX = path.alongY;
    crossY = 0 - path.alongX;
    crossOfOrigin = path.bandY * path.alongX - path.bandX * path.alongY;
    clear = 2 * UnitVectors.lengthBound(absX, absY) * path.reach + Double.MIN_NORMAL;
    double length = absX + absY + LEAST_LENGTH * grid.cell;
    head(path.alongX, path.alongY, length);
    double ticks = ticks(grid);
    pieceStart = from;
    pieceEnd = from + duration;
    perTick = duration / ticks;
    visited += length * grid.perCell;
    double x = grid.columns(path.bandX);
    double y = grid.rows(path.bandY);
    return walk(grid, x, y, from, ticks / duration, NEVER, pieceEnd);
  }

  @Override
  void enter(long entered, long left) {
    enter = pieceStart + Math.max(0, entered) * perTick;
    to = Math.min(best, Math.min(pieceEnd, pieceStart + left * perTick));
    path.takeChord(enter, to);
  }

  // Moving obstacles.

  @Override
  void considerMotion(int i, double end) {
    to = Math.min(best, end);
    chooseMoving(i);
    ask(obstacles.motions().code(i));
  }

  // Obstacles at rest.

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
    if (!ignores(code) && !passesAsMember(code)) {
      offer(wallTime(code, asked(to)), code);
    }
  }

  /** Considers a line in the visited cell, whose box overlaps that of the circle nearly always. */
  @Override
  void look(int line) {
    if (isDecided(line)) {
      return;
    }
    int k = line * LineShape.ROW;
    double ax = lines[k + LineShape.AX];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double by = lines[k + LineShape.BY];
    if (!path.isBeside(ax, ay, bx, by, 0)) {
      considerOnly(line);
    }
  }

  /** Considers an obstacle unless it is out of reach of the piece. */
  @Override
  void consider(int code) {
    ObstacleRows rows = obstacles.of(code);
    int k = rows.offset(code);
    int end = k + rows.shape.toEnd;
    double[] v = rows.values;
    double radius = rows.shape.radius(v, k) * (1 + ROUNDING);
    double ax = v[k + ObstacleShape.X];
    double ay = v[k + ObstacleShape.Y];
    double bx = v[end + ObstacleShape.X];
    double by = v[end + ObstacleShape.Y];
    if (!isDecided(code)
        && !path.isBesideBox(ax, ay, bx, by, radius)
        && !path.isBeside(ax, ay, bx, by, radius)) {
      considerOnly(code);
    }
  }

  @Override
  void considerOnly(int code) {
    choose(code);
    ask(code);
  }

  /** Whether an obstacle needs no test: it is the best so far, or cannot be hit again in time. */
  private boolean isDecided(int code) {
    return code == bestCode || (code == body.last && returns > to);
  }

  /** Asks for the time of impact with an obstacle that was chosen. */
  private void ask(int code) {
    if (!isGone() && !ignores(code) && !passesAsMember(code)) {
      double middle = enter + 0.5 * (to - enter); // NaN outside of the walk: no time is expected
      offer(time(code, middle, asked(to)), code);
    }
  }

  /**
   * Whether contact keeps a member from an obstacle, which is no sensor: one at rest only from
   * those that move as it does.
   */
  private boolean passesAsMember(int code) {
    return body.isMember()
        && !obstacles.isSensor(code)
        && (body.mode != MovingCircle.FROZEN
            || (!obstacles.turns(code)
                && obstacles.ux(code) == body.vx
                && obstacles.uy(code) == body.vy));
  }

  /** Takes an impact in the part searched; the rest of that is shorter, with a narrower band. */
  private void offer(double t, int code) {
    if (t <= to && take(t, code, 0)) {
      to = t;
      if (enter < NEVER) {
        path.takeChord(enter, to);
      }
    }
  }

  @Override
  int contact() {
    return contact(bestCode, best);
  }
}
