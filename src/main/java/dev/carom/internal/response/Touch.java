// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.UnitVector;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.UnitVectors;

/**
 * A contact of a stuck circle with an obstacle or another circle: overlapping, or no further apart
 * than {@linkplain StuckRule#INELASTIC_PLACE one place} or 64 ulps of the coordinates.
 *
 * @param code the code of the obstacle or circle, see {@link Codes}
 * @param contact the detector's name of the contact, see {@link Contact}; 0 unless it is with a
 *     line
 * @param nx the x component of the unit normal, which points to the circle
 * @param ny the y component of the unit normal
 */
record Touch(int code, int contact, double nx, double ny) {

  /** The distance at which things touch, relative to their coordinates: 64 ulps. */
  private static final double TOUCH = 0x1p-46;

  /** The contact of a circle with another one, null if they do not touch; two points never do. */
  static Touch of(MovingCircle m, MovingCircle other) {
    double most = tolerance(m, Math.max(size(m), size(other)));
    double radiusSum = m.radius + other.radius;
    return radiusSum == 0
        ? null
        : offset(m, Codes.circle(other.id), 0, other.x, other.y, radiusSum, most);
  }

  /** The contact of a circle with an obstacle, null if it does not touch it. */
  static Touch of(MovingCircle m, ObstacleTable obstacles, int code) {
    double most = tolerance(m, size(m));
    if (Codes.isWall(code)) {
      return ofWall(m, code, obstacles.walls[code], most);
    }
    ObstacleRows rows = obstacles.of(code);
    boolean oneWay = obstacles.isOneWay(code);
    return obstacles.moves(code)
        ? ofRow(m, code, rows.shape, obstacles.rowAt(code, m.t, m.tl), 0, oneWay, most)
        : ofRow(m, code, rows.shape, rows.values, rows.offset(code), oneWay, most);
  }

  /** Whether a moving obstacle that crushed a circle is still upon it. */
  static boolean isCrushed(MovingCircle m, ObstacleTable obstacles) {
    if (m.jam == null) {
      return false;
    }
    for (int entry : m.jam.entries()) {
      int code = IgnoreList.code(entry);
      if (IgnoreList.crushes(entry) && !Codes.isCircle(code) && of(m, obstacles, code) != null) {
        return true;
      }
    }
    return false;
  }

  private static Touch ofWall(MovingCircle m, int code, double wall, double most) {
    boolean vertical = Codes.isVertical(code);
    int inwards = Codes.inwards(code);
    double gap = inwards * ((vertical ? m.x : m.y) - wall) - m.radius;
    return gap <= most ? new Touch(code, 0, vertical ? inwards : 0, vertical ? 0 : inwards) : null;
  }

  /** The contact with the spine's start or end, or with the side between. */
  private static Touch ofRow(
      MovingCircle m,
      int code,
      ObstacleShape shape,
      double[] values,
      int k,
      boolean oneWay,
      double most) {
    double radiusSum = m.radius + shape.radius(values, k);
    double ax = values[k + ObstacleShape.X];
    double ay = values[k + ObstacleShape.Y];
    if (shape.toEnd == 0) {
      return offset(m, code, 0, ax, ay, radiusSum, most);
    }
    double bx = values[k + shape.toEnd + ObstacleShape.X];
    double by = values[k + shape.toEnd + ObstacleShape.Y];
    int side = Predicates.cross(bx, by, ax, ay, m.x, m.y, ax, ay);
    if (oneWay && side <= 0) {
      return null;
    }
    double s = ax == bx && ay == by ? 0 : Coordinates.fraction(ax, ay, bx, by, m.x, m.y);
    if (s <= 0) {
      return offset(m, code, Contact.START, ax, ay, radiusSum, most);
    }
    if (s >= 1) {
      return offset(m, code, Contact.END, bx, by, radiusSum, most);
    }
    double x = m.x - Coordinates.between(s, ax, bx);
    double y = m.y - Coordinates.between(s, ay, by);
    if (side == 0 || StrictMath.hypot(x, y) - radiusSum > most) {
      return null;
    }
    UnitVector n = UnitVectors.normal(side, ax, ay, bx, by);
    return new Touch(code, side > 0 ? Contact.LEFT : Contact.RIGHT, n.x(), n.y());
  }

  /**
   * The contact with a disk or a point; null for a circle exactly on its centre, which cannot come
   * nearer.
   */
  private static Touch offset(
      MovingCircle m, int code, int contact, double cx, double cy, double radiusSum, double most) {
    double x = m.x - cx;
    double y = m.y - cy;
    double distance = StrictMath.hypot(x, y);
    return distance > 0 && distance - radiusSum <= most
        ? new Touch(code, contact, x / distance, y / distance)
        : null;
  }

  private static double tolerance(MovingCircle m, double size) {
    return Math.max(TOUCH * size, StuckRule.INELASTIC_PLACE * m.radius);
  }

  private static double size(MovingCircle m) {
    return Math.max(Math.max(Math.abs(m.x), Math.abs(m.y)), m.radius);
  }
}
