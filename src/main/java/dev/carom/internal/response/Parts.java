// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.PegShape;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.KindNumber;
import dev.carom.internal.util.Part;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The geometry of contact: what a circle of radius r at c can touch, with the unit normal n from
 * there to the circle, and the gap. Obstacles have convex <i>parts</i>:
 *
 * <ul>
 *   <li>a side of a line, from a along the unit vector w: the span is {@code 0 <= (c - a).w <=
 *       length}, and the gap {@code |(c - a) x w| - r};
 *   <li>a wall, which is a side without ends that has an inside;
 *   <li>a vertex: ends at one place of lines that move alike. It is felt where the centre projects
 *       on none of these lines, so nowhere along a straight joint;
 *   <li>a disk: a peg, or a circle of infinite mass. The gap is {@code |c - p| - r - radius}.
 * </ul>
 *
 * <p>A part gets its number when a circle first comes near. Numbers are no state: {@link #key} is.
 */
final class Parts {

  static final byte SIDE = 0;
  static final byte WALL = 1;
  static final byte DISK = 2;
  static final byte VERTEX = 3;

  /** From here on squares of lengths have all their bits. */
  private static final double LEAST_SQUARE = 0x1p-900;

  private final ObstacleTable obstacles;
  private final CircleRegistry registry;
  private final CircleTable circles;
  private final double[] row = new double[ObstacleTable.MOST_NUMBERS + 1];

  int count;
  private int[] code = new int[8];

  /** The number of the end of a line that is a vertex: 1 for its start, 2 for its end; else 0. */
  private byte[] end = new byte[8];

  byte[] kind = new byte[8];
  double[] x = new double[8];
  double[] y = new double[8];
  double[] dx = new double[8];
  double[] dy = new double[8];
  double[] length = new double[8];
  double[] radius = new double[8];
  double[] restitution = new double[8];

  /** The velocity of what does not turn; of what turns the pivot, and q seen from now, else 0. */
  private double[] vx = new double[8];

  private double[] vy = new double[8];
  double[] pivotX = new double[8];
  double[] pivotY = new double[8];
  double[] qx = new double[8];
  double[] qy = new double[8];
  private boolean[] oneWay = new boolean[8];

  /** The lines that end in a vertex; of a side, the vertices at its start and end, or NONE. */
  private int[][] links = new int[8][];

  private int[] seen = new int[8];
  private int search;

  /** The number of the first part of each code, by kind and index; NONE before it is needed. */
  private final int[][] numbers = new int[KindNumber.CIRCLE + 1][0];

  private final IntList codes = new IntList();

  /** The distinct velocities of all that moves, and the largest speed. */
  private final DoubleList frames = new DoubleList();

  private double fastest;
  private boolean turns;
  private boolean stale = true;
  private double tail;

  // The answer of touches.
  double normalX;
  double normalY;
  double distance;

  /**
   * @param registry null for a circle alone, whatever its slot
   * @param circles the circles of which those of infinite mass are parts; null for none
   */
  Parts(ObstacleTable obstacles, CircleRegistry registry, CircleTable circles) {
    this.obstacles = obstacles;
    this.registry = registry;
    this.circles = circles;
  }

  /** The id of a circle, which a save keeps, unlike its slot. */
  int id(int slot) {
    return registry == null ? slot : registry.id(slot);
  }

  // What there is.

  /** Notes that obstacles, or infinite masses, changed; {@link #update} then forgets all parts. */
  void changed() {
    stale = true;
  }

  boolean isStale() {
    return stale;
  }

  /** Forgets all parts, for times with a given tail. */
  void update(double tailOfTimes) {
    tail = tailOfTimes;
    update();
  }

  /** Forgets all parts, and finds the velocities of what moves. */
  void update() {
    stale = false;
    for (int part = 0; part < count; part++) {
      numbers[Codes.kind(code[part])][Codes.index(code[part])] = Index.NONE;
    }
    count = 0;
    frames.clear();
    fastest = 0;
    ObstacleMotions motions = obstacles.motions();
    turns = false;
    for (int i = 0; i < motions.count(); i++) {
      addFrame(motions.ux(i), motions.uy(i));
      if (motions.turns(i)) {
        addTurn(motions, i);
      }
    }
    if (circles != null && registry.hasInfinite()) {
      for (int slot : registry.slots()) {
        if (registry.mass(slot) == Double.POSITIVE_INFINITY) {
          addFrame(circles.vx(slot, 0), circles.vy(slot, 0));
        }
      }
    }
  }

  private void addFrame(double ux, double uy) {
    if (ux == 0 && uy == 0) {
      return;
    }
    fastest = Math.max(fastest, Math.sqrt(ux * ux + uy * uy));
    for (int k = 0; k < frames.size(); k += 2) {
      if (frames.get(k) == ux && frames.get(k + 1) == uy) {
        return;
      }
    }
    frames.add(ux, uy);
  }

  /**
   * Notes how fast a point of what turns may be. Its rate is at most {@code 2 |q|^2 / Im(q)}, with
   * q seen from whenever: c = 1 + q t is nowhere nearer to 0 than by {@code Im(q) / |q|}.
   */
  private void addTurn(ObstacleMotions motions, int i) {
    turns = true;
    double re = motions.turnX(i, motions.until(i), 0);
    double im = motions.turnY(i, motions.until(i), 0);
    int its = motions.code(i);
    ObstacleRows rows = obstacles.of(its);
    int k = rows.offset(its);
    double far = 0;
    for (int c = 0; c <= rows.shape.toEnd; c += LineShape.END) {
      double px = rows.values[k + c] - motions.pivotX(i);
      double py = rows.values[k + c + 1] - motions.pivotY(i);
      far = Math.max(far, length(px, py));
    }
    far += rows.shape.radius(rows.values, k);
    fastest = Math.max(fastest, 2 * (re * re + im * im) / Math.abs(im) * far);
  }

  double fastest() {
    return fastest;
  }

  boolean areTurning() {
    return turns;
  }

  boolean areMoving() {
    return fastest > 0;
  }

  /** Chooses the frame, that at rest or that of something that moves, nearest to a velocity. */
  int nearestFrame(double ux, double uy) {
    int best = Index.NONE;
    double least = ux * ux + uy * uy;
    for (int k = 0; k < frames.size(); k += 2) {
      double x = ux - frames.get(k);
      double y = uy - frames.get(k + 1);
      if (x * x + y * y < least) {
        least = x * x + y * y;
        best = k;
      }
    }
    return best;
  }

  double frameX(int frame) {
    return frame == Index.NONE ? 0 : frames.get(frame);
  }

  double frameY(int frame) {
    return frame == Index.NONE ? 0 : frames.get(frame + 1);
  }

  /** Whether a circle bounces off an obstacle: the filters let them meet, and it is no sensor. */
  private boolean isSolid(long filter, int code) {
    if (Codes.isCircle(code)) {
      int slot = Codes.slot(code);
      return FilterBits.meet(filter, registry.filter(slot)) && !registry.isSensor(slot);
    }
    return FilterBits.meet(filter, obstacles.filter(code))
        && (Codes.isWall(code) || !(obstacles.isGone(code) || obstacles.isSensor(code)));
  }

  // Search.

  /** Adds the parts that are nearer to a member now than a given distance, by their keys. */
  void near(
      Members members, int i, ContactSurroundings host, double reach, double now, IntList into) {
    double px = members.xAt(i, now);
    double py = members.yAt(i, now);
    codes.clear();
    host.obstaclesNear(i, px, py, reach, now, codes);
    int from = into.size();
    search++;
    long filter = members.filter[i];
    double most = reach + members.radius[i];
    for (int k = 0; k < codes.size(); k++) {
      if (isSolid(filter, codes.get(k))) {
        int part = number(codes.get(k), now);
        add(part, px, py, most, into);
        if (kind[part] == SIDE) {
          addEnd(part, 0, now, px, py, most, into);
          addEnd(part, 1, now, px, py, most, into);
        }
      }
    }
    sort(into, from);
  }

  private void add(int part, double px, double py, double most, IntList into) {
    if (seen[part] != search && distanceTo(part, px, py) <= most) {
      seen[part] = search;
      into.add(part);
    }
  }

  private void addEnd(
      int side, int which, double now, double px, double py, double most, IntList into) {
    double toX = px - endX(side, which);
    double toY = py - endY(side, which);
    if (toX * toX + toY * toY <= most * most) {
      add(vertex(side, which, now), px, py, most, into);
    }
  }

  private void sort(IntList parts, int from) {
    for (int a = from + 1; a < parts.size(); a++) {
      int part = parts.get(a);
      long key = key(part);
      int b = a - 1;
      while (b >= from && key(parts.get(b)) > key) {
        parts.set(b + 1, parts.get(b));
        b--;
      }
      parts.set(b + 1, part);
    }
  }

  // Numbers.

  /** What a part is, in a number that holds as long as the obstacles stay. */
  long key(int part) {
    return (long) code[part] << 2 | end[part];
  }

  /** The code of the obstacle that a part belongs to; of a vertex, the lowest that is met. */
  int code(int part, long filter) {
    return code[met(part, filter)];
  }

  /** The side of a vertex with the lowest code that a circle can meet; any other part itself. */
  private int met(int part, long filter) {
    int lowest = part;
    for (int side : kind[part] == VERTEX ? links[part] : new int[0]) {
      boolean isLower = lowest == part || code[side] < code[lowest];
      lowest = isLower && FilterBits.meet(filter, obstacles.filter(code[side])) ? side : lowest;
    }
    return lowest;
  }

  /** The codes of the obstacles that a part belongs to: of a vertex, all lines that end there. */
  int[] codes(int part) {
    return kind[part] == VERTEX
        ? IntStream.of(links[part]).map(side -> code[side]).toArray()
        : new int[] {code[part]};
  }

  /** The {@link Part} that a part is, of the obstacle with its {@link #code}. */
  int feature(int part, long filter) {
    return switch (kind[part]) {
      case SIDE, WALL -> Part.SIDE;
      case VERTEX -> links[met(part, filter)][0] == part ? Part.START : Part.END;
      default -> Codes.isLine(code[part]) ? Part.START : Part.CIRCLE;
    };
  }

  static int codeOf(long key) {
    return (int) (key >> 2);
  }

  /** The number of the part with a key; NONE if that is gone, or no vertex of its own any more. */
  int ofKey(long key, double now) {
    int its = codeOf(key);
    if (!isThere(its)) {
      return Index.NONE;
    }
    int part = number(its, now);
    int which = (int) (key & 3);
    if (which == 0 || kind[part] != SIDE) {
      return which == 0 ? part : Index.NONE;
    }
    return links[part][which - 1];
  }

  private boolean isThere(int its) {
    if (Codes.isCircle(its)) {
      int slot = Codes.slot(its);
      return registry.contains(slot) && registry.mass(slot) == Double.POSITIVE_INFINITY;
    }
    return obstacles.isThere(its);
  }

  private int number(int its, double now) {
    int[] ofKind = numbers[Codes.kind(its)];
    int index = Codes.index(its);
    if (index >= ofKind.length) {
      int known = ofKind.length;
      ofKind = Arrays.copyOf(ofKind, 2 * index + 4);
      Arrays.fill(ofKind, known, ofKind.length, Index.NONE);
      numbers[Codes.kind(its)] = ofKind;
    }
    if (ofKind[index] == Index.NONE) {
      ofKind[index] = make(its, now);
    }
    return ofKind[index];
  }

  private int make(int its, double now) {
    int part = add(its, DISK);
    if (Codes.isCircle(its)) {
      int slot = Codes.slot(its);
      radius[part] = circles.radius(slot);
      restitution[part] = registry.halts(slot) ? 0 : circles.restitution(slot);
      vx[part] = circles.vx(slot, now);
      vy[part] = circles.vy(slot, now);
      place(part, now);
      return part;
    }
    restitution[part] = obstacles.restitution(its);
    if (Codes.isWall(its)) {
      makeWall(part, its);
      return part;
    }
    vx[part] = obstacles.ux(its);
    vy[part] = obstacles.uy(its);
    oneWay[part] = obstacles.isOneWay(its) || obstacles.outside(its) != 0;
    loadRow(its, now);
    if (obstacles.turns(its)) {
      pivotX[part] = obstacles.pivotX(its);
      pivotY[part] = obstacles.pivotY(its);
      takeTurn(part, now);
    }
    x[part] = row[0];
    y[part] = row[1];
    if (Codes.isLine(its)) {
      makeSide(part, its);
    } else {
      radius[part] = row[PegShape.RADIUS];
    }
    return part;
  }

  private void makeWall(int part, int wall) {
    boolean vertical = Codes.isVertical(wall);
    kind[part] = WALL;
    x[part] = vertical ? obstacles.walls[wall] : 0;
    y[part] = vertical ? 0 : obstacles.walls[wall];
    // The inside is to the left of the direction.
    dx[part] = vertical ? 0 : Codes.inwards(wall);
    dy[part] = vertical ? -Codes.inwards(wall) : 0;
    length[part] = Double.POSITIVE_INFINITY;
  }

  /**
   * Takes length and direction from where the line was at the start of its motion, or at the end of
   * its turn: the same at all times, but for the direction of what turns.
   */
  private void makeSide(int part, int line) {
    double[] ends = obstacles.lines.values;
    int k = obstacles.lines.offset(line);
    double wx = ends[k + LineShape.BX] - ends[k + LineShape.AX];
    double wy = ends[k + LineShape.BY] - ends[k + LineShape.AY];
    length[part] = StrictMath.hypot(wx, wy);
    if (length[part] > 0) { // else it is a point
      kind[part] = SIDE;
      dx[part] = wx / length[part];
      dy[part] = wy / length[part];
      links[part] = new int[] {Index.NONE, Index.NONE};
      takeDirection(part);
    }
  }

  /** Takes the direction of a side that turns from the row that was loaded. */
  private void takeDirection(int part) {
    if (kind[part] == SIDE && turns(part)) {
      double wx = row[LineShape.BX] - row[LineShape.AX];
      double wy = row[LineShape.BY] - row[LineShape.AY];
      double size = length(wx, wy);
      dx[part] = wx / size;
      dy[part] = wy / size;
    }
  }

  private void takeTurn(int part, double now) {
    qx[part] = obstacles.turnX(code[part], now, tail);
    qy[part] = obstacles.turnY(code[part], now, tail);
  }

  private int add(int its, byte itsKind) {
    if (count == code.length) {
      grow(2 * count);
    }
    int part = count++;
    code[part] = its;
    end[part] = 0;
    kind[part] = itsKind;
    dx[part] = 0;
    dy[part] = 0;
    length[part] = 0;
    radius[part] = 0;
    vx[part] = 0;
    vy[part] = 0;
    qx[part] = 0;
    qy[part] = 0;
    oneWay[part] = false;
    seen[part] = 0;
    return part;
  }

  private void grow(int room) {
    code = Arrays.copyOf(code, room);
    end = Arrays.copyOf(end, room);
    kind = Arrays.copyOf(kind, room);
    x = Arrays.copyOf(x, room);
    y = Arrays.copyOf(y, room);
    dx = Arrays.copyOf(dx, room);
    dy = Arrays.copyOf(dy, room);
    length = Arrays.copyOf(length, room);
    radius = Arrays.copyOf(radius, room);
    restitution = Arrays.copyOf(restitution, room);
    vx = Arrays.copyOf(vx, room);
    vy = Arrays.copyOf(vy, room);
    pivotX = Arrays.copyOf(pivotX, room);
    pivotY = Arrays.copyOf(pivotY, room);
    qx = Arrays.copyOf(qx, room);
    qy = Arrays.copyOf(qy, room);
    oneWay = Arrays.copyOf(oneWay, room);
    links = Arrays.copyOf(links, room);
    seen = Arrays.copyOf(seen, room);
  }

  /** The vertex at an end of a side, of all lines near that end there and move alike. */
  private int vertex(int side, int which, double now) {
    if (links[side][which] != Index.NONE) {
      return links[side][which];
    }
    int part = add(code[side], VERTEX);
    double px = endX(side, which);
    double py = endY(side, which);
    x[part] = px;
    y[part] = py;
    takeMotion(part, side);
    restitution[part] = restitution[side];
    oneWay[part] = oneWay[side];
    end[part] = (byte) (which + 1);
    IntList lines = new IntList();
    for (int k = 0; k < codes.size(); k++) {
      int its = codes.get(k);
      if (Codes.isLine(its) && !obstacles.isGone(its) && !obstacles.isSensor(its)) {
        join(part, number(its, now), lines);
      }
    }
    links[part] = lines.toArray();
    return part;
  }

  private void takeMotion(int vertex, int side) {
    vx[vertex] = vx[side];
    vy[vertex] = vy[side];
    pivotX[vertex] = pivotX[side];
    pivotY[vertex] = pivotY[side];
    qx[vertex] = qx[side];
    qy[vertex] = qy[side];
  }

  private boolean moveAlike(int a, int b) {
    return vx[a] == vx[b]
        && vy[a] == vy[b]
        && qx[a] == qx[b]
        && qy[a] == qy[b]
        && (!turns(a) || (pivotX[a] == pivotX[b] && pivotY[a] == pivotY[b]));
  }

  private void join(int vertex, int side, IntList lines) {
    for (int which = 0; which < 2 && kind[side] == SIDE; which++) {
      if (links[side][which] == Index.NONE && endsAt(side, which, vertex)) {
        links[side][which] = vertex;
        lines.add(side);
        restitution[vertex] = Math.min(restitution[vertex], restitution[side]);
        oneWay[vertex] &= oneWay[side];
        if (code[side] < code[vertex]) {
          code[vertex] = code[side];
          end[vertex] = (byte) (which + 1);
        }
      }
    }
  }

  private boolean endsAt(int side, int which, int vertex) {
    if (!moveAlike(side, vertex)) {
      return false;
    }
    double apartX = endX(side, which) - x[vertex];
    double apartY = endY(side, which) - y[vertex];
    double size = Math.abs(x[vertex]) + Math.abs(y[vertex]) + (turns(vertex) ? length[side] : 0);
    double most = moves(vertex) ? ContactLaw.TOUCH * size : 0;
    return Math.abs(apartX) + Math.abs(apartY) <= most;
  }

  /** The x coordinate of an end of a side: exact where that is at rest. */
  private double endX(int side, int which) {
    if (which == 0 || moves(side)) {
      return x[side] + which * length[side] * dx[side];
    }
    return obstacles.lines.values[obstacles.lines.offset(code[side]) + LineShape.BX];
  }

  private double endY(int side, int which) {
    if (which == 0 || moves(side)) {
      return y[side] + which * length[side] * dy[side];
    }
    return obstacles.lines.values[obstacles.lines.offset(code[side]) + LineShape.BY];
  }

  // Motion.

  boolean moves(int part) {
    return vx[part] != 0 || vy[part] != 0 || turns(part);
  }

  boolean turns(int part) {
    return qy[part] != 0;
  }

  /** The velocity that a part has at a place: what turns has one at each. */
  double velocityX(int part, double py) {
    return turns(part) ? -2 * qy[part] * (py - pivotY[part]) : vx[part];
  }

  double velocityY(int part, double px) {
    return turns(part) ? 2 * qy[part] * (px - pivotX[part]) : vy[part];
  }

  /** The speed of a part along the normal of the last question, at a place. */
  double speed(int part, double px, double py) {
    return velocityX(part, py) * normalX + velocityY(part, px) * normalY;
  }

  /** The speed of a part that does not turn along a normal. */
  double driftAlong(int part, double nx, double ny) {
    return vx[part] * nx + vy[part] * ny;
  }

  /** Where a circle goes relative to a part that does not turn, by a flight (ux, uy) in a time. */
  double wayX(int part, double ux, double time) {
    return (ux - vx[part]) * time;
  }

  double wayY(int part, double uy, double time) {
    return (uy - vy[part]) * time;
  }

  /**
   * How fast the gap to a part that turns may bend, for a circle at a place and the unit normal n,
   * see {@link ContactLaw#bend}.
   */
  double bend(
      int part, double r, double px, double py, double vx, double vy, double nx, double ny) {
    double dx = px - pivotX[part];
    double dy = py - pivotY[part];
    double rate = 2 * qy[part];
    double faster = -2 * rate * qx[part];
    double h = dx * nx + dy * ny;
    return ContactLaw.bend(rate, faster, r, h, dy * nx - dx * ny, vy * nx - vx * ny);
  }

  /** Moves what moves to its place at a time. */
  void moveTo(double now) {
    if (fastest == 0) {
      return;
    }
    for (int part = 0; part < count; part++) {
      if (moves(part)) {
        place(part, now);
      }
    }
  }

  private void place(int part, double now) {
    int its = code[part];
    if (Codes.isCircle(its)) {
      x[part] = circles.x(Codes.slot(its), now);
      y[part] = circles.y(Codes.slot(its), now);
    } else if (kind[part] == VERTEX) {
      int side = links[part][0]; // which was made, and so moved, before
      int which = links[side][0] == part ? 0 : 1;
      x[part] = endX(side, which);
      y[part] = endY(side, which);
      takeMotion(part, side);
    } else {
      loadRow(its, now);
      x[part] = row[0];
      y[part] = row[1];
      if (turns(part)) {
        takeTurn(part, now);
        takeDirection(part);
      }
    }
  }

  private void loadRow(int its, double now) {
    if (obstacles.moves(its)) {
      obstacles.place(obstacles.motions().indexOf(its), now, tail, row);
    } else {
      ObstacleRows rows = obstacles.of(its);
      System.arraycopy(rows.values, rows.offset(its), row, 0, rows.shape.row);
    }
  }

  // Geometry.

  /** The length of a vector of any size. */
  static double length(double x, double y) {
    double square = x * x + y * y;
    boolean isSafe = square > LEAST_SQUARE && square < 1 / LEAST_SQUARE;
    return isSafe ? Math.sqrt(square) : StrictMath.hypot(x, y);
  }

  /** The distance of a part, with its ends, from a place. */
  double distanceTo(int part, double px, double py) {
    double qx = px - x[part];
    double qy = py - y[part];
    if (kind[part] == WALL) {
      return qy * dx[part] - qx * dy[part];
    }
    if (kind[part] == SIDE) {
      double along = Math.max(0, Math.min(length[part], qx * dx[part] + qy * dy[part]));
      qx -= along * dx[part];
      qy -= along * dy[part];
    }
    return length(qx, qy) - radius[part];
  }

  /** The distance of an obstacle or a circle of infinite mass from a place at a time. */
  double distanceToCode(int its, double px, double py, double now) {
    int part = number(its, now);
    if (moves(part)) {
      place(part, now);
    }
    return distanceTo(part, px, py);
  }

  /**
   * Whether a circle is in the span of a part, or gets there by a flight. Then {@link #normalX},
   * {@link #normalY} and {@link #distance} tell where the part is.
   *
   * @param mx,my the flight relative to the part
   */
  boolean touches(int part, double r, long filter, double px, double py, double mx, double my) {
    double qx = px - x[part];
    double qy = py - y[part];
    if (kind[part] <= WALL) {
      double across = qy * dx[part] - qx * dy[part];
      double sign = across >= 0 || kind[part] == WALL ? 1 : -1;
      normalX = -sign * dy[part];
      normalY = sign * dx[part];
      distance = sign * across;
      return kind[part] == WALL || spans(part, r, qx, qy, mx, my);
    }
    if (kind[part] == VERTEX && isSpanned(part, filter, px, py)) {
      return false;
    }
    double d = length(qx, qy);
    normalX = qx / d;
    normalY = qy / d;
    distance = d - radius[part];
    return d > 0;
  }

  /** The same for a part that turns: the flight (ux, uy) is a curve, as seen from it. */
  boolean touches(
      int part, double r, long filter, double px, double py, Arc arc, double ux, double uy) {
    boolean any = false;
    for (int i = 0; i < Arc.POINTS; i++) {
      any |= touches(part, r, filter, px, py, arc.wayX(i, ux, uy), arc.wayY(i, ux, uy));
    }
    return any;
  }

  private boolean spans(int side, double r, double qx, double qy, double mx, double my) {
    double from = qx * dx[side] + qy * dy[side];
    if (from >= 0 && from <= length[side]) {
      return true;
    }
    if (distance < r * (1 - ContactLaw.SLACK)) {
      return false; // it overlaps an end, and passes that first
    }
    double to = from + mx * dx[side] + my * dy[side];
    return (to >= 0 && to <= length[side]) || to < 0 != from < 0;
  }

  /**
   * Whether another part of one of the lines of a vertex, which the circle can meet, is nearer to a
   * centre: at the vertex, that projects on the line's own side.
   */
  private boolean isSpanned(int vertex, long filter, double px, double py) {
    for (int side : links[vertex]) {
      double along = (px - x[vertex]) * dx[side] + (py - y[vertex]) * dy[side];
      double inwards = links[side][0] == vertex ? along : -along;
      if (inwards >= 0 && FilterBits.meet(filter, obstacles.filter(code[side]))) {
        return true;
      }
    }
    return false;
  }

  boolean isFlat(int part) {
    return kind[part] <= WALL;
  }

  /** Whether a part is not there for circles on one side of it. */
  boolean isOneSided(int part) {
    return oneWay[part];
  }

  /** Whether circles that overlap a part pass through it: a one-way line, unlike a polygon. */
  boolean isOneWay(int part) {
    return oneWay[part] && obstacles.outside(code[part]) == 0;
  }

  /**
   * Whether a part is there for a circle at a place: one-way lines are solid from the left, and
   * polygons from outside.
   */
  boolean isSolidFrom(int part, double px, double py) {
    if (!oneWay[part]) {
      return true;
    }
    if (kind[part] != SIDE && kind[part] != VERTEX) {
      return false; // a line without length has no left
    }
    if (kind[part] == SIDE) {
      return isBeyond(part, px, py);
    }
    if (obstacles.outside(code[part]) == 0) {
      return isBeyond(links[part][0], px, py);
    }
    boolean isSolid = false;
    for (int side : links[part]) {
      isSolid |= isSolidAtEnd(part, side, px, py);
    }
    return isSolid;
  }

  /** Whether a place is where a one-way line, or a side of a polygon, is solid from. */
  private boolean isBeyond(int side, double px, double py) {
    return height(side, px, py) > 0;
  }

  /** How far a place is from a side, on the side that is solid for it. */
  private double height(int side, double px, double py) {
    double height = (py - y[side]) * dx[side] - (px - x[side]) * dy[side];
    return obstacles.outside(code[side]) < 0 ? -height : height;
  }

  /**
   * The same at a vertex, where a place projects on none of its sides. Of a polygon it is then at
   * {@code a n + b m} from the vertex, for the normals n and m of two sides, with a, b of one sign:
   * both above 0 outside. The sum of its heights over both is {@code (a + b) (1 + n.m)}.
   */
  private boolean isSolidAtEnd(int vertex, int side, double px, double py) {
    double sum = height(side, px, py);
    if (obstacles.outside(code[side]) != 0) {
      int its = obstacles.neighbor(code[side], links[side][0] == vertex);
      for (int other : links[vertex]) {
        sum += code[other] == its ? height(other, px, py) : 0;
      }
    }
    return sum > 0;
  }
}
