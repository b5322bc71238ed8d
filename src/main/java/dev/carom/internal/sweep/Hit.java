// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.UnitVector;

/**
 * The contact point, the normal and the approach speed where a moving disk meets a line, a wall or
 * a disk. The detector has found the contact code and the time. A hit can be set anew, so that many
 * are computed without allocation.
 */
public final class Hit {

  private double x;
  private double y;
  private double approachSpeed;
  private final UnitVector n = new UnitVector();

  /** The x coordinate of the contact point; the largest double if it is beyond the range. */
  public double x() {
    return x;
  }

  /** The y coordinate of the contact point. */
  public double y() {
    return y;
  }

  /** The x component of the unit normal, which points to the disk. */
  public double nx() {
    return n.x();
  }

  /** The y component of the unit normal. */
  public double ny() {
    return n.y();
  }

  /** The speed along the normal at which the distance falls; it may be infinite. */
  public double approachSpeed() {
    return approachSpeed;
  }

  /** The same hit with the contact point elsewhere. */
  public Hit moved(double dx, double dy) {
    x = Coordinates.within(x + dx);
    y = Coordinates.within(y + dy);
    return this;
  }

  /** The hit on a line that moves with the velocity u, from a contact and a time. */
  public Hit ofLine(
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
  private Hit ofEnd(
      double px, double py, double r, double vx, double vy, double x, double y, double ox,
      double oy, double ux, double uy, double t) {
    if (r == 0 && slides(vx, vy, x, y, ox, oy, ux, uy)) {
      setSlideNormal(vx, vy, x, y, ox, oy, ux, uy);
    } else {
      DiskSweep.normal(n, px, py, r, vx, vy, x, y, 0, ux, uy, t);
    }
    return of(place(x, ux, t), place(y, uy, t), vx, vy, ux, uy);
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
  private void setSlideNormal(
      double vx, double vy, double x, double y, double ox, double oy, double ux, double uy) {
    int drift = Predicates.cross(ox, oy, x, y, vx, vy, ux, uy);
    UnitVectors.normal(n, -drift, x, y, ox, oy);
  }

  private Hit ofSide(
      int side, double px, double py, double vx, double vy, double ax, double ay, double bx,
      double by, double ux, double uy, double t) {
    UnitVectors.normal(n, side, ax, ay, bx, by);
    double startX = place(ax, ux, t);
    double startY = place(ay, uy, t);
    double endX = place(bx, ux, t);
    double endY = place(by, uy, t);
    double s =
        Coordinates.fraction(startX, startY, endX, endY, place(px, vx, t), place(py, vy, t));
    double x = Coordinates.onSegment(s, startX, endX);
    double y = Coordinates.onSegment(s, startY, endY);
    return of(x, y, vx, vy, ux, uy);
  }

  /** The hit on the wall with a given code, at the given coordinate. */
  public Hit ofWall(
      double px, double py, double vx, double vy, int code, double wall, double t) {
    if (code <= WallSweep.RIGHT) {
      n.set(vx < 0 ? 1 : -1, 0);
      return of(wall, place(py, vy, t), Math.abs(vx));
    }
    n.set(0, vy < 0 ? 1 : -1);
    return of(place(px, vx, t), wall, Math.abs(vy));
  }

  /** The hit of disk 1 on disk 2, from a contact and a time of {@link DiskSweep}. */
  public Hit ofDisks(
      double x1, double y1, double r1, double vx1, double vy1, double x2, double y2, double r2,
      double vx2, double vy2, int contact, double t) {
    DiskSweep.normal(n, x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, t);
    double x;
    double y;
    if (contact == Contact.NOW) { // in the ratio of the radii
      double share = Coordinates.share(r2, r1);
      x = Coordinates.between(share, x2, x1);
      y = Coordinates.between(share, y2, y1);
    } else {
      x = Coordinates.within(fma(r2, n.x(), place(x2, vx2, t)));
      y = Coordinates.within(fma(r2, n.y(), place(y2, vy2, t)));
    }
    return of(x, y, vx1, vy1, vx2, vy2);
  }

  /** Sets a hit with a normal; disk 1 has the velocity v1, what it hits v2. */
  Hit of(
      double atX, double atY, UnitVector normal, double vx1, double vy1, double vx2, double vy2) {
    n.set(normal);
    return of(atX, atY, vx1, vy1, vx2, vy2);
  }

  /** Sets a hit. */
  Hit of(double atX, double atY, double nx, double ny, double speed) {
    n.set(nx, ny);
    return of(atX, atY, speed);
  }

  private Hit of(
      double atX, double atY, double vx1, double vy1, double vx2, double vy2) {
    return of(atX, atY, approach(vx1, vy1, vx2, vy2, n));
  }

  private Hit of(double atX, double atY, double speed) {
    x = atX;
    y = atY;
    approachSpeed = speed;
    return this;
  }

  private static double place(double p, double v, double t) {
    return Coordinates.within(fma(v, t, p));
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
