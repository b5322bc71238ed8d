// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.UnitVector;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.PegShape;

/**
 * What an impact does to the velocity: {@code v -= (1 + e) (v.n) / (n.n) n}, with a normal n of any
 * length and without the radius, so that errors do not feed on themselves.
 *
 * <p>n is the perpendicular of a line for its side, and the offset from the contact point to the
 * centre for an endpoint or a peg; a wall turns one component.
 *
 * <p>An impact of restitution 0 that turns the velocity back, after another one at the same place
 * turned it the other way, stops the circle: it would be turned to and fro for ever, by less each
 * time. (v lies in the cone of directions that the two normals forbid; of all velocities that lead
 * into neither thing, 0 is the nearest one.) A {@linkplain StuckRule stuck} circle has restitution
 * 0 whatever it hits, and what it then approaches by no more than rounding is inert for it. Motion
 * is taken away, not given: the TC model of S. Luding and S. McNamara (How to handle the inelastic
 * collapse of a dissipative hard-sphere gas with the TC model, Granular Matter 1, 1998) instead
 * makes impacts elastic that follow each other too fast. That feeds back energy that the scene had
 * taken away, and needs a length of time that a scene does not have.
 */
public final class ObstacleResponse {

  // What an impact leads to.

  /** Nothing: a sensor reported it, and the flight goes on. */
  public static final int SENSED = 0;

  /** A new flight. */
  public static final int NEW_FLIGHT = 1;

  /** A new flight of a stuck circle: all that it touches is to be resolved at once. */
  public static final int STUCK = 2;

  /** Range of a normal's size, and of a speed, within which their products are safe. */
  private static final double LEAST_SAFE = 0x1p-300;

  private static final double MOST_SAFE = 0x1p300;

  /**
   * An offset that is smaller than so much of a coordinate, or of one where the flight started, may
   * be mere rounding: 2^10 ulps.
   */
  private static final double SMALL = 0x1p-43;

  /** A normal is so many binary places above 1 for slow motion, whose own places may be few. */
  private static final int SLOW = 60;

  private final ObstacleTable obstacles;
  private final Impulse impulse = new Impulse();

  /** Where the flight started that ends in the impact in hand. */
  private double startX;

  private double startY;

  // The impact in hand: the contact point and the unnormalized normal.
  private double contactX;
  private double contactY;
  private double nx;
  private double ny;

  public ObstacleResponse(ObstacleTable obstacles) {
    this.obstacles = obstacles;
  }

  /**
   * Flies a mover to the impact found ahead, changes its velocity, and writes it into the log. At a
   * sensor it only writes.
   *
   * @return what it leads to: SENSED, NEW_FLIGHT or STUCK
   */
  public int resolve(MovingCircle m, ImpactRows log) {
    int code = m.next;
    if (obstacles.isSensor(code)) {
      sense(m, code, log);
      return SENSED;
    }
    startX = m.x;
    startY = m.y;
    m.advance(m.cleared);
    double vn = report(m, code, m.t, log);
    double e = m.restitution * obstacles.restitution(code);
    double speed = Math.abs(m.vx) + Math.abs(m.vy);
    double way = m.flown * speed;
    double approach = vn / (Math.abs(nx) + Math.abs(ny));
    StuckRule.count(m, way, speed, approach, e, StuckRule.ELASTIC);
    boolean stuck = StuckRule.isStuck(m);
    boolean faint = stuck && StuckRule.isFaint(m, approach);
    m.jam = faint ? IgnoreList.with(m.jam, code) : IgnoreList.ofCircles(m.jam);
    if (stuck || e == 0) {
      boolean back = turnsBack(m, way, approach);
      change(m, code, vn, 0, log);
      boolean stops = back || (stuck && StuckRule.isFaint(m, Math.abs(m.vx) + Math.abs(m.vy)));
      if (stops) {
        m.vx = 0;
        m.vy = 0;
      }
      if (stuck || stops) {
        log.setOutcome(ImpactRows.JAMMED);
      }
    } else {
      m.turn = 0;
      change(m, code, vn, e, log);
    }
    m.last = code;
    m.newFlight();
    return stuck && !faint ? STUCK : NEW_FLIGHT;
  }

  /** Changes the velocity of a circle that approaches. */
  private void change(MovingCircle m, int code, double vn, double e, ImpactRows log) {
    if (vn < 0) {
      reflect(m, code, e);
      if (stopsBeyondRange(m)) {
        log.setOutcome(ImpactRows.STOPPED);
      } else if (obstacles.halts(code)) {
        log.setOutcome(ImpactRows.HALTED);
      }
    }
  }

  /**
   * Whether an impact without bounce turns a velocity back, after another one at the same place
   * turned it the other way; keeps which way.
   */
  private boolean turnsBack(MovingCircle m, double way, double approach) {
    if (StuckRule.isFaint(m, approach)) {
      return false;
    }
    int turn = m.vx * ny > m.vy * nx ? 1 : -1;
    boolean back = m.turn == -turn && way <= StuckRule.widthOfPlace(m);
    m.turn = turn;
    return back;
  }

  /** Writes that a mover meets a sensor; the flight goes on, and is known up to there. */
  private void sense(MovingCircle m, int code, ImpactRows log) {
    startX = m.x;
    startY = m.y;
    m.x = Math.fma(m.vx, m.cleared, m.x);
    m.y = Math.fma(m.vy, m.cleared, m.y);
    report(m, code, m.after(m.cleared), log);
    log.setOutcome(ImpactRows.SENSED);
    m.x = startX;
    m.y = startY;
    m.next = MovingCircle.NOTHING;
    m.contact = code;
  }

  /** Writes that a mover is in contact with an obstacle. */
  void report(MovingCircle m, Touch touch, ImpactRows log) {
    startX = m.x;
    startY = m.y;
    m.contact = touch.contact();
    report(m, touch.code(), m.t, log);
    m.contact = 0;
  }

  /** Writes an impact of a mover that stands where it touches, and returns v.n. */
  private double report(MovingCircle m, int code, double time, ImpactRows log) {
    locate(m, code);
    double vn = dot(m.vx, m.vy, nx, ny);
    log.add(time, m.id, Codes.kind(code), Codes.index(code), ObstacleTable.part(code, m.contact));
    log.set(contactX, contactY, nx, ny, vn);
    return vn;
  }

  private void reflect(MovingCircle m, int code, double e) {
    if (!Codes.isWall(code)) {
      impulse.of(1 + e, m.vx, m.vy, nx, ny);
      m.vx = impulse.less(m.vx, nx);
      m.vy = impulse.less(m.vy, ny);
    } else if (Codes.isVertical(code)) {
      m.vx = -e * m.vx + 0.0; // + 0 turns -0 into 0
    } else {
      m.vy = -e * m.vy + 0.0;
    }
  }

  /** Stops a circle that an impact would make faster than doubles can tell. */
  public static boolean stopsBeyondRange(MovingCircle m) {
    if (Math.abs(m.vx) <= Double.MAX_VALUE && Math.abs(m.vy) <= Double.MAX_VALUE) {
      return false;
    }
    m.vx = 0;
    m.vy = 0;
    return true;
  }

  /** Finds the contact point and the normal. */
  private void locate(MovingCircle m, int code) {
    if (Codes.isWall(code)) {
      locateOnWall(m, code);
      return;
    }
    ObstacleRows rows = obstacles.of(code);
    if (Codes.isLine(code)) {
      locateOnLine(m, rows.values, rows.offset(code));
    } else {
      locateOnPeg(m, rows.values, rows.offset(code));
    }
  }

  private void locateOnWall(MovingCircle m, int code) {
    double wall = obstacles.walls[code];
    int inwards = Codes.inwards(code);
    if (Codes.isVertical(code)) {
      nx = inwards;
      ny = 0;
      contactX = wall;
      contactY = m.y;
    } else {
      nx = 0;
      ny = inwards;
      contactX = m.x;
      contactY = wall;
    }
  }

  private void locateOnLine(MovingCircle m, double[] lines, int k) {
    int contact = Contact.withoutTime(m.contact);
    if (contact >= Contact.START) {
      // Which end it is, no processor can foretell: its place is computed.
      int end = k + (contact - Contact.START) * LineShape.END;
      int other = 2 * k + LineShape.END - end;
      locateOnEnd(
          m,
          lines[end + LineShape.AX],
          lines[end + LineShape.AY],
          lines[other + LineShape.AX],
          lines[other + LineShape.AY]);
      return;
    }
    double ax = lines[k + LineShape.AX];
    double ay = lines[k + LineShape.AY];
    double bx = lines[k + LineShape.BX];
    double by = lines[k + LineShape.BY];
    if (contact == Contact.LEFT) {
      locateOnSide(m, ax, ay, bx, by, ay, bx, by, ax);
    } else {
      locateOnSide(m, ax, ay, bx, by, by, ax, ay, bx);
    }
  }

  /**
   * An end of a line, the other one being o. A point particle has no offset from it: its normal is
   * the limit from before, that of the side where it came along that.
   */
  private void locateOnEnd(MovingCircle m, double x, double y, double ox, double oy) {
    locateAt(m, x, y, 0);
    if (m.radius == 0 && Predicates.dot(m.vx, m.vy, 0, 0, ox, oy, x, y) < 0) {
      boolean left = Predicates.cross(m.vx, m.vy, 0, 0, ox, oy, x, y) > 0;
      if (left) {
        normal(m, y, ox, oy, x);
      } else {
        normal(m, oy, x, y, ox);
      }
    }
  }

  /**
   * n is p - q, the perpendicular of w = b - a on the centre's side; the contact is its foot, s =
   * (c - a).w / w.w.
   */
  private void locateOnSide(
      MovingCircle m,
      double ax,
      double ay,
      double bx,
      double by,
      double px,
      double py,
      double qx,
      double qy) {
    double wx = bx - ax;
    double wy = by - ay;
    double size = Math.max(Math.abs(wx), Math.abs(wy));
    double s =
        size > LEAST_SAFE && size < MOST_SAFE
            ? ((m.x - ax) * wx + (m.y - ay) * wy) / (wx * wx + wy * wy)
            : Coordinates.fraction(
                ax, ay, bx, by, Coordinates.within(m.x), Coordinates.within(m.y));
    contactX = Coordinates.between(s, ax, bx);
    contactY = Coordinates.between(s, ay, by);
    normal(m, px, py, qx, qy);
  }

  private void locateOnPeg(MovingCircle m, double[] pegs, int k) {
    locateAt(m, pegs[k + PegShape.X], pegs[k + PegShape.Y], pegs[k + PegShape.RADIUS]);
  }

  /**
   * n is the offset from (cx, cy) to the centre; that of two points is the limit from before, -v;
   * where the offset is lost in the rounding of the centre, it is the detector's normal.
   */
  private void locateAt(MovingCircle m, double cx, double cy, double radius) {
    double share = Coordinates.share(radius, m.radius);
    contactX = Coordinates.between(share, cx, Coordinates.within(m.x));
    contactY = Coordinates.between(share, cy, Coordinates.within(m.y));
    double radiusSum = radius + m.radius;
    if (radiusSum == 0) {
      normal(m, 0, 0, m.vx, m.vy);
    } else if (radiusSum < SMALL * Math.max(size(cx, cy), size(startX, startY))) {
      UnitVector n =
          DiskSweep.normal(startX, startY, m.radius, m.vx, m.vy, cx, cy, radius, 0, 0, m.cleared);
      normal(m, n.x(), n.y(), 0, 0);
    } else {
      offset(m, cx, cy);
    }
  }

  private static double size(double x, double y) {
    return Math.max(Math.abs(x), Math.abs(y));
  }

  /**
   * Keeps the offset from (cx, cy) to the true centre: it is smaller than the coordinates, and so
   * has places that the rounded centre lacks. Without them its direction would be wrong by a
   * rounding of the coordinates over the radius, and so would be the new velocity's.
   */
  private void offset(MovingCircle m, double cx, double cy) {
    if (normal(m, m.x, m.y, cx, cy) == 0) {
      nx += MovingCircle.lack(startX, m.vx, m.cleared, m.x);
      ny += MovingCircle.lack(startY, m.vy, m.cleared, m.y);
    }
  }

  /** Keeps the normal p - q; returns by which power of two it was divided. */
  private int normal(MovingCircle m, double px, double py, double qx, double qy) {
    double speed = Math.max(Math.abs(m.vx), Math.abs(m.vy));
    int exponent = exponent(px, py, qx, qy, speed);
    // + 0 turns -0 into 0.
    nx = difference(px, qx, exponent) + 0.0;
    ny = difference(py, qy, exponent) + 0.0;
    return exponent;
  }

  /**
   * By which power of two a normal p - q is to be divided, so that its products with velocities
   * stay within the range of doubles: 0 for ordinary sizes.
   */
  static int exponent(double px, double py, double qx, double qy, double speed) {
    double x = px - qx;
    double y = py - qy;
    double size = Math.max(Math.abs(x), Math.abs(y));
    return size > LEAST_SAFE && size < MOST_SAFE && speed > LEAST_SAFE && speed < MOST_SAFE
        ? 0
        : Math.getExponent(size) + (speed < 1 ? -SLOW : 3); // n below 1/4: |v.n| < 2 |v| / 4
  }

  /** (p - q) / 2^exponent; of what is beyond the range of doubles, the largest one. */
  static double difference(double p, double q, int exponent) {
    if (exponent == 0) {
      return p - q;
    }
    double a = Coordinates.within(p);
    double b = Coordinates.within(q);
    double d = a - b;
    return Math.abs(d) <= Double.MAX_VALUE
        ? Math.scalb(d, -exponent)
        : Math.scalb(a, -exponent) - Math.scalb(b, -exponent);
  }

  /** a.b to within two ulps, whatever cancels (W. Kahan's difference of products). */
  public static double dot(double ax, double ay, double bx, double by) {
    double p = ay * by;
    return Math.fma(ax, bx, p) + Math.fma(ay, by, -p);
  }
}
