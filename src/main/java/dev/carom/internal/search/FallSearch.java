// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.state.CodeSet;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.ParabolaDiskSweep;
import dev.carom.internal.sweep.ParabolaReturn;
import dev.carom.internal.sweep.ParabolaSegmentSweep;
import dev.carom.internal.sweep.ParabolaWallSweep;
import dev.carom.internal.sweep.PegShape;

/**
 * Finds the next impact of a circle that falls or slides: the search of {@link BroadPhase} for
 * paths that are parabolas.
 *
 * <p>The path is searched window after window. The box around the path in a window tells the cells
 * of the grid and the walls that it can meet there. The detector is asked for the whole flight up
 * to the end of the window, so the answer does not depend on how the path was cut.
 */
public final class FallSearch {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** In units of the terms of a place: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** A window is at most so many cells long. */
  private static final double CELLS = 1;

  /** The halves of a cell of {@link MovingCircle#lookahead} for which a window is opened. */
  private static final int HALVES = 4;

  /** Far more than the rounding of a time of return. */
  private static final double EARLIER = 1 - 0x1p-20;

  /**
   * A circle that overlaps a one-way line by no more than this part of its coordinates touches it.
   */
  private static final double TOUCH = 0x1p-49;

  private final ObstacleTable obstacles;

  /** The obstacles that are in no grid. */
  private final CodeSet loose;

  private boolean passesSensors;

  // The flight under search.
  private double px;
  private double py;
  private double vx;
  private double vy;
  private double gx;
  private double gy;
  private double r;
  private MovingCircle body;
  private boolean filtered;
  private boolean bounded;

  /** Sensor contacts before this time were reported, and at it those with a code up to this. */
  private double sensed;

  private int sensedCode;

  /** The end of the window, and the box of the centre's path from its start on. */
  private double to;

  /** The chord of the path in the window, its length, and how far a centre near it may reach. */
  private double chordX;

  private double chordY;
  private double alongX;
  private double alongY;
  private double chord;
  private double chordReach;

  private double left;
  private double right;
  private double bottom;
  private double top;

  private double best;
  private int bestCode;
  private boolean isBestSensor;

  /** Before this time of the flight it cannot return to what was hit last. */
  private double returns;

  /** The obstacles that were considered last. */
  private int considered;

  private int consideredBefore;

  /** Where a moving obstacle was at the start of the flight. */
  private final double[] placed = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** Searches among obstacles; those in the given list are in no grid. */
  public FallSearch(ObstacleTable obstacles, CodeSet loose) {
    this.obstacles = obstacles;
    this.loose = loose;
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
    int windows = m.lookahead / HALVES;
    m.lookahead = Math.min(2 * m.lookahead, 1 << 28);
    while (known < NEVER && best == NEVER && (known <= needed || windows > 0)) {
      windows--;
      openWindow(grid, known);
      considerAll(grid);
      known = Math.min(best, to);
    }
    if (best != NEVER) {
      m.next = bestCode;
      m.contact = contact(bestCode, best);
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
    sensed = -1;
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
    filtered = obstacles.areFiltered() || m.filter != Filter.DEFAULT;
    bounded = obstacles.wallsFor(m.filter) != null;
    sensed = m.cleared;
    sensedCode = m.contact;
    best = NEVER;
    bestCode = MovingCircle.NOTHING;
    considered = MovingCircle.NOTHING;
    consideredBefore = MovingCircle.NOTHING;
    returns = m.last < 0 || Codes.isCircle(m.last) ? 0 : earliestReturn(m.last);
  }

  /**
   * A time before which a circle cannot return to what it has just hit. That is convex, so it lies
   * behind the tangent at the contact, to which the circle does not return before {@code 2 v.n /
   * -g.n}. That holds unless it overlaps a line deeply, in which it may turn round.
   */
  private double earliestReturn(int code) {
    if (Codes.isWall(code)) {
      return 0; // its return is computed as fast
    }
    ObstacleRows rows = obstacles.of(code);
    if (obstacles.moves(code) || rows.isGone(code)) {
      return 0;
    }
    int k = rows.offset(code);
    int end = k + rows.shape.toEnd;
    double[] v = rows.values;
    double ax = v[k + ObstacleShape.X];
    double ay = v[k + ObstacleShape.Y];
    double wx = v[end + ObstacleShape.X] - ax;
    double wy = v[end + ObstacleShape.Y] - ay;
    double ww = wx * wx + wy * wy;
    double s = ww > 0 ? ((px - ax) * wx + (py - ay) * wy) / ww : 0;
    s = Math.max(0, Math.min(1, s));
    double nx = px - (ax + s * wx);
    double ny = py - (ay + s * wy);
    double away = vx * nx + vy * ny;
    double lift = gx * nx + gy * ny;
    double reach = EARLIER * (r + rows.shape.radius(v, k));
    if (!(nx * nx + ny * ny > reach * reach)) {
      return 0; // it overlaps that, and may come deeper
    }
    if (!(away > ROUNDING * (Math.abs(vx * nx) + Math.abs(vy * ny)))) {
      return 0;
    }
    double pull = ROUNDING * (Math.abs(gx * nx) + Math.abs(gy * ny)) - lift;
    return pull > 0 ? EARLIER * (2 * away / pull) : NEVER;
  }

  private boolean isInRange() {
    return Math.abs(px) <= Double.MAX_VALUE && Math.abs(py) <= Double.MAX_VALUE;
  }

  private boolean isAtRest() {
    return vx == 0 && vy == 0 && gx == 0 && gy == 0;
  }

  // The window.

  /** Opens the window that begins at a time, and computes the box of the path in it. */
  private void openWindow(Grid grid, double from) {
    considered = MovingCircle.NOTHING;
    consideredBefore = MovingCircle.NOTHING;
    if (grid == null) {
      to = NEVER;
      box(from, NEVER);
      return;
    }
    double length = duration(CELLS * grid.cell, from);
    while (true) {
      to = from + length > from ? from + length : NEVER;
      box(from, to);
      if (to == NEVER || grid.meets(left, bottom, right, top)) {
        return;
      }
      length *= 2;
    }
  }

  /** How long the centre takes for a way that is at most so long, from a time on. */
  private double duration(double way, double from) {
    double speed = Math.abs(vx + gx * from) + Math.abs(vy + gy * from);
    double g = Math.abs(gx) + Math.abs(gy);
    return 2 * way / (speed + Math.sqrt(speed * speed + 2 * g * way));
  }

  private void box(double from, double end) {
    double x0 = place(px, vx, gx, from);
    double x1 = place(px, vx, gx, end);
    double y0 = place(py, vy, gy, from);
    double y1 = place(py, vy, gy, end);
    double ofX = top(px, vx, gx, from, end, x0);
    double ofY = top(py, vy, gy, from, end, y0);
    double marginX = margin(px, vx, gx, end);
    double marginY = margin(py, vy, gy, end);
    chordX = x0;
    chordY = y0;
    alongX = x1 - x0;
    alongY = y1 - y0;
    chord = Math.sqrt(alongX * alongX + alongY * alongY);
    double length = end - from;
    double bend = (Math.abs(gx) + Math.abs(gy)) * (length * length) / 8;
    chordReach = (r + bend) * (1 + ROUNDING) + 4 * (marginX + marginY);
    left = Math.min(Math.min(x0, x1), ofX) - marginX;
    right = Math.max(Math.max(x0, x1), ofX) + marginX;
    bottom = Math.min(Math.min(y0, y1), ofY) - marginY;
    top = Math.max(Math.max(y0, y1), ofY) + marginY;
  }

  private static double margin(double p, double v, double g, double t) {
    double reach = t == NEVER ? 0 : (Math.abs(v) + Math.abs(g) * t) * t;
    return ROUNDING * (Math.abs(p) + reach);
  }

  /** Where the path turns back on an axis between two times; the given place if it does not. */
  private static double top(double p, double v, double g, double from, double end, double place) {
    double t = -v / g;
    return t > from && t < end ? place(p, v, g, t) : place;
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

  private void considerAll(Grid grid) {
    considerWalls();
    if (grid == null) {
      considerEach();
    } else {
      considerCells(grid);
      for (int i = 0; i < loose.size; i++) {
        considerNear(loose.codes[i]);
      }
    }
    for (int i = 0; i < obstacles.motions().count(); i++) {
      consider(obstacles.motions().code(i));
    }
    considerEndOfSlide();
  }

  private void considerEach() {
    for (int kind = 0; kind < obstacles.kinds.size(); kind++) {
      LiveCodes present = obstacles.kinds.get(kind).present();
      for (int i = 0; i < present.size(); i++) {
        if (!obstacles.moves(present.get(i))) {
          consider(present.get(i));
        }
      }
    }
  }

  private void considerCells(Grid grid) {
    if (!grid.meets(left, bottom, right, top)) {
      return;
    }
    int firstColumn = grid.column(grid.columns(left));
    int lastColumn = grid.column(grid.columns(right));
    int lastRow = grid.row(grid.rows(top));
    for (int row = grid.row(grid.rows(bottom)); row <= lastRow; row++) {
      for (int column = firstColumn; column <= lastColumn; column++) {
        considerList(grid, grid.lists[grid.number(column, row)]);
      }
    }
  }

  private void considerList(Grid grid, long list) {
    if (list == CellList.EMPTY) {
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
    int first = CellList.first(pair);
    int second = CellList.second(pair);
    considerNear(first);
    if (second != first) {
      considerNear(second);
    }
  }

  /** Considers an obstacle at rest unless its box is out of reach of the path. */
  private void considerNear(int code) {
    if (Codes.isWall(code) || code == considered || code == consideredBefore) {
      return;
    }
    consideredBefore = considered;
    considered = code;
    ObstacleRows rows = obstacles.of(code);
    int k = rows.offset(code);
    int end = k + rows.shape.toEnd;
    double[] v = rows.values;
    double reach = (r + rows.shape.radius(v, k)) * (1 + ROUNDING);
    double ax = v[k + ObstacleShape.X];
    double ay = v[k + ObstacleShape.Y];
    double bx = v[end + ObstacleShape.X];
    double by = v[end + ObstacleShape.Y];
    boolean isOut =
        Math.min(ax, bx) - right > reach
            || left - Math.max(ax, bx) > reach
            || Math.min(ay, by) - top > reach
            || bottom - Math.max(ay, by) > reach;
    if (!isOut && !isBesideChord(ax, ay, bx, by, reach - r)) {
      consider(code);
    }
  }

  /**
   * Whether an obstacle from a to b is certainly out of reach of the path: both its ends lie on one
   * side of the chord, or both ends of the chord on one side of it. The path bends from the chord
   * by {@code g t^2 / 8} at most.
   */
  private boolean isBesideChord(double ax, double ay, double bx, double by, double radius) {
    double reach = chordReach + radius;
    double dx = ax - chordX;
    double dy = ay - chordY;
    double a = alongX * dy - alongY * dx;
    double b = alongX * (by - chordY) - alongY * (bx - chordX);
    if (a * b > 0 && Math.min(Math.abs(a), Math.abs(b)) > reach * chord) {
      return true;
    }
    double wx = bx - ax;
    double wy = by - ay;
    double first = wy * dx - wx * dy;
    double last = first + (wx * alongY - wy * alongX);
    return first * last > 0
        && Math.min(Math.abs(first), Math.abs(last)) > reach * Math.sqrt(wx * wx + wy * wy);
  }

  /** Considers an obstacle other than a wall. */
  private void consider(int code) {
    if (code == bestCode || skipped(code) || (code == body.last && returns > to)) {
      return;
    }
    ObstacleRows rows = obstacles.of(code);
    int k = rows.offset(code);
    if (Double.isNaN(rows.values[k])) {
      return; // removed
    }
    double t = time(code);
    if (t <= to) {
      offer(t, code);
    }
  }

  private boolean skipped(int code) {
    return code == body.support
        || (filtered && !Filter.meet(body.filter, obstacles.filter(code)))
        || (body.jam != null && (body.jam.makesInert(code) || body.jam.isCrushedBy(code)))
        || (passesSensors && obstacles.isSensor(code));
  }

  private void offer(double t, int code) {
    boolean sensor = obstacles.isSensor(code);
    boolean isFirst = t < best;
    if (t == best && best != NEVER) { // sensors first, since they change nothing
      isFirst = sensor == isBestSensor ? code < bestCode : sensor;
    }
    if (isFirst) {
      best = t;
      to = Math.min(to, t);
      bestCode = code;
      isBestSensor = sensor;
    }
  }

  // Walls.

  private void considerWalls() {
    if (!bounded) {
      return;
    }
    double[] walls = obstacles.walls;
    if (left - r <= walls[Codes.LEFT]) {
      considerWall(Codes.LEFT, px, vx, gx);
    }
    if (right + r >= walls[Codes.RIGHT]) {
      considerWall(Codes.RIGHT, px, vx, gx);
    }
    if (bottom - r <= walls[Codes.BOTTOM]) {
      considerWall(Codes.BOTTOM, py, vy, gy);
    }
    if (top + r >= walls[Codes.TOP]) {
      considerWall(Codes.TOP, py, vy, gy);
    }
  }

  private void considerWall(int code, double p, double v, double g) {
    if (skipped(code)) {
      return;
    }
    int inward = Codes.inwards(code);
    double t =
        code == body.last
            ? ParabolaReturn.toWall(v, g, inward, to)
            : ParabolaWallSweep.time(p, r, v, g, obstacles.walls[code], inward, to);
    if (t <= to) {
      offer(t, code);
    }
  }

  // Lines and pegs.

  /** The time of the next contact with an obstacle that counts, in the window. */
  private double time(int code) {
    double[] row = row(code);
    int k = row == placed ? 0 : obstacles.of(code).offset(code);
    double ux = obstacles.ux(code);
    double uy = obstacles.uy(code);
    if (obstacles.isSensor(code)) {
      return timeOfSensor(code, row, k, ux, uy);
    }
    if (obstacles.isOneWay(code)) {
      return timeOfOneWay(code, row, k, ux, uy);
    }
    if (code != body.last) {
      return time(code, row, k, ux, uy);
    }
    return code == ~body.support ? timeAtEnds(row, k, ux, uy) : timeOfReturn(code, row, k, ux, uy);
  }

  /** The time at which a circle that slid off an end of a line hits that or the other end. */
  private double timeAtEnds(double[] row, int k, double ux, double uy) {
    int near = nearEnd(row, k);
    int far = LineShape.END - near;
    return Math.min(
        ParabolaReturn.toDisk(px, py, vx, vy, gx, gy, row[k + near], row[k + near + 1], ux, uy, to),
        ParabolaDiskSweep.time(
            px, py, r, vx, vy, gx, gy, row[k + far], row[k + far + 1], 0, ux, uy, to));
  }

  /** The column of the end of a line that is nearer to the start of the flight. */
  private int nearEnd(double[] row, int k) {
    double ax = px - row[k + LineShape.AX];
    double ay = py - row[k + LineShape.AY];
    double bx = px - row[k + LineShape.BX];
    double by = py - row[k + LineShape.BY];
    return ax * ax + ay * ay < bx * bx + by * by ? 0 : LineShape.END;
  }

  /** The row of an obstacle as it was at the start of the flight: its own, or that of this. */
  private double[] row(int code) {
    if (!obstacles.moves(code)) {
      return obstacles.of(code).values;
    }
    obstacles.place(obstacles.motions().indexOf(code), body.t, body.tl, placed);
    return placed;
  }

  private double time(int code, double[] row, int k, double ux, double uy) {
    return Codes.isLine(code)
        ? ParabolaSegmentSweep.time(
            px,
            py,
            r,
            vx,
            vy,
            gx,
            gy,
            row[k + LineShape.AX],
            row[k + LineShape.AY],
            row[k + LineShape.BX],
            row[k + LineShape.BY],
            ux,
            uy,
            to)
        : ParabolaDiskSweep.time(
            px,
            py,
            r,
            vx,
            vy,
            gx,
            gy,
            row[k + PegShape.X],
            row[k + PegShape.Y],
            row[k + PegShape.RADIUS],
            ux,
            uy,
            to);
  }

  private double timeOfReturn(int code, double[] row, int k, double ux, double uy) {
    return Codes.isLine(code)
        ? ParabolaReturn.toLine(
            px,
            py,
            r,
            vx,
            vy,
            gx,
            gy,
            row[k + LineShape.AX],
            row[k + LineShape.AY],
            row[k + LineShape.BX],
            row[k + LineShape.BY],
            ux,
            uy,
            to)
        : ParabolaReturn.toDisk(
            px, py, vx, vy, gx, gy, row[k + PegShape.X], row[k + PegShape.Y], ux, uy, to);
  }

  private double timeAfter(int code, double[] row, int k, double ux, double uy, double after) {
    return Codes.isLine(code)
        ? ParabolaSegmentSweep.timeAfter(
            px,
            py,
            r,
            vx,
            vy,
            gx,
            gy,
            row[k + LineShape.AX],
            row[k + LineShape.AY],
            row[k + LineShape.BX],
            row[k + LineShape.BY],
            ux,
            uy,
            after,
            to)
        : ParabolaDiskSweep.timeAfter(
            px,
            py,
            r,
            vx,
            vy,
            gx,
            gy,
            row[k + PegShape.X],
            row[k + PegShape.Y],
            row[k + PegShape.RADIUS],
            ux,
            uy,
            after,
            to);
  }

  /** The next time at which a sensor that was not reported yet is entered. */
  private double timeOfSensor(int code, double[] row, int k, double ux, double uy) {
    double after = code > sensedCode && sensed > 0 ? Math.nextDown(sensed) : sensed;
    return timeAfter(code, row, k, ux, uy, Math.max(after, 0));
  }

  /**
   * The next time at which a one-way line is hit: it is touched from outside, by a circle whose
   * centre is strictly left of it.
   */
  private double timeOfOneWay(int code, double[] row, int k, double ux, double uy) {
    if (code == body.last) {
      double t = timeOfReturn(code, row, k, ux, uy);
      if (t > to || t == NEVER || isLeft(row, k, ux, uy, t)) {
        return t;
      }
    } else if (touches(row, k)) {
      double t = time(code, row, k, ux, uy);
      if (t == 0) {
        return 0;
      }
    }
    double t = timeAfter(code, row, k, ux, uy, -1);
    while (t <= to && t < NEVER && !isLeft(row, k, ux, uy, t)) {
      t = timeAfter(code, row, k, ux, uy, t);
    }
    return t;
  }

  /** Whether the centre is left of a one-way line at a time, by doubles; at 0, exactly. */
  private boolean isLeft(double[] row, int k, double ux, double uy, double t) {
    double ax = row[k + LineShape.AX];
    double ay = row[k + LineShape.AY];
    double bx = row[k + LineShape.BX];
    double by = row[k + LineShape.BY];
    if (t == 0) {
      return Predicates.cross(bx, by, ax, ay, px, py, ax, ay) > 0;
    }
    double x = place(px - ax, vx - ux, gx, t);
    double y = place(py - ay, vy - uy, gy, t);
    return (bx - ax) * y - (by - ay) * x > 0;
  }

  /**
   * Whether the circle starts left of a one-way line and overlaps it by no more than rounding: it
   * stands on it, although it does not come from outside.
   */
  private boolean touches(double[] row, int k) {
    double ax = row[k + LineShape.AX];
    double ay = row[k + LineShape.AY];
    double wx = row[k + LineShape.BX] - ax;
    double wy = row[k + LineShape.BY] - ay;
    double height = wx * (py - ay) - wy * (px - ax);
    double size = Math.abs(px) + Math.abs(py) + r;
    return height > 0 && height >= (r - TOUCH * size) * Math.sqrt(wx * wx + wy * wy);
  }

  // The contact.

  /** The {@link Contact} of what was found. */
  private int contact(int code, double t) {
    if (Codes.isWall(code) || code == body.support) {
      return 0;
    }
    if (!Codes.isLine(code)) {
      return t == 0 ? Contact.NOW : Contact.LATER;
    }
    double[] row = row(code);
    int k = row == placed ? 0 : obstacles.of(code).offset(code);
    if (code == ~body.support && t == 0) {
      return (nearEnd(row, k) == 0 ? Contact.START : Contact.END) | Contact.NOW;
    }
    boolean isReturn = code == body.last && !obstacles.isSensor(code);
    return isReturn
        ? ParabolaReturn.contactOfReturn(
            px,
            py,
            r,
            vx,
            vy,
            gx,
            gy,
            row[k + LineShape.AX],
            row[k + LineShape.AY],
            row[k + LineShape.BX],
            row[k + LineShape.BY],
            obstacles.ux(code),
            obstacles.uy(code),
            t)
        : ParabolaSegmentSweep.contact(
            px,
            py,
            r,
            vx,
            vy,
            gx,
            gy,
            row[k + LineShape.AX],
            row[k + LineShape.AY],
            row[k + LineShape.BX],
            row[k + LineShape.BY],
            obstacles.ux(code),
            obstacles.uy(code),
            t);
  }

  // Slides.

  /** Considers the time at which a circle that slides along a line comes to one of its ends. */
  private void considerEndOfSlide() {
    int code = body.support;
    if (code == MovingCircle.NOTHING || Codes.isWall(code) || !Codes.isLine(code)) {
      return;
    }
    double[] row = row(code);
    int k = row == placed ? 0 : obstacles.of(code).offset(code);
    double ax = row[k + LineShape.AX];
    double ay = row[k + LineShape.AY];
    double bx = row[k + LineShape.BX];
    double by = row[k + LineShape.BY];
    double wx = bx - ax;
    double wy = by - ay;
    double speed = wx * (vx - obstacles.ux(code)) + wy * (vy - obstacles.uy(code));
    double pull = wx * gx + wy * gy;
    double toEnd = reaches(wx * (px - bx) + wy * (py - by), speed, pull);
    double toStart = reaches(wx * (ax - px) + wy * (ay - py), -speed, -pull);
    double t = Math.min(toEnd, toStart);
    if (t <= to && t < best) {
      best = t;
      to = t;
      bestCode = code;
      isBestSensor = false;
    }
  }

  /** The first time at which c + v t + g t^2 / 2 becomes positive. */
  private static double reaches(double c, double v, double g) {
    if (c >= 0) {
      return v > 0 || (v == 0 && g > 0) ? 0 : g > 0 ? -2 * v / g : NEVER;
    }
    double discriminant = v * v - 2 * g * c;
    double sum = v + Math.sqrt(discriminant);
    return sum > 0 ? -2 * c / sum : NEVER; // never also for NaN
  }
}
