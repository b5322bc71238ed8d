// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.RealRoot;
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

  /** The hit on a line or a disk, from a contact and a time of {@link FallSweep}. */
  public Hit of(Fall f, int contact, double t) {
    int part = Contact.withoutTime(contact);
    if (!f.isSegment) {
      setNormal(f, f.ax, f.ay, t);
      boolean isNow = f.isStraight() ? contact == Contact.NOW : t == 0;
      return isNow ? betweenCentres(f) : atEnd(f, f.ax, f.ay, t);
    }
    if (part == Contact.START) {
      setNormal(f, f.ax, f.ay, t);
      return atEnd(f, f.ax, f.ay, t);
    }
    if (part == Contact.END) {
      setNormal(f, f.bx, f.by, t);
      return atEnd(f, f.bx, f.by, t);
    }
    normalOfSide(n, f, part == Contact.LEFT ? 1 : -1, t);
    double startX = Coordinates.within(f.placeX(f.ax, f.ay, t));
    double startY = Coordinates.within(f.placeY(f.ax, f.ay, t));
    double endX = Coordinates.within(f.placeX(f.bx, f.by, t));
    double endY = Coordinates.within(f.placeY(f.bx, f.by, t));
    double centreX = place(f.px, f.vx, f.gx, t);
    double centreY = place(f.py, f.vy, f.gy, t);
    double s = Coordinates.fraction(startX, startY, endX, endY, centreX, centreY);
    double atX = Coordinates.onSegment(s, startX, endX);
    return of(f, t, atX, Coordinates.onSegment(s, startY, endY));
  }

  /** The point of two disks in contact at the start, in the ratio of the radii. */
  private Hit betweenCentres(Fall f) {
    double share = Coordinates.share(f.radius, f.r);
    double atX = Coordinates.between(share, f.ax, f.px);
    return of(f, 0, atX, Coordinates.between(share, f.ay, f.py));
  }

  /** The point of an end q, or of a disk around it. */
  private Hit atEnd(Fall f, double qx, double qy, double t) {
    double atX = Coordinates.within(f.placeX(qx, qy, t));
    double atY = Coordinates.within(f.placeY(qx, qy, t));
    return f.isSegment
        ? of(f, t, atX, atY)
        : of(
            f,
            t,
            Coordinates.within(fma(f.radius, n.x(), atX)),
            Coordinates.within(fma(f.radius, n.y(), atY)));
  }

  /** Sets the normal of a hit on an end q of a line, or on a disk there. */
  private void setNormal(Fall f, double qx, double qy, double t) {
    if (!f.isStraight()) {
      UnitVector unit = FallSweep.normal(f, qx, qy, t);
      n.set(unit != null ? unit : exactNormal(f, t));
      return;
    }
    double ox = qx == f.ax && qy == f.ay ? f.bx : f.ax;
    double oy = qx == f.ax && qy == f.ay ? f.by : f.ay;
    if (f.isLine && f.r == 0 && Predicates.dot(f.vx, f.vy, f.ux, f.uy, ox, oy, qx, qy) < 0) {
      // A point that comes along the side: the limit of the normals for radii that go to 0.
      int drift = Predicates.cross(ox, oy, qx, qy, f.vx, f.vy, f.ux, f.uy);
      UnitVectors.normal(n, -drift, qx, qy, ox, oy);
    } else {
      DiskSweep.normal(n, f.px, f.py, f.r, f.vx, f.vy, qx, qy, f.radius, f.ux, f.uy, t);
    }
  }

  /**
   * The normal in algebraic numbers. A point that comes to an end of a line from beside that has
   * the normal of the side.
   */
  private static UnitVector exactNormal(Fall f, double time) {
    PrecisionCounter.EXACT_NORMALS.add();
    ExactParabola exact = FallSweep.exact(f);
    RealRoot t = exact.at(time);
    return f.isLine && f.r == 0 && exact.comesFromSide(t)
        ? normalOfSide(new UnitVector(), f, exact.side(t), time)
        : exact.normal(t);
  }

  private static UnitVector normalOfSide(UnitVector out, Fall f, int side, double t) {
    return f.turns()
        ? f.turningRoot().ofSide(out, side, t)
        : UnitVectors.normal(out, side, f.ax, f.ay, f.bx, f.by);
  }

  /** The hit on the wall with a given code, at the given coordinate, of the disk of a flight. */
  public Hit ofWall(Fall f, int code, double wall, double t) {
    boolean isVertical = code <= WallSweep.RIGHT;
    int inward = ParabolaWallSweep.inward(code);
    double speed = isVertical ? speed(f.vx, f.gx, t) : speed(f.vy, f.gy, t);
    approachSpeed = Math.max(0, -inward * speed);
    n.set(isVertical ? inward : 0, isVertical ? 0 : inward);
    x = isVertical ? wall : place(f.px, f.vx, f.gx, t);
    y = isVertical ? place(f.py, f.vy, f.gy, t) : wall;
    return this;
  }

  /** Sets a point; the speed is that along the normal at which the distance falls. */
  private Hit of(Fall f, double t, double atX, double atY) {
    double vx = speed(f.vx, f.gx, t);
    double vy = speed(f.vy, f.gy, t);
    double ux = f.velocityX(atY, t);
    double uy = f.velocityY(atX, t);
    double speed = -((vx - ux) * n.x() + (vy - uy) * n.y());
    if (!(Math.abs(speed) <= Double.MAX_VALUE)) {
      speed = 4 * -((vx / 4 - ux / 4) * n.x() + (vy / 4 - uy / 4) * n.y());
    }
    x = atX;
    y = atY;
    approachSpeed = Math.max(0, speed);
    return this;
  }

  private static double place(double p, double v, double g, double t) {
    return Coordinates.within(fma(g == 0 ? v : fma(0.5 * g, t, v), t, p));
  }

  private static double speed(double v, double g, double t) {
    return g == 0 ? v : Coordinates.within(fma(g, t, v));
  }
}
