// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.Polygon;

/**
 * The earliest impact that a search has found on a flight, and the rules that decide between
 * impacts, for all kinds of flights:
 *
 * <ul>
 *   <li>which obstacles a flight ignores: {@link #ignores};
 *   <li>which impacts with sensors count: {@link #wasSensed};
 *   <li>which of two impacts at one time is first: {@link #winsTie}.
 * </ul>
 *
 * <p>{@link OneWay} has the rule of one-way lines. Every question is asked for the whole flight. So
 * the answer does not depend on the order in which a search finds the candidates.
 */
abstract class FirstImpact {

  static final double NEVER = Double.POSITIVE_INFINITY;

  /** Far more than the rounding of a place, in units of its terms. */
  private static final double ROUNDING = 0x1p-45;

  final ObstacleTable obstacles;

  /** The question to the detector: the flight and the obstacle chosen. */
  final Fall fall = new Fall();

  /** Where a moving obstacle was at the start of the flight. */
  private final double[] placed = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** Whether sensors are ignored: casts and traces do so. */
  boolean passesSensors;

  /** Whether impacts of equal rounded times are ordered by their exact times: in casts. */
  boolean ordersExactly;

  // The flight under search.
  MovingCircle body;
  double px;
  double py;
  double vx;
  double vy;
  double r;

  /** The obstacle that this flight cannot hit at all, or NOTHING. */
  int unhittable;

  IgnoreList jam;

  /** Whether filters may let the circle pass through some obstacles. */
  private boolean filtered;

  /** Whether there are walls that the circle can meet. */
  boolean bounded;

  /** Whether any obstacle has a trait. */
  boolean special;

  /** Whether the choice of an impact depends on more than times and codes. */
  private boolean careful;

  /**
   * Sensor contacts already reported: all before this time, and at exactly this time those with a
   * code up to {@code sensedCode}.
   */
  double sensed;

  int sensedCode;

  /** The time of the best impact found so far. A straight search keeps a rough one at first. */
  double best;

  /** An upper bound of the exact time of the best impact. */
  double latest;

  int bestCode;
  int bestContact;

  FirstImpact(ObstacleTable obstacles) {
    this.obstacles = obstacles;
  }

  /** Begins the search of a flight: nothing is found yet. */
  void start(MovingCircle m) {
    body = m;
    px = m.x;
    py = m.y;
    vx = m.vx;
    vy = m.vy;
    r = m.radius;
    jam = m.jam;
    filtered = obstacles.areFiltered() || m.filter != FilterBits.DEFAULT;
    bounded = filtered ? obstacles.wallsFor(m.filter) != null : obstacles.walls != null;
    special = obstacles.areSpecial();
    careful = special || ordersExactly;
    sensed = m.cleared;
    sensedCode = m.sensedCode;
    best = NEVER;
    latest = NEVER;
    bestCode = MovingCircle.NOTHING;
    bestContact = 0;
  }

  /** Chooses an obstacle at rest, other than a wall. */
  final void choose(int code) {
    ObstacleRows rows = obstacles.of(code);
    fall.obstacle(rows.shape, rows.values, rows.offset(code), 0, 0);
  }

  /** Chooses number i of the obstacles that move. */
  final void chooseMoving(int i) {
    obstacles.see(i, body.t, body.tl, placed, fall);
  }

  /** Chooses an obstacle of either kind. */
  final void chooseAny(int code) {
    int moving = obstacles.motions().indexOf(code);
    if (moving < 0) {
      choose(code);
    } else {
      chooseMoving(moving);
    }
  }

  /** Whether a contact with an obstacle, which was chosen, counts for an outline as a whole. */
  final boolean counts(int code, int contact, double t) {
    return obstacles.isSensor(code)
        ? !obstacles.isOutline(code) || !isAlreadyIn(code, t)
        : obstacles.outside(code) == 0 || isFromOutside(code, contact, t);
  }

  /**
   * Whether a circle that comes to a side of a sensor, which was chosen, is in the outline already:
   * it overlaps another side, or touches one that comes before, or its centre is inside.
   */
  private boolean isAlreadyIn(int code, double t) {
    double x = fall.ax + fall.roughX(t);
    double y = fall.ay + fall.roughY(t);
    double near = ROUNDING * (Math.abs(x) + Math.abs(y) + r);
    boolean isInside = false;
    boolean touches = false;
    int end = obstacles.endOf(code);
    for (int each = obstacles.firstOf(code); each < end; each++) {
      double[] row = obstacles.rowAt(each, body.t, body.tl); // seen from it, it stays there
      double gap = LineShape.INSTANCE.distance(row, 0, x, y) - r;
      touches |= each != code && gap < (each < code ? near : -near);
      isInside ^= Polygon.isCrossed(row[0], row[1], row[2], row[3], x, y);
    }
    return touches || (isInside && obstacles.outside(code) != 0);
  }

  /**
   * Whether a contact with a side of a solid polygon, which was chosen, comes from outside. At an
   * end that is an outer corner the centre is outside of one of the two sides, at an inner corner
   * of both.
   *
   * @param contact the contact, see {@link Contact}
   * @param t its time
   */
  final boolean isFromOutside(int code, int contact, double t) {
    int outside = obstacles.outside(code);
    int part = Contact.withoutTime(contact);
    if (part == Contact.LEFT || part == Contact.RIGHT) {
      return (part == Contact.LEFT) == (outside > 0);
    }
    boolean atStart = part == Contact.START;
    obstacles.numbersAt(obstacles.neighbor(code, atStart), body.t, body.tl, placed);
    double itsX = placed[LineShape.BX] - placed[LineShape.AX];
    double itsY = placed[LineShape.BY] - placed[LineShape.AY];
    // The three points from the first side to the second one, where they are for this flight.
    double fromX = atStart ? fall.ax - itsX : fall.ax;
    double fromY = atStart ? fall.ay - itsY : fall.ay;
    double overX = atStart ? fall.ax : fall.bx;
    double overY = atStart ? fall.ay : fall.by;
    double toX = atStart ? fall.bx : fall.bx + itsX;
    double toY = atStart ? fall.by : fall.by + itsY;
    double x = fall.ax + fall.roughX(t);
    double y = fall.ay + fall.roughY(t);
    boolean first = LineShape.side(fromX, fromY, overX, overY, x, y) * outside > 0;
    boolean second = LineShape.side(overX, overY, toX, toY, x, y) * outside > 0;
    boolean isOuter = LineShape.side(fromX, fromY, overX, overY, toX, toY) * outside < 0;
    return isOuter ? first || second : first && second;
  }

  /** Whether the flight passes an obstacle, whatever its place. */
  final boolean ignores(int code) {
    return code == unhittable || letsThrough(code);
  }

  /** Whether an obstacle lets the circle pass, also if it was not just hit. */
  final boolean letsThrough(int code) {
    return isFiltered(code)
        || (jam != null && (jam.makesInert(code) || jam.isCrushedBy(code)))
        || (passesSensors && obstacles.isSensor(code));
  }

  /** Whether filters let the circle pass through an obstacle. */
  final boolean isFiltered(int code) {
    return filtered && !FilterBits.meet(body.filter, obstacles.filter(code));
  }

  /** Takes an impact if it is before the best one so far, and returns whether it is. */
  final boolean take(double t, int code, int contact) {
    if (!(t <= best) || t == NEVER) {
      return false;
    }
    if (careful && obstacles.isSensor(code) && wasSensed(t, code)) {
      return false;
    }
    if (t == best && !winsTie(code, contact)) {
      return false;
    }
    best = t;
    latest = t;
    bestCode = code;
    bestContact = contact;
    return true;
  }

  /** Whether a contact with a sensor was reported before, or existed at the start of the flight. */
  private boolean wasSensed(double t, int code) {
    return !(t > sensed || (t == sensed && t > 0 && code > sensedCode));
  }

  /**
   * The rule of ties: whether an impact comes before the best one, which has the same rounded time.
   * Sensors are first, since they change nothing. A cast compares the exact times, a flight does
   * not. Then the smaller code is first. The end of a slide comes after all impacts.
   */
  private boolean winsTie(int code, int contact) {
    if (bestCode == body.support) {
      return true;
    }
    boolean isSensor = obstacles.isSensor(code);
    if (isSensor != obstacles.isSensor(bestCode)) {
      return isSensor;
    }
    int order =
        ordersExactly
            ? exactTime(code, contact, best).order(exactTime(bestCode, bestContact, best))
            : 0;
    return order < 0 || (order == 0 && code < bestCode);
  }

  /** The exact time of an impact, which rounds to t; asked in casts only. */
  abstract RealRoot exactTime(int code, int contact, double t);

  /** The exact time of the next impact of a circle. */
  final RealRoot exactTime(MovingCircle m) {
    start(m);
    return exactTime(m.next, m.contact, m.cleared);
  }

  /** The contact of the best impact. */
  int contact() {
    return bestContact;
  }
}
