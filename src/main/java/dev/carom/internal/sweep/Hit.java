// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.UnitVector;

/**
 * The contact point, the normal and the approach speed where a moving disk meets a line, a wall or
 * a disk. The detector has found the contact code and the time.
 *
 * @param x the x coordinate of the contact point; the largest double if it is beyond the range
 * @param y its y coordinate
 * @param nx the x component of the unit normal, which points to the disk
 * @param ny its y component
 * @param approachSpeed the speed along the normal at which the distance falls; it may be infinite
 */
public record Hit(double x, double y, double nx, double ny, double approachSpeed) {

  /** The hit on a line at rest, from a contact and a time of {@link SegmentSweep}. */
  public static Hit ofLine(
      double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
      double by, int contact, double t) {
    return ofLine(px, py, r, vx, vy, ax, ay, bx, by, 0, 0, contact, t);
  }

  /** The hit on a line that moves with the velocity u. */
  public static Hit ofLine(
      double px, double py, double r, double vx, double vy, double ax, double ay, double bx,
      double by, double ux, double uy, int contact, double t) {
    return switch (contact & ~Contact.NOW) {
      case Contact.START -> ofEnd(px, py, r, vx, vy, ax, ay, bx, by, ux, uy, t);
      case Contact.END -> ofEnd(px, py, r, vx, vy, bx, by, ax, ay, ux, uy, t);
      case Contact.LEFT -> ofSide(1, px, py, vx, vy, ax, ay, bx, by, ux, uy, t);
      default -> ofSide(-1, px, py, vx, vy, ax, ay, bx, by, ux, uy, t);
    };
  }

  /** The hit on the endpoint (x, y) of a line whose other endpoint is o. */
  private static Hit ofEnd(
      double px, double py, double r, double vx, double vy, double x, double y, double ox,
      double oy, double ux, double uy, double t) {
    UnitVector n =
        r == 0 && t > 0 && slides(vx, vy, x, y, ox, oy, ux, uy)
            ? slideNormal(vx, vy, x, y, ox, oy, ux, uy)
            : DiskSweep.normal(px, py, r, vx, vy, x, y, 0, ux, uy, t);
    return of(place(x, ux, t), place(y, uy, t), n, vx, vy, ux, uy);
  }

  /**
   * Whether a point particle reaches an endpoint along the line's side, not from beyond the end.
   */
  private static boolean slides(
      double vx, double vy, double x, double y, double ox, double oy, double ux, double uy) {
    return Predicates.dot(vx, vy, ux, uy, ox, oy, x, y) < 0;
  }

  /**
   * The normal of the side, against the velocity: the limit of the normals for radii that go to 0.
   */
  private static UnitVector slideNormal(
      double vx, double vy, double x, double y, double ox, double oy, double ux, double uy) {
    int drift = Predicates.cross(ox, oy, x, y, vx, vy, ux, uy);
    return UnitVectors.normal(-drift, x, y, ox, oy);
  }

  private static Hit ofSide(
      int side, double px, double py, double vx, double vy, double ax, double ay, double bx,
      double by, double ux, double uy, double t) {
    UnitVector n = UnitVectors.normal(side, ax, ay, bx, by);
    double startX = place(ax, ux, t);
    double startY = place(ay, uy, t);
    double endX = place(bx, ux, t);
    double endY = place(by, uy, t);
    double s =
        Coordinates.fraction(startX, startY, endX, endY, place(px, vx, t), place(py, vy, t));
    double x = Coordinates.onSegment(s, startX, endX);
    double y = Coordinates.onSegment(s, startY, endY);
    return of(x, y, n, vx, vy, ux, uy);
  }

  /** The hit on the wall with a given code, at the given coordinate. */
  public static Hit ofWall(
      double px, double py, double vx, double vy, int code, double wall, double t) {
    if (code <= WallSweep.RIGHT) {
      return new Hit(wall, place(py, vy, t), vx < 0 ? 1 : -1, 0, Math.abs(vx));
    }
    return new Hit(place(px, vx, t), wall, 0, vy < 0 ? 1 : -1, Math.abs(vy));
  }

  /** The hit of disk 1 on disk 2, from a contact and a time of {@link DiskSweep}. */
  public static Hit ofDisks(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, int contact, double t) {
    UnitVector n = DiskSweep.normal(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, t);
    double x;
    double y;
    if (contact == Contact.NOW) { // in the ratio of the radii
      double share = Coordinates.share(r2, r1);
      x = Coordinates.between(share, x2, x1);
      y = Coordinates.between(share, y2, y1);
    } else {
      x = Coordinates.within(Math.fma(r2, n.x(), place(x2, vx2, t)));
      y = Coordinates.within(Math.fma(r2, n.y(), place(y2, vy2, t)));
    }
    return of(x, y, n, vx1, vy1, vx2, vy2);
  }

  static Hit of(
      double x, double y, UnitVector n, double vx1, double vy1, double vx2, double vy2) {
    return new Hit(x, y, n.x(), n.y(), approach(vx1, vy1, vx2, vy2, n));
  }

  private static double place(double p, double v, double t) {
    return Coordinates.within(Math.fma(v, t, p));
  }

  /** The speed along the normal at which the distance falls: -(v1 - v2).n; it may be infinite. */
  private static double approach(
      double vx1, double vy1, double vx2, double vy2, UnitVector n) {
    double speed = -((vx1 - vx2) * n.x() + (vy1 - vy2) * n.y());
    if (!(Math.abs(speed) <= Double.MAX_VALUE)) {
      double ux = vx1 / 4 - vx2 / 4;
      double uy = vy1 / 4 - vy2 / 4;
      speed = 4 * -(ux * n.x() + uy * n.y());
    }
    return Math.max(0, speed);
  }
}
