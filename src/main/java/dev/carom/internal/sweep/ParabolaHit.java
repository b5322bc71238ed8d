// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.PrecisionCounters;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.exact.UnitVector;

/** The {@link Hit} of a disk with a constant acceleration. The time is that of its sweep. */
public final class ParabolaHit {

  private ParabolaHit() {}

  /**
   * The hit on a line that moves with the velocity u, from a contact and a time of {@link
   * ParabolaSegmentSweep}.
   */
  public static Hit ofLine(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, int contact, double t) {
    int part = Contact.withoutTime(contact);
    double speedX = velocity(vx, gx, t);
    double speedY = velocity(vy, gy, t);
    double startX = place(ax, ux, 0, t);
    double startY = place(ay, uy, 0, t);
    double endX = place(bx, ux, 0, t);
    double endY = place(by, uy, 0, t);
    if (part == Contact.LEFT || part == Contact.RIGHT) {
      UnitVector n = UnitVectors.normal(part == Contact.LEFT ? 1 : -1, ax, ay, bx, by);
      double x = place(px, vx, gx, t);
      double y = place(py, vy, gy, t);
      double s = Coordinates.fraction(startX, startY, endX, endY, x, y);
      double atX = Coordinates.onSegment(s, startX, endX);
      double atY = Coordinates.onSegment(s, startY, endY);
      return new Hit().of(atX, atY, n, speedX, speedY, ux, uy);
    }
    boolean end = part == Contact.END;
    double qx = end ? bx : ax;
    double qy = end ? by : ay;
    UnitVector n = ParabolaDiskSweep.normal(px, py, r, vx, vy, gx, gy, qx, qy, 0, ux, uy, t);
    if (n == null) {
      n = exactNormal(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
    }
    return new Hit().of(end ? endX : startX, end ? endY : startY, n, speedX, speedY, ux, uy);
  }

  /**
   * The normal at an end of a line. A point that comes to it from beside the line has the normal of
   * the side.
   */
  private static UnitVector exactNormal(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double time) {
    PrecisionCounters.exactNormal();
    ExactParabola exact = ExactParabola.line(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy);
    RealRoot t = exact.at(time);
    return r == 0 && exact.comesFromSide(t)
        ? UnitVectors.normal(exact.side(t), ax, ay, bx, by)
        : exact.normal(t);
  }

  /** The hit on the wall with a given code, at the given coordinate. */
  public static Hit ofWall(
      double px, double py, double vx, double vy, double gx, double gy, int code, double wall,
      double t) {
    boolean vertical = code <= WallSweep.RIGHT;
    int inward = ParabolaWallSweep.inward(code);
    double speed = vertical ? velocity(vx, gx, t) : velocity(vy, gy, t);
    double approach = Math.max(0, -inward * speed);
    return vertical
        ? new Hit().of(wall, place(py, vy, gy, t), inward, 0, approach)
        : new Hit().of(place(px, vx, gx, t), wall, 0, inward, approach);
  }

  /** The hit on a disk that moves straight on, from a time of {@link ParabolaDiskSweep}. */
  public static Hit ofDisks(
      double x1, double y1, double r1, double vx1, double vy1, double gx, double gy, double x2,
      double y2, double r2, double vx2, double vy2, double t) {
    UnitVector n = ParabolaDiskSweep.normal(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2, t);
    if (n == null) {
      PrecisionCounters.exactNormal();
      ExactParabola exact =
          ExactParabola.disk(x1, y1, r1, vx1, vy1, gx, gy, x2, y2, r2, vx2, vy2);
      n = exact.normal(exact.at(t));
    }
    double ux = velocity(vx1, gx, t);
    double uy = velocity(vy1, gy, t);
    if (t == 0) { // in the ratio of the radii
      double share = Coordinates.share(r2, r1);
      double x = Coordinates.between(share, x2, x1);
      double y = Coordinates.between(share, y2, y1);
      return new Hit().of(x, y, n, ux, uy, vx2, vy2);
    }
    double x = Coordinates.within(fma(r2, n.x(), place(x2, vx2, 0, t)));
    double y = Coordinates.within(fma(r2, n.y(), place(y2, vy2, 0, t)));
    return new Hit().of(x, y, n, ux, uy, vx2, vy2);
  }

  private static double place(double p, double v, double g, double t) {
    return Coordinates.within(fma(fma(0.5 * g, t, v), t, p));
  }

  private static double velocity(double v, double g, double t) {
    return Coordinates.within(fma(g, t, v));
  }
}
