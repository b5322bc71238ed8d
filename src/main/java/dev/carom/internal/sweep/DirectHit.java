// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

/**
 * The first hit of a disk with a constant acceleration on a line, where a normal shows that none
 * comes before it. Nearly all questions of a search are answered here.
 *
 * <p>A line is convex, so it lies behind the tangent at a contact, which is perpendicular to the
 * normal n. At a time s before the time t of the contact, the disk was in front of the tangent if
 * {@code n.(p(s) - p(t))} is above 0. With the velocity v at the start, seen from the line, this is
 * {@code (s - t) n.(v + g (s + t) / 2)}, and the last factor is linear in s. So it suffices that
 * this factor is below 0 at {@code s = t}, where it is the speed of approach, and at {@code s = 0}.
 *
 * <p>The time of the contact is first found in plain doubles. The signs are shown to hold at all
 * times within {@link GapRoot#MARGIN} of that, so they hold at the true time. Then the time is
 * corrected in double-double. A disk that seems to touch nothing in time is shown to stay in front
 * of a tangent.
 */
final class DirectHit {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * The error of a product of a place and a speed, in units of its terms, if the time errs by
   * {@link GapRoot#MARGIN} of itself. In units of the margin, a place errs by twice its terms and a
   * speed by its terms. Rounding is far less.
   */
  private static final double ROUGH_BOUND = 4 * GapRoot.MARGIN;

  /** In units of the terms of a distance from a tangent: far more than its rounding. */
  private static final double ROUNDING = 0x1p-40;

  /** Underflow of fewer than 64 operations, times two factors of at most {@link #MOST}. */
  private static final double TINY = 0x1p-600;

  private static final double MOST = 0x1p150;

  /** Above this, the square of a normal has lost nothing to underflow. */
  private static final double LEAST_SQUARE = 0x1p-300;

  private DirectHit() {}

  /**
   * The correctly rounded time, {@code +infinity} if it is above T; NaN where this does not tell.
   *
   * @param about a time near which the hit is expected; infinite or NaN for none
   */
  static double time(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double about, double T) {
    double wx = bx - ax;
    double wy = by - ay;
    double dx = px - ax;
    double dy = py - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    double t = about < NEVER ? about : entry(dx, dy, r, sx, sy, gx, gy, wx, wy);
    // Straight on with the place and the velocity of that time, would the disk touch the start of
    // the line, its end, or the side between them? Products x |x| are squares that keep the sign.
    double x = place(dx, sx, gx, t);
    double y = place(dy, sy, gy, t);
    double speedX = sx + gx * t;
    double speedY = sy + gy * t;
    double start = x * speedY - y * speedX;
    double end = (x - wx) * speedY - (y - wy) * speedX;
    double along = r * (wx * speedX + wy * speedY);
    double scale = Math.copySign(wx * wx + wy * wy, wy * speedX - wx * speedY);
    double square = along * Math.abs(along);
    boolean isStart = scale * (start * Math.abs(start)) + square > 0;
    boolean isEnd = scale * (end * Math.abs(end)) + square < 0;
    if (!isStart && !isEnd) {
      return atSide(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, T);
    }
    double qx = isStart ? ax : bx;
    double qy = isStart ? ay : by;
    double ex = isStart ? wx : -wx;
    double ey = isStart ? wy : -wy;
    return atEnd(px, py, r, vx, vy, gx, gy, qx, qy, 0, ex, ey, ux, uy, t, T);
  }

  /** The same for a disk (x2, y2, r2) that moves with the velocity u. */
  static double ofDisk(
      double px, double py, double r, double vx, double vy, double gx, double gy, double x2,
      double y2, double r2, double ux, double uy, double T) {
    double rough = touch(px - x2, py - y2, r + r2, vx - ux, vy - uy, gx, gy, 0);
    double about = rough > 0 ? rough : 0;
    return atEnd(px, py, r, vx, vy, gx, gy, x2, y2, r2, 0, 0, ux, uy, about, T);
  }

  /** The time of a hit on the side. */
  private static double atSide(
      double px, double py, double r, double vx, double vy, double gx, double gy, double ax,
      double ay, double bx, double by, double ux, double uy, double T) {
    double wx = bx - ax;
    double wy = by - ay;
    double dx = px - ax;
    double dy = py - ay;
    double sx = vx - ux;
    double sy = vy - uy;
    double t = entry(dx, dy, r, sx, sy, gx, gy, wx, wy);
    if (!(t < T)) {
      return unlessMissed(T, dx, dy, r, sx, sy, gx, gy, wx, wy, T);
    }
    double side = Math.copySign(1, wx * dy - wy * dx);
    double nx = -side * wy;
    double ny = side * wx;
    if (!ParabolaSegmentSweep.isInRange(r, wx, wy)
        || !isInFront(nx, ny, dx, dy, sx, sy, gx, gy, t)
        || !isApproach(nx, ny, Math.abs(nx), Math.abs(ny), sx, sy, gx, gy, t)) {
      return GapRoot.DOUBT;
    }
    double root =
        ParabolaSegmentSweep.nearest(px, py, r, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, t);
    double time = GapRoot.beside(t, root);
    int region = LineRegion.at(px, py, vx, vy, gx, gy, ax, ay, bx, by, ux, uy, time);
    return region == LineRegion.BESIDE ? GapRoot.upTo(T, time) : GapRoot.DOUBT;
  }

  /**
   * About when the centre enters the strip along the line; 0 if it starts there, NaN if it seems
   * not to enter it.
   */
  private static double entry(
      double dx, double dy, double r, double sx, double sy, double gx, double gy, double wx,
      double wy) {
    double h0 = wx * dy - wy * dx;
    double side = Math.copySign(1, h0);
    double gap = Math.abs(h0) - r * Math.sqrt(wx * wx + wy * wy);
    if (gap <= 0) {
      return 0;
    }
    double fall = side * (wx * sy - wy * sx);
    double bend = 0.5 * side * (wx * gy - wy * gx);
    double root = Math.sqrt(fall * fall - 4 * gap * bend);
    if (fall < 0) {
      return 2 * gap / (root - fall);
    }
    return bend < 0 ? (fall + root) / (-2 * bend) : Double.NaN;
  }

  /**
   * Whether a centre is certain to be in front of a point at about the time t, as seen along a
   * normal.
   *
   * @param nx the normal
   * @param dx the offset from the point at the start
   */
  private static boolean isInFront(
      double nx, double ny, double dx, double dy, double sx, double sy, double gx, double gy,
      double t) {
    double height = nx * place(dx, sx, gx, t) + ny * place(dy, sy, gy, t);
    double sizeX = Math.abs(nx);
    double sizeY = Math.abs(ny);
    double terms = sizeX * Offset.size(dx, sx, gx, t) + sizeY * Offset.size(dy, sy, gy, t);
    return height > fma(ROUGH_BOUND, terms, TINY) && t < MOST && sizeX + sizeY < MOST;
  }

  /**
   * Whether a centre is certain to move against a normal n, both at about the time t and in the
   * mean up to it. Then it was in front of the tangent all the way from the start.
   *
   * @param sizeX the terms of nx
   */
  private static boolean isApproach(
      double nx, double ny, double sizeX, double sizeY, double sx, double sy, double gx, double gy,
      double t) {
    double mean = nx * (sx + 0.5 * gx * t) + ny * (sy + 0.5 * gy * t);
    double last = nx * (sx + gx * t) + ny * (sy + gy * t);
    double speedX = Math.abs(sx) + Math.abs(gx) * t;
    double speedY = Math.abs(sy) + Math.abs(gy) * t;
    double bound = fma(ROUGH_BOUND, sizeX * speedX + sizeY * speedY, TINY);
    return mean < -bound && last < -bound && t > 0 && t < MOST && speedX + speedY < MOST;
  }

  /**
   * The time of a hit on an end q of a line, or on a disk there.
   *
   * @param r2 the radius of the disk
   * @param ex the way from there to the other end; 0 of a disk
   * @param about a time near which it is expected
   */
  private static double atEnd(
      double px, double py, double r1, double vx, double vy, double gx, double gy, double qx,
      double qy, double r2, double ex, double ey, double ux, double uy, double about, double T) {
    double r = r1 + r2;
    double dx = px - qx;
    double dy = py - qy;
    double sx = vx - ux;
    double sy = vy - uy;
    double rough = touch(dx, dy, r, sx, sy, gx, gy, about);
    if (Double.isNaN(rough)) {
      double closest = Math.min(T, closest(dx, dy, sx, sy, gx, gy, about));
      return unlessMissed(closest, dx, dy, r, sx, sy, gx, gy, ex, ey, T);
    }
    double better = nearer(dx, dy, r, sx, sy, gx, gy, rough);
    if (!(better < T)) {
      return unlessMissed(T, dx, dy, r, sx, sy, gx, gy, ex, ey, T);
    }
    double t = nearer(dx, dy, r, sx, sy, gx, gy, better);
    double nx = place(dx, sx, gx, t);
    double ny = place(dy, sy, gy, t);
    double sizeX = Offset.size(dx, sx, gx, t);
    double sizeY = Offset.size(dy, sy, gy, t);
    boolean isDisk = ex == 0 && ey == 0;
    if (!(isDisk || isInFront(-ex, -ey, dx, dy, sx, sy, gx, gy, t))
        || !isApproach(nx, ny, sizeX, sizeY, sx, sy, gx, gy, t)) {
      return GapRoot.DOUBT;
    }
    double time = ParabolaDiskSweep.nearest(px, py, r1, vx, vy, gx, gy, qx, qy, r2, ux, uy, t);
    return GapRoot.upTo(T, GapRoot.beside(t, time));
  }

  // The way from a point to a disk: its offset d at the start, its velocity s, its place at t.

  private static double place(double d, double s, double g, double t) {
    return d + (s + 0.5 * g * t) * t;
  }

  /** The square of the distance from a point less that of the radius. */
  private static double gap(
      double dx, double dy, double r, double sx, double sy, double gx, double gy, double t) {
    double x = place(dx, sx, gx, t);
    double y = place(dy, sy, gy, t);
    return (x * x + y * y) - r * r;
  }

  /** Half the rate at which the gap changes. */
  private static double slope(
      double dx, double dy, double sx, double sy, double gx, double gy, double t) {
    return place(dx, sx, gx, t) * (sx + gx * t) + place(dy, sy, gy, t) * (sy + gy * t);
  }

  /** The rate at which the slope changes. */
  private static double bend(
      double dx, double dy, double sx, double sy, double gx, double gy, double t) {
    double vx = sx + gx * t;
    double vy = sy + gy * t;
    return (vx * vx + vy * vy) + (place(dx, sx, gx, t) * gx + place(dy, sy, gy, t) * gy);
  }

  /**
   * About when a disk touches a point, by the quadratic part of its gap around a time t; NaN if
   * that has no root.
   */
  private static double touch(
      double dx, double dy, double r, double sx, double sy, double gx, double gy, double t) {
    double gap = gap(dx, dy, r, sx, sy, gx, gy, t);
    double slope = slope(dx, dy, sx, sy, gx, gy, t);
    double bend = bend(dx, dy, sx, sy, gx, gy, t);
    return t + gap / (Math.sqrt(slope * slope - gap * bend) - slope);
  }

  /** The time after a step of Halley's method towards that at which a disk touches a point. */
  private static double nearer(
      double dx, double dy, double r, double sx, double sy, double gx, double gy, double t) {
    double gap = gap(dx, dy, r, sx, sy, gx, gy, t);
    double slope = slope(dx, dy, sx, sy, gx, gy, t);
    double bend = bend(dx, dy, sx, sy, gx, gy, t);
    return t - gap * slope / (2 * slope * slope - 0.5 * gap * bend);
  }

  /** About when a disk is closest to a point, by a step of Newton's method from a time t. */
  private static double closest(
      double dx, double dy, double sx, double sy, double gx, double gy, double t) {
    return t - slope(dx, dy, sx, sy, gx, gy, t) / bend(dx, dy, sx, sy, gx, gy, t);
  }

  /**
   * NEVER if a disk is certain not to touch a line up to T, else NaN. It does not if it stays in
   * front of a tangent: the Bernstein coefficients of its distance from that, which is quadratic,
   * are all above 0. Any normal n will do, for the tangent is moved to where the line is behind it.
   *
   * @param closest about when the disk is closest to the line
   * @param dx the offset from an end of the line at the start
   * @param ex the way from there to the other end
   */
  private static double unlessMissed(
      double closest, double dx, double dy, double r, double sx, double sy, double gx, double gy,
      double ex, double ey, double T) {
    double x = place(dx, sx, gx, closest);
    double y = place(dy, sy, gy, closest);
    double along = x * ex + y * ey;
    double part = along > 0 ? Math.min(1, along / (ex * ex + ey * ey)) : 0;
    double nx = x - part * ex;
    double ny = y - part * ey;
    double square = nx * nx + ny * ny;
    double reach = r * Math.sqrt(square) + Math.max(0, nx * ex + ny * ey);
    double first = nx * dx + ny * dy;
    double middle = first + (nx * sx + ny * sy) * (0.5 * T);
    double last = nx * place(dx, sx, gx, T) + ny * place(dy, sy, gy, T);
    double terms =
        Math.abs(nx) * (r + Math.abs(ex) + Offset.size(dx, sx, gx, T))
            + Math.abs(ny) * (r + Math.abs(ey) + Offset.size(dy, sy, gy, T));
    double least = reach + fma(ROUNDING, terms, TINY);
    boolean isMissed =
        first > least
            && middle > least
            && last > least
            && square > LEAST_SQUARE
            && square < MOST
            && T < MOST;
    return isMissed ? NEVER : GapRoot.DOUBT;
  }
}
