// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.exact.ExactTime;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.PointSweep;
import dev.carom.internal.sweep.SegmentFilter;
import dev.carom.internal.sweep.SideSweep;
import dev.carom.internal.sweep.UnitVectors;
import dev.carom.internal.sweep.WallSweep;

/**
 * The narrow phase of a flight among obstacles: asks the detector whether and when each candidate
 * is hit, and keeps the earliest impact. Among equal times it keeps the smallest code. A flight
 * treats equal rounded times as simultaneous; a cast compares the exact ones. Casts and traces
 * ignore sensors.
 *
 * <p>Every question is asked for the start of the flight. So the answer does not depend on the
 * order in which the search finds the candidates.
 */
abstract class NarrowPhase {

  static final double NEVER = Double.POSITIVE_INFINITY;

  final ObstacleTable obstacles;

  /** The rows of the lines, by their codes. */
  double[] lines;

  boolean special;

  /** Whether any obstacle moves. */
  boolean moving;

  /** Where a moving obstacle was at the start of the flight under search. */
  private final double[] placed = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** Whether sensors are ignored. */
  private boolean passesSensors;

  /** Whether impacts of equal rounded times are ordered by their exact times. */
  private boolean ordersExactly;

  /** Whether the choice of an impact depends on more than times and codes. */
  private boolean careful;

  /** Whether there are walls that the circle can meet. */
  boolean bounded;

  /** Whether filters may let the circle pass through some obstacles. */
  private boolean filtered;

  // The flight under search.
  double px;
  double py;
  double vx;
  double vy;
  double r;
  private double t;
  private double tl;
  int last;
  IgnoreList jam;
  private long filter;

  /** The {@link SegmentFilter#margin} of all lines; the broad phase sets it before a search. */
  double margin;

  /**
   * Sensor contacts already reported: all before this time, and at exactly this time those with a
   * code up to {@code sensedCode}.
   */
  private double sensed;

  private int sensedCode;

  /**
   * The time of the best impact found so far. While it is rough, it is the estimate of {@link
   * SegmentFilter}.
   */
  double best;

  private boolean isRough;

  /** An upper bound of the exact time of the best impact. */
  double latest;

  int bestCode;
  int bestContact;

  NarrowPhase(ObstacleTable obstacles) {
    this.obstacles = obstacles;
  }

  /** Reads the arrays of obstacles again: an edit may have replaced them. */
  final void readAgain() {
    lines = obstacles.lines.values;
    special = obstacles.areSpecial();
    careful = special || ordersExactly;
    moving = obstacles.areMoving();
  }

  /** Sets whether searches ignore sensors. */
  final void setPassesSensors(boolean passes) {
    passesSensors = passes;
  }

  /** Sets whether searches order impacts by their exact times. */
  final void setOrdersExactly(boolean exactly) {
    ordersExactly = exactly;
    careful = special || exactly;
  }

  /** Whether a flight, followed for ever from its start, meets a line or a peg. */
  public final boolean meets(MovingCircle body, int code) {
    start(body);
    last = MovingCircle.NOTHING;
    jam = null;
    sensed = -1;
    best = NEVER;
    if (obstacles.moves(code)) {
      considerMoving(obstacles.motions().indexOf(code), NEVER);
    } else if (canHit()) {
      consider(code);
    }
    return bestCode == code;
  }

  /** Begins a search: nothing is found yet. */
  final void start(MovingCircle body) {
    px = body.x;
    py = body.y;
    vx = body.vx;
    vy = body.vy;
    r = body.radius;
    t = body.t;
    tl = body.tl;
    last = body.last;
    jam = body.jam;
    filter = body.filter;
    filtered = obstacles.areFiltered() || filter != Filter.DEFAULT;
    bounded = filtered ? obstacles.wallsFor(filter) != null : obstacles.walls != null;
    sensed = body.cleared;
    sensedCode = body.sensedCode;
    best = NEVER;
    latest = NEVER;
    isRough = false;
    bestCode = MovingCircle.NOTHING;
    bestContact = 0;
  }

  /** Whether the circle moves and its coordinates are finite; else it hits nothing. */
  final boolean canHit() {
    return isInRange() && (vx != 0 || vy != 0);
  }

  private boolean isInRange() {
    return Math.abs(px) <= Double.MAX_VALUE && Math.abs(py) <= Double.MAX_VALUE;
  }

  /** Considers an obstacle other than a wall. */
  final void consider(int code) {
    if (code == bestCode || skipped(code)) {
      return;
    }
    ObstacleRows rows = obstacles.of(code);
    ObstacleShape shape = rows.shape;
    double[] values = rows.values;
    int k = rows.offset(code);
    if (Double.isNaN(values[k])) {
      return; // removed
    }
    consider(code, shape, values, k, 0, 0);
  }

  /**
   * Considers number i of the obstacles that move, or passes over it if it is certainly not hit by
   * a time of interest.
   */
  final void considerMoving(int i, double limit) {
    int code = obstacles.motions().code(i);
    if (!isInRange() || skipped(code) || (jam != null && jam.isCrushedBy(code))) {
      return;
    }
    obstacles.place(i, t, tl, placed);
    double ux = obstacles.motions().ux(i);
    double uy = obstacles.motions().uy(i);
    if (!Codes.isLine(code) || mayHit(vx - ux, vy - uy, Math.min(limit, latest))) {
      consider(code, obstacles.of(code).shape, placed, 0, ux, uy);
    }
  }

  /**
   * Whether the moving line may be hit by a given time, by the filter for a line at rest. The
   * relative velocity s is rounded, by 1 u of each component; twice the margin covers that.
   */
  private boolean mayHit(double sx, double sy, double end) {
    double ax = placed[LineShape.AX];
    double ay = placed[LineShape.AY];
    double bx = placed[LineShape.BX];
    double endY = placed[LineShape.BY];
    double ofA = Math.max(Math.abs(ax), Math.abs(ay));
    double ofB = Math.max(Math.abs(bx), Math.abs(endY));
    double size = Math.abs(px) + Math.abs(py) + r + Math.max(ofA, ofB);
    double doubt = 2 * SegmentFilter.margin(Math.abs(sx) + Math.abs(sy), size);
    int contact = SegmentFilter.contact(px, py, r, sx, sy, ax, ay, bx, endY, doubt);
    if (contact <= Contact.MISS) {
      return contact == Contact.DOUBT;
    }
    double rough = SegmentFilter.time(contact, px, py, r, sx, sy, ax, ay, bx, endY);
    return !(rough * (1 - SegmentFilter.TIME_ERROR) > end);
  }

  private void consider(
      int code, ObstacleShape shape, double[] values, int k, double ux, double uy) {
    if (special && obstacles.isOneWay(code) && !stops(values, k, ux, uy)) {
      return;
    }
    int contact = shape.contact(px, py, r, vx, vy, values, k, ux, uy);
    if (contact != Contact.MISS) {
      offer(shape.time(contact, px, py, r, vx, vy, values, k, ux, uy), code, contact);
    }
  }

  /**
   * Whether a one-way line is there: the centre is strictly left of it, and moves to its right as
   * seen from the line.
   */
  private boolean stops(double[] values, int k, double ux, double uy) {
    double ax = values[k + LineShape.AX];
    double ay = values[k + LineShape.AY];
    double bx = values[k + LineShape.BX];
    double by = values[k + LineShape.BY];
    return Predicates.cross(bx, by, ax, ay, px, py, ax, ay) > 0
        && Predicates.cross(bx, by, ax, ay, vx, vy, ux, uy) < 0;
  }

  /** Considers the wall that the circle moves towards on one axis. */
  final void considerWall(double p, double v, int lowCode) {
    int code = wallCode(lowCode, v);
    double t = WallSweep.time(p, r, v, obstacles.walls[code]);
    if (!skipped(code)) {
      offer(t, code, 0);
    }
  }

  /** The code of the wall that v points to, of two parallel ones; either if v is 0. */
  private static int wallCode(int lowCode, double v) {
    return lowCode + (UnitVectors.sign(v) + 1) / 2;
  }

  /**
   * Whether a search ignores an obstacle. The one just hit is convex, so this flight cannot hit it
   * again.
   */
  private boolean skipped(int code) {
    return code == last
        || (filtered && passes(code))
        || (jam != null && jam.makesInert(code))
        || (passesSensors && obstacles.isSensor(code));
  }

  /** Whether filters let the circle pass through an obstacle. */
  private boolean passes(int code) {
    return !Filter.meet(filter, obstacles.filter(code));
  }

  /** Considers a line; the segment filter alone decides nearly always. */
  final void look(int code) {
    if (code == bestCode || (filtered && passes(code))) {
      return;
    }
    int k = code * LineShape.ROW;
    double ax = lines[k + LineShape.AX];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double by = lines[k + LineShape.BY];
    int contact = SegmentFilter.contact(px, py, r, vx, vy, ax, ay, bx, by, margin);
    if (contact > Contact.MISS) {
      keepRough(SegmentFilter.time(contact, px, py, r, vx, vy, ax, ay, bx, by), code, contact);
    } else if (contact == Contact.DOUBT) {
      consider(code);
    }
  }

  /** Keeps a contact whose time is rough, unless an earlier impact is certain. */
  private void keepRough(double t, int code, int contact) {
    double after = t * (1 + SegmentFilter.TIME_ERROR);
    if (after < best) {
      best = t;
      latest = after;
      isRough = true;
      bestCode = code;
      bestContact = contact;
    } else if (t * (1 - SegmentFilter.TIME_ERROR) <= latest) { // latest may be exact
      offer(timeOf(code, contact, t), code, contact);
    }
  }

  /** Finds the exact time of the best impact. */
  final void settle() {
    if (isRough) {
      isRough = false;
      best = timeOf(bestCode, bestContact, best);
      latest = best;
    }
  }

  /** The exact time of a contact with a line, from the rough one. */
  private double timeOf(int line, int contact, double rough) {
    int k = line * LineShape.ROW;
    if (contact >= Contact.START) {
      // A branch on the end would be unpredictable, so the index is computed without one.
      int end = k + (contact - Contact.START) * LineShape.END;
      double x = lines[end + LineShape.AX];
      double y = lines[end + LineShape.AY];
      return PointSweep.time(px, py, r, vx, vy, x, y, rough);
    }
    int side = contact == Contact.LEFT ? 1 : -1;
    double ax = lines[k + LineShape.AX];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double by = lines[k + LineShape.BY];
    return SideSweep.refined(side, px, py, r, vx, vy, ax, ay, bx, by, rough);
  }

  private void offer(double t, int code, int contact) {
    if (t <= latest) {
      settle();
    }
    if (careful && !comesFirst(t, code, contact)) {
      return;
    }
    if (t < best || (t == best && (careful || code < bestCode))) {
      best = t;
      latest = t;
      bestCode = code;
      bestContact = contact;
    }
  }

  /** Whether an impact comes before the best one, by the rules beyond times and codes. */
  private boolean comesFirst(double t, int code, int contact) {
    boolean sensor = obstacles.isSensor(code);
    if (sensor && wasSensed(t, code)) {
      return false;
    }
    if (t != best || t == NEVER) {
      return t < best;
    }
    return ordersExactly ? isEarlier(code, contact) : isBefore(sensor, code);
  }

  /** Whether a sensor contact was reported before, or existed at the start of the flight. */
  private boolean wasSensed(double t, int code) {
    return !(t > sensed || (t == sensed && t > 0 && code > sensedCode));
  }

  /** Orders simultaneous impacts: sensors first, since they change nothing, then by code. */
  private boolean isBefore(boolean sensor, int code) {
    boolean bestSensor = obstacles.isSensor(bestCode);
    return sensor == bestSensor ? code < bestCode : sensor;
  }

  /** Whether an impact is before the best one by exact times, then by code. */
  private boolean isEarlier(int code, int contact) {
    int order = exactTime(code, contact).compare(exactTime(bestCode, bestContact));
    return order != 0 ? order < 0 : code < bestCode;
  }

  /** The exact time of the next impact of a circle. */
  public final ExactTime exactTime(MovingCircle body) {
    start(body);
    return exactTime(body.next, body.contact);
  }

  private ExactTime exactTime(int code, int contact) {
    if (Codes.isWall(code)) {
      boolean vertical = Codes.isVertical(code);
      return WallSweep.exactTime(vertical ? px : py, r, vertical ? vx : vy, obstacles.walls[code]);
    }
    double[] row = obstacles.rowAt(code, t, tl);
    ObstacleShape shape = obstacles.of(code).shape;
    return shape.exactTime(
        contact, px, py, r, vx, vy, row, 0, obstacles.ux(code), obstacles.uy(code));
  }
}
