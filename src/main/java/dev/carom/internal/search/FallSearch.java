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

/**
 * Finds the next impact of a circle that falls or slides: the search of {@link BroadPhase} for
 * paths that are parabolas.
 *
 * <p>The path is searched piece after piece, each in one cell of the grid. The obstacles that the
 * cell lists, and the walls, are considered if they are near the piece. The {@link FallNarrowPhase}
 * then tells the time of impact.
 */
public final class FallSearch {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** In units of the terms of a place: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** If the square of a reach, which covers rounding, is below this, no product overflows. */
  private static final double LARGEST_SQUARE = 0x1p200;

  /** {@link MovingCircle#lookahead} counts halves of cells; a fall searches whole ones. */
  private static final int HALVES = 2;

  private final ObstacleTable obstacles;
  private final FallNarrowPhase detector;
  private final ParabolaWalk walk = new ParabolaWalk();

  /** The obstacles that are in no grid. */
  private final CodeSet loose;

  private boolean passesSensors;

  // The flight under search.
  private MovingCircle body;
  private double px;
  private double py;
  private double vx;
  private double vy;
  private double gx;
  private double gy;
  private double r;

  // What bounds a coordinate: size + speed t + pull t^2.
  private double size;
  private double speed;
  private double pull;

  private boolean filtered;
  private boolean bounded;

  /** Before this time of the flight it cannot return to what was hit last. */
  private double returns;

  /** The start of the piece; NEVER for questions about all pieces together. */
  private double pieceStart;

  /** The end of the piece, or the first impact in it. */
  private double to;

  // The chord of the piece: its start, the way along it, and how far the circle reaches from it.
  private double chordX;
  private double chordY;
  private double alongX;
  private double alongY;
  private double chordReach;
  private double endX;
  private double endY;

  // The box around the centre's path in the piece.
  private double left;
  private double right;
  private double bottom;
  private double top;

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
    double known = m.cleared;
    if (!isInRange() || (isAtRest() && !obstacles.areMoving())) {
      known = NEVER;
    }
    int cells = m.lookahead / HALVES;
    m.lookahead = Math.min(2 * m.lookahead, 1 << 28);
    if (known < NEVER) {
      known = search(grid, known, needed, cells);
    }
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
    px = m.x;
    py = m.y;
    vx = m.vx;
    vy = m.vy;
    gx = m.gx;
    gy = m.gy;
    r = m.radius;
    size = Math.abs(px) + Math.abs(py) + 2 * r;
    speed = Math.abs(vx) + Math.abs(vy);
    pull = Math.abs(gx) + Math.abs(gy);
    filtered = obstacles.areFiltered() || m.filter != Filter.DEFAULT;
    bounded = obstacles.wallsFor(m.filter) != null;
    pieceStart = NEVER;
    best = NEVER;
    bestCode = MovingCircle.NOTHING;
    detector.start(m);
    returns = detector.earliestReturn();
  }

  private boolean isInRange() {
    return Math.abs(px) <= Double.MAX_VALUE && Math.abs(py) <= Double.MAX_VALUE;
  }

  private boolean isAtRest() {
    return vx == 0 && vy == 0 && gx == 0 && gy == 0;
  }

  // The pieces.

  /** Searches from a time on. Returns the time up to which all impacts are found. */
  private double search(Grid grid, double from, double needed, int cells) {
    boolean isFollowed = grid != null && walk.start(grid, px, py, vx, vy, gx, gy, from);
    if (isFollowed) {
      walk.keepOff(grid, bounded ? obstacles.walls : null, r);
    }
    double known = from;
    for (int piece = 0; known < NEVER && best > known; piece++) {
      if (piece > cells && known > needed) {
        break;
      }
      double end = isFollowed ? walk.to : NEVER;
      pieceStart = known;
      to = Math.min(end, best);
      if (isFollowed) {
        considerCell(grid, known, end);
        isFollowed = best > end && walk.advance();
      } else {
        enclose(known, end);
        considerWalls();
        considerEach();
      }
      known = end;
    }
    pieceStart = NEVER;
    to = Math.min(known, best);
    considerMoving();
    considerEndOfSlide();
    return known;
  }

  /**
   * Considers what can be hit in a piece that stays in a cell. Most cells are empty or list two
   * lines, and are out of reach of the walls: for the first there is nothing to do, and for the
   * second no box is needed.
   */
  private void considerCell(Grid grid, double from, double end) {
    long list = walk.list();
    if (!walk.isFree() || loose.size > 0 || !CellList.isPairOfLines(list)) {
      enclose(from, end);
      considerWalls();
      considerList(grid, list);
      considerLoose();
    } else if (list != CellList.EMPTY) {
      draw(from, end);
      considerLines(list);
    }
  }

  /** Computes the chord of a piece. */
  private void draw(double from, double end) {
    chordX = place(px, vx, gx, from);
    chordY = place(py, vy, gy, from);
    endX = place(px, vx, gx, end);
    endY = place(py, vy, gy, end);
    alongX = endX - chordX;
    alongY = endY - chordY;
    double length = end - from;
    double bend = pull * (length * length) / 8;
    chordReach = (r + bend) * (1 + ROUNDING) + 4 * ROUNDING * (size + (speed + pull * end) * end);
  }

  /** Computes the chord and the box of a piece. */
  private void enclose(double from, double end) {
    draw(from, end);
    double turnsX = -vx / gx;
    double turnsY = -vy / gy;
    double marginX = margin(px, vx, gx, end < NEVER ? end : lastTurn(turnsX, from));
    double marginY = margin(py, vy, gy, end < NEVER ? end : lastTurn(turnsY, from));
    left = Math.min(chordX, endX) - marginX;
    right = Math.max(chordX, endX) + marginX;
    bottom = Math.min(chordY, endY) - marginY;
    top = Math.max(chordY, endY) + marginY;
    if (gx != 0 && turnsX == NEVER) { // it turns beyond the range of doubles
      left = -NEVER;
      right = NEVER;
    }
    if (gy != 0 && turnsY == NEVER) {
      bottom = -NEVER;
      top = NEVER;
    }
    if (turnsX > from && turnsX < end) {
      double x = place(px, vx, gx, turnsX);
      left = Math.min(left, x - marginX);
      right = Math.max(right, x + marginX);
    }
    if (turnsY > from && turnsY < end) {
      double y = place(py, vy, gy, turnsY);
      bottom = Math.min(bottom, y - marginY);
      top = Math.max(top, y + marginY);
    }
  }

  /** The last finite time at which an endless piece has a place: where it turns, or begins. */
  private static double lastTurn(double turn, double from) {
    return turn > from && turn < NEVER ? turn : from;
  }

  private double margin(double p, double v, double g, double t) {
    return ROUNDING * (Math.abs(p) + r + (Math.abs(v) + Math.abs(g) * t) * t);
  }

  /** The place on one axis, also after an infinite time. */
  private static double place(double p, double v, double g, double t) {
    if (t == NEVER) {
      double way = g != 0 ? g : v;
      return way == 0 ? p : way * NEVER;
    }
    return p + (v + 0.5 * g * t) * t;
  }

  // The candidates.

  private void considerWalls() {
    if (!bounded) {
      return;
    }
    double[] walls = obstacles.walls;
    if (left - r <= walls[Codes.LEFT]) {
      considerWall(Codes.LEFT);
    }
    if (right + r >= walls[Codes.RIGHT]) {
      considerWall(Codes.RIGHT);
    }
    if (bottom - r <= walls[Codes.BOTTOM]) {
      considerWall(Codes.BOTTOM);
    }
    if (top + r >= walls[Codes.TOP]) {
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

  private void considerList(Grid grid, long list) {
    if (list == CellList.EMPTY || list == CellList.OUTSIDE) {
      return;
    }
    if (CellList.isPairOfLines(list) || CellList.areOthers(list)) {
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
   * nearly all lines that are out of reach.
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
    if (!isBesideChord(ax, ay, bx, by, 0)) {
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
    if (!isBesideBox(ax, ay, bx, by, radius) && !isBesideChord(ax, ay, bx, by, radius)) {
      consider(code);
    }
  }

  private boolean isBesideBox(double ax, double ay, double bx, double by, double radius) {
    double reach = r * (1 + ROUNDING) + radius;
    return Math.min(ax, bx) - right > reach
        || left - Math.max(ax, bx) > reach
        || Math.min(ay, by) - top > reach
        || bottom - Math.max(ay, by) > reach;
  }

  /**
   * Whether an obstacle from a to b is certainly out of reach of the path: both its ends lie on one
   * side of the chord, or both ends of the chord on one side of it. The path bends from the chord
   * by {@code g t^2 / 8} at most.
   */
  private boolean isBesideChord(double ax, double ay, double bx, double by, double radius) {
    double places = Math.abs(ax) + Math.abs(ay) + Math.abs(bx) + Math.abs(by);
    double reach = chordReach + radius + ROUNDING * places;
    double square = reach * reach;
    if (!(square > Double.MIN_NORMAL && square < LARGEST_SQUARE)) {
      return false; // so small or large that squares do not tell
    }
    double dx = ax - chordX;
    double dy = ay - chordY;
    double a = alongX * dy - alongY * dx;
    double b = alongX * (by - chordY) - alongY * (bx - chordX);
    double wx = bx - ax;
    double wy = by - ay;
    double first = wy * dx - wx * dy;
    double last = first + (wx * alongY - wy * alongX);
    double besidePath = beyond(a, b, square * lengthSquare(alongX, alongY));
    double besideLine = beyond(first, last, square * lengthSquare(wx, wy));
    // One branch for both, as each alone would be unpredictable.
    return (Double.doubleToRawLongBits(besidePath) | Double.doubleToRawLongBits(besideLine)) < 0;
  }

  /** Not less than the square of a length; the least normal number covers underflow. */
  private static double lengthSquare(double x, double y) {
    return x * x + y * y + Double.MIN_NORMAL;
  }

  /**
   * Negative if two numbers have one sign, and both their squares are above a limit; branch-free.
   * Its rounding, 4 ulps of the larger number, is far below the {@link #ROUNDING} in the reach.
   */
  private static double beyond(double a, double b, double limit) {
    double twice = Math.abs(a + b) - Math.abs(a - b); // the lesser size, below 0 for two signs
    return 4 * limit + Double.MIN_NORMAL - twice * Math.abs(twice);
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
      double middle = pieceStart + 0.5 * (to - pieceStart);
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
      if (pieceStart < NEVER) {
        draw(pieceStart, to);
      }
    }
  }
}
