// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.UnitVector;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.Offset;
import dev.carom.internal.sweep.PegShape;

/**
 * Where a circle touches an obstacle, and the normal there, of any length and without the radius:
 * the perpendicular of a line for its side, the offset from the contact point to the centre for an
 * endpoint or a peg, a unit vector of an axis for a wall.
 *
 * <p>The caller owns it, calls {@link #startAt} at the start of a flight and {@link #locate} at its
 * end, and then reads the fields.
 */
final class ContactPoint {

  /**
   * An offset that is smaller than so much of a coordinate, or of one where the flight started, may
   * be mere rounding: 2^10 ulps.
   */
  private static final double SMALL = 0x1p-43;

  private final ObstacleTable obstacles;

  /** The contact point. */
  double x;

  double y;

  /** The normal, not of unit length. */
  double nx;

  double ny;

  /** The detector's normal, where that is asked for. */
  private final UnitVector unit = new UnitVector();

  /** The velocity of the obstacle, of one that turns that of its point at the contact. */
  double ux;

  double uy;

  /** Its rate, and where its pivot is; 0 if it does not turn. */
  double rate;

  private double pivotX;
  private double pivotY;

  private double obstacleSpeed;

  /** Where a moving obstacle was when the flight started, and where it is at the contact. */
  private final double[] row = new double[ObstacleTable.MOST_NUMBERS + 1];

  private final double[] there = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** c of an obstacle that turns, see {@link ObstacleMotions}, at the contact. */
  private double c1;

  private double c2;

  /** The rate at which the rate changes. */
  private double faster;

  /** Where and when the flight started that ends here. */
  private double startX;

  private double startY;
  private double startVx;
  private double startVy;
  private double startT;
  private double startTl;

  /** The acceleration in that flight. */
  private double gx;

  private double gy;

  ContactPoint(ObstacleTable obstacles) {
    this.obstacles = obstacles;
  }

  /** Notes where and when a flight starts. */
  void startAt(MovingCircle m) {
    startX = m.x;
    startY = m.y;
    startVx = m.vx;
    startVy = m.vy;
    gx = m.gx;
    gy = m.gy;
    startT = m.t;
    startTl = m.tl;
  }

  /**
   * Finds the contact point and the normal at the end of the flight.
   *
   * @param m a circle that stands where it touches
   * @param code the obstacle that it touches, with the contact that the circle holds
   */
  void locate(MovingCircle m, int code) {
    ux = 0;
    uy = 0;
    rate = 0;
    obstacleSpeed = 0;
    if (Codes.isWall(code)) {
      locateOnWall(m, code);
      return;
    }
    ObstacleRows rows = obstacles.of(code);
    if (obstacles.moves(code)) {
      follow(m, code);
      locateOnMoving(m, code);
      takeVelocity();
      return;
    }
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
      x = wall;
      y = m.y;
    } else {
      nx = 0;
      ny = inwards;
      x = m.x;
      y = wall;
    }
  }

  private void locateOnLine(MovingCircle m, double[] lines, int k) {
    int contact = Contact.withoutTime(m.contact);
    if (contact >= Contact.START) {
      // Which end it is is unpredictable: the index of its coordinates is computed, branch-free.
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
        ScaledVectors.isSafe(size)
            ? ((m.x - ax) * wx + (m.y - ay) * wy) / (wx * wx + wy * wy)
            : Coordinates.fraction(
                ax, ay, bx, by, Coordinates.within(m.x), Coordinates.within(m.y));
    x = Coordinates.between(s, ax, bx);
    y = Coordinates.between(s, ay, by);
    normal(m, px, py, qx, qy);
  }

  /**
   * Follows a moving obstacle to the contact: the detector saw it where it was when the flight
   * started.
   */
  private void follow(MovingCircle m, int code) {
    double t = m.cleared;
    obstacles.place(obstacles.motions().indexOf(code), startT, startTl, row);
    System.arraycopy(row, 0, there, 0, row.length);
    int ends = Codes.isLine(code) ? LineShape.END : 0;
    if (!obstacles.turns(code)) {
      ux = obstacles.ux(code);
      uy = obstacles.uy(code);
      obstacleSpeed = Math.max(Math.abs(ux), Math.abs(uy));
      for (int k = 0; k <= ends; k += LineShape.END) {
        there[k] = fma(ux, t, row[k]);
        there[k + 1] = fma(uy, t, row[k + 1]);
      }
      return;
    }
    pivotX = obstacles.pivotX(code);
    pivotY = obstacles.pivotY(code);
    double q2 = obstacles.turnY(code, startT, startTl);
    double q1 = obstacles.turnX(code, startT, startTl);
    c1 = fma(q1, t, 1);
    c2 = q2 * t;
    rate = 2 * q2 / (c1 * c1 + c2 * c2);
    faster = -2 * rate * (c1 * q1 + c2 * q2) / (c1 * c1 + c2 * c2);
    double reach = Codes.isLine(code) ? 0 : row[PegShape.RADIUS];
    for (int k = 0; k <= ends; k += LineShape.END) {
      ObstacleMotions.turn(pivotX, pivotY, c1, c2, there, k);
      reach += Math.abs(there[k] - pivotX) + Math.abs(there[k + 1] - pivotY);
    }
    obstacleSpeed = Math.abs(rate) * reach;
  }

  /** Of an obstacle that turns: the velocity of the point at the contact. */
  private void takeVelocity() {
    if (rate != 0) {
      ux = -rate * (y - pivotY);
      uy = rate * (x - pivotX);
    }
  }

  /**
   * The second derivative of the gap to what turns, by the turn: {@code -w^2 n.d + 2 w (i n).v - w'
   * n.(i d)} for the unit normal n, the rate w, d from the pivot to the centre and its velocity v.
   * An impact does not change it.
   */
  double bend(MovingCircle m, double length) {
    double dx = m.x - pivotX;
    double dy = m.y - pivotY;
    double sum = -rate * rate * (nx * dx + ny * dy) + 2 * rate * (nx * m.vy - ny * m.vx);
    return (sum - faster * (ny * dx - nx * dy)) / length;
  }

  /** How large that may be, see {@link ContactLaw#bend}. */
  double mostBend(MovingCircle m, double length) {
    double x = nx / length;
    double y = ny / length;
    double dx = m.x - pivotX;
    double dy = m.y - pivotY;
    double across = x * m.vy - y * m.vx;
    return ContactLaw.bend(rate, faster, m.radius, x * dx + y * dy, x * dy - y * dx, across);
  }

  private void locateOnMoving(MovingCircle m, int code) {
    int contact = Contact.withoutTime(m.contact);
    if (contact == Contact.LEFT || contact == Contact.RIGHT) {
      locateOnMovingSide(m, contact == Contact.LEFT);
    } else if (Codes.isLine(code)) {
      int end = contact == Contact.END ? LineShape.END : 0;
      locateOnMovingEnd(m, end, LineShape.END - end);
    } else {
      locateOnMovingDisk(m, 0, row[PegShape.RADIUS]);
    }
  }

  private void locateOnMovingSide(MovingCircle m, boolean left) {
    double fromX = there[LineShape.AX];
    double fromY = there[LineShape.AY];
    double toX = there[LineShape.BX];
    double toY = there[LineShape.BY];
    double[] ends = rate == 0 ? row : there; // the direction of what does not turn is exact
    double ax = ends[LineShape.AX];
    double ay = ends[LineShape.AY];
    double bx = ends[LineShape.BX];
    double by = ends[LineShape.BY];
    if (left) {
      locateOnSide(m, fromX, fromY, toX, toY, ay, bx, by, ax);
    } else {
      locateOnSide(m, fromX, fromY, toX, toY, by, ax, ay, bx);
    }
  }

  /** See {@link #locateOnEnd}; the ends of the line are at k and o in its row. */
  private void locateOnMovingEnd(MovingCircle m, int k, int o) {
    locateOnMovingDisk(m, k, 0);
    double[] ends = rate == 0 ? row : there;
    double cx = ends[k];
    double cy = ends[k + 1];
    double ox = ends[o];
    double oy = ends[o + 1];
    if (m.radius == 0 && Predicates.dot(m.vx, m.vy, ux, uy, ox, oy, cx, cy) < 0) {
      boolean left = Predicates.cross(m.vx, m.vy, ux, uy, ox, oy, cx, cy) > 0;
      if (left) {
        normal(m, cy, ox, oy, cx);
      } else {
        normal(m, oy, cx, cy, ox);
      }
    }
  }

  /**
   * On a disk whose centre is at k in the row. The normal is the detector's, not of unit length
   * unless it takes exact numbers.
   */
  private void locateOnMovingDisk(MovingCircle m, int k, double radius) {
    double t = m.cleared;
    double cx = row[k];
    double cy = row[k + 1];
    double share = Coordinates.share(radius, m.radius);
    x = Coordinates.between(share, there[k], Coordinates.within(m.x));
    y = Coordinates.between(share, there[k + 1], Coordinates.within(m.y));
    if (gx != 0 || gy != 0 || rate != 0) {
      takeVelocity();
      locateFallen(m, cx, cy, radius);
      return;
    }
    double c =
        t == 0
            ? 0
            : DiskSweep.correction(startX, startY, m.radius, m.vx, m.vy, cx, cy, radius, ux, uy, t);
    if (!Double.isNaN(c)) {
      double offsetX = DiskSweep.offset(startX, cx, m.vx, ux, t, c);
      double offsetY = DiskSweep.offset(startY, cy, m.vy, uy, t, c);
      normal(m, offsetX, offsetY, 0, 0);
    } else {
      DiskSweep.normal(unit, startX, startY, m.radius, m.vx, m.vy, cx, cy, radius, ux, uy, t);
      normal(m, unit.x(), unit.y(), 0, 0);
    }
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
    x = Coordinates.between(share, cx, Coordinates.within(m.x));
    y = Coordinates.between(share, cy, Coordinates.within(m.y));
    double radiusSum = radius + m.radius;
    if (radiusSum == 0) {
      normal(m, 0, 0, m.vx, m.vy);
    } else if (gx != 0 || gy != 0) {
      locateFallen(m, cx, cy, radius);
    } else if (radiusSum < SMALL * Math.max(size(cx, cy), size(startX, startY))) {
      DiskSweep.normal(unit, startX, startY, m.radius, m.vx, m.vy, cx, cy, radius, 0, 0, m.cleared);
      normal(m, unit.x(), unit.y(), 0, 0);
    } else {
      offset(m, cx, cy);
    }
  }

  /**
   * The normal on something round of a circle that fell: the offset with the places that the
   * rounded centre lacks; where the offset is lost in the rounding of coordinates, the detector's.
   */
  private void locateFallen(MovingCircle m, double cx, double cy, double radius) {
    double t = m.cleared;
    double size = size(cx, cy) + size(startX, startY);
    boolean turns = rate != 0;
    UnitVector exact =
        radius + m.radius < SMALL * size && !turns
            ? FallSweep.normal(
                Fall.ofThread()
                    .flight(startX, startY, m.radius, startVx, startVy, gx, gy)
                    .disk(cx, cy, radius, ux, uy),
                t)
            : null;
    if (exact != null) {
      normal(m, exact.x(), exact.y(), 0, 0);
      return;
    }
    double offsetX = Offset.at(startX, cx, startVx, turns ? 0 : ux, gx, t);
    double offsetY = Offset.at(startY, cy, startVy, turns ? 0 : uy, gy, t);
    if (turns) { // the centre goes 2 Im(c) / |c|^2 i c w from the pivot, as in ObstacleMotions.turn
      offsetX += rate * t * (c2 * (cx - pivotX) + c1 * (cy - pivotY));
      offsetY -= rate * t * (c1 * (cx - pivotX) - c2 * (cy - pivotY));
    }
    if (offsetX == 0 && offsetY == 0) { // underflow of t times the mean velocity
      offsetX = Offset.mean(startVx, ux, gx, t);
      offsetY = Offset.mean(startVy, uy, gy, t);
    }
    normal(m, offsetX, offsetY, 0, 0);
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
    double speed = Math.max(Math.abs(m.vx), Math.abs(m.vy)) + obstacleSpeed;
    int exponent = ScaledVectors.exponent(px, py, qx, qy, speed);
    // + 0 turns -0 into 0.
    nx = ScaledVectors.difference(px, qx, exponent) + 0.0;
    ny = ScaledVectors.difference(py, qy, exponent) + 0.0;
    return exponent;
  }
}
