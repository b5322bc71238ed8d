// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.Gaps;

/**
 * The quick filter for a disk with a constant acceleration: the first hit on a line or a disk, in
 * plain doubles. It finds a hit, and proves by the normal there that none comes before. Nearly all
 * questions of a search are answered here; the others are left open.
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

  /** Steps towards a contact, while they are longer, in proportion, than the next number. */
  private static final int STEPS = 6;

  private static final double NEAR = 0x1p-10;

  private DirectHit() {}

  /**
   * The correctly rounded time, {@code +infinity} if it is above T; NaN where this does not tell.
   *
   * @param about a time near which the hit is expected; infinite or NaN for none
   */
  static double time(Fall f, double about, double T) {
    if (!f.isLine) {
      double level = entry(f, -f.gy, f.gx); // the height of the disk is the first to be reached
      return atEnd(f, f.ax, f.ay, 0, 0, level > 0 ? level : 0, T);
    }
    double t = about < NEVER ? about : entry(f, f.wx, f.wy);
    // Straight on with the place and the velocity of that time, would the disk touch the start of
    // the line, its end, or the side between them? Products x |x| are squares that keep the sign.
    double x = place(f.dx, f.sx, f.gx, t);
    double y = place(f.dy, f.sy, f.gy, t);
    double speedX = f.sx + f.gx * t;
    double speedY = f.sy + f.gy * t;
    double start = x * speedY - y * speedX;
    double end = (x - f.wx) * speedY - (y - f.wy) * speedX;
    double along = f.r * (f.wx * speedX + f.wy * speedY);
    double scale = Math.copySign(f.wx * f.wx + f.wy * f.wy, f.wy * speedX - f.wx * speedY);
    double square = along * Math.abs(along);
    boolean isStart = scale * (start * Math.abs(start)) + square > 0;
    boolean isEnd = scale * (end * Math.abs(end)) + square < 0;
    if (isStart) {
      return atEnd(f, f.ax, f.ay, f.wx, f.wy, t, T);
    }
    return isEnd ? atEnd(f, f.bx, f.by, -f.wx, -f.wy, t, T) : atSide(f, T);
  }

  /** The time of a hit on the side. */
  private static double atSide(Fall f, double T) {
    double t = entry(f, f.wx, f.wy);
    if (!(t < T)) {
      return unlessMissed(f, f.dx, f.dy, f.wx, f.wy, T, T);
    }
    double side = Math.copySign(1, f.wx * f.dy - f.wy * f.dx);
    double nx = -side * f.wy;
    double ny = side * f.wx;
    if (!(f.r < MOST)
        || !isInFront(f, nx, ny, f.dx, f.dy, t)
        || !isApproach(f, nx, ny, Math.abs(nx), Math.abs(ny), 0, t)) {
      return GapRoot.DOUBT;
    }
    double time = GapRoot.beside(t, GapRoot.nearestSide(f, t));
    return switch (f.region(time)) {
      case Gaps.BESIDE -> GapRoot.upTo(T, time);
      case Gaps.BEFORE -> atEnd(f, f.ax, f.ay, f.wx, f.wy, t, T);
      case Gaps.BEYOND -> atEnd(f, f.bx, f.by, -f.wx, -f.wy, t, T);
      default -> GapRoot.DOUBT;
    };
  }

  /**
   * About when the centre enters the strip along a line with the vector w through the obstacle; 0
   * if it starts there, NaN if it seems not to enter it.
   */
  private static double entry(Fall f, double wx, double wy) {
    double h0 = wx * f.dy - wy * f.dx;
    double side = Math.copySign(1, h0);
    double gap = Math.abs(h0) - (f.r + f.radius) * Math.sqrt(wx * wx + wy * wy);
    if (gap <= 0) {
      return 0;
    }
    double fall = side * (wx * f.sy - wy * f.sx);
    double bend = 0.5 * side * (wx * f.gy - wy * f.gx);
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
      Fall f, double nx, double ny, double dx, double dy, double t) {
    double height = nx * place(dx, f.sx, f.gx, t) + ny * place(dy, f.sy, f.gy, t);
    double sizeX = Math.abs(nx);
    double sizeY = Math.abs(ny);
    double terms = sizeX * Offset.size(dx, f.sx, f.gx, t) + sizeY * Offset.size(dy, f.sy, f.gy, t);
    return height > fma(ROUGH_BOUND, terms, TINY) && t < MOST && sizeX + sizeY < MOST;
  }

  /**
   * Whether a centre is certain to move against a normal n, both at about the time t and in the
   * mean since an earlier time. Then it was in front of the tangent all the time between.
   *
   * @param sizeX the terms of nx
   */
  private static boolean isApproach(
      Fall f, double nx, double ny, double sizeX, double sizeY, double from, double t) {
    double middle = 0.5 * (from + t);
    double mean = nx * (f.sx + f.gx * middle) + ny * (f.sy + f.gy * middle);
    double last = nx * (f.sx + f.gx * t) + ny * (f.sy + f.gy * t);
    double speedX = Math.abs(f.sx) + Math.abs(f.gx) * t;
    double speedY = Math.abs(f.sy) + Math.abs(f.gy) * t;
    double bound = fma(ROUGH_BOUND, sizeX * speedX + sizeY * speedY, TINY);
    return mean < -bound && last < -bound && t > 0 && t < MOST && speedX + speedY < MOST;
  }

  /**
   * The time of a hit on an end q of a line, or on a disk there. Each step goes to the first root of
   * the quadratic part of the gap, or to its least value if there is none.
   *
   * @param ex the way from there to the other end; 0 of a disk
   * @param about a time near which it is expected
   */
  private static double atEnd(
      Fall f, double qx, double qy, double ex, double ey, double about, double T) {
    double dx = f.px - qx;
    double dy = f.py - qy;
    double t = about;
    boolean touches = true;
    boolean isNear = false;
    for (int i = 0; i < STEPS && !isNear; i++) {
      double gap = gap(f, dx, dy, t);
      double slope = slope(f, dx, dy, t);
      double bend = bend(f, dx, dy, t);
      double root = Math.sqrt(slope * slope - gap * bend);
      touches = root >= 0;
      double step = touches ? gap / (root - slope) : -slope / bend;
      t += step;
      isNear = Math.abs(step) <= NEAR * t;
    }
    if (!touches || !(t > 0 && t < T)) {
      return unlessMissed(f, dx, dy, ex, ey, Math.min(Math.max(t, 0), T), T);
    }
    double nx = place(dx, f.sx, f.gx, t);
    double ny = place(dy, f.sy, f.gy, t);
    double sizeX = Offset.size(dx, f.sx, f.gx, t);
    double sizeY = Offset.size(dy, f.sy, f.gy, t);
    boolean isFirst =
        isApproach(f, nx, ny, sizeX, sizeY, 0, t)
            || isFirst(f, dx, dy, ex, ey, nx, ny, sizeX, sizeY, t);
    if (isFirst && !(f.isLine && !isInFront(f, -ex, -ey, dx, dy, t))) {
      return GapRoot.upTo(T, GapRoot.beside(t, GapRoot.nearestEnd(f, qx, qy, t)));
    }
    return GapRoot.DOUBT;
  }

  // The way from a point to a disk: its offset d at the start, its velocity s, its place at t.

  private static double place(double d, double s, double g, double t) {
    return d + (s + 0.5 * g * t) * t;
  }

  /** The square of the distance from a point less that of the radius. */
  private static double gap(Fall f, double dx, double dy, double t) {
    double x = place(dx, f.sx, f.gx, t);
    double y = place(dy, f.sy, f.gy, t);
    double r = f.r + f.radius;
    return (x * x + y * y) - r * r;
  }

  /** Half the rate at which the gap changes. */
  private static double slope(Fall f, double dx, double dy, double t) {
    return place(dx, f.sx, f.gx, t) * (f.sx + f.gx * t)
        + place(dy, f.sy, f.gy, t) * (f.sy + f.gy * t);
  }

  /** The rate at which the slope changes. */
  private static double bend(Fall f, double dx, double dy, double t) {
    double vx = f.sx + f.gx * t;
    double vy = f.sy + f.gy * t;
    return (vx * vx + vy * vy)
        + (place(dx, f.sx, f.gx, t) * f.gx + place(dy, f.sy, f.gy, t) * f.gy);
  }

  /**
   * Whether a disk that comes from behind the tangent is certain not to touch the line before: it
   * moves against the normal in the last part of the way, and the chord is clear in the first one.
   */
  private static boolean isFirst(
      Fall f, double dx, double dy, double ex, double ey, double nx, double ny, double sizeX,
      double sizeY, double t) {
    double from = crest(f, nx, ny);
    return from > 0
        && from < t
        && isApproach(f, nx, ny, sizeX, sizeY, from, t)
        && isChordClear(f, dx, dy, ex, ey, 0, from);
  }

  /** The time at which the speed along a normal, {@code n.(s + g t)}, turns. */
  private static double crest(Fall f, double nx, double ny) {
    return -(nx * f.sx + ny * f.sy) / (nx * f.gx + ny * f.gy);
  }

  /**
   * NEVER if a disk is certain not to touch a line up to T, else NaN. It does not if it stays in
   * front of a tangent, or of one before the time at which it is closest and of another after that.
   *
   * @param dx the offset from an end of the line at the start
   * @param ex the way from there to the other end
   * @param closest about when the disk is closest to the line
   */
  private static double unlessMissed(
      Fall f, double dx, double dy, double ex, double ey, double closest, double T) {
    double x = place(dx, f.sx, f.gx, closest);
    double y = place(dy, f.sy, f.gy, closest);
    double along = x * ex + y * ey;
    double part = along > 0 ? Math.min(1, along / (ex * ex + ey * ey)) : 0;
    double nx = x - part * ex;
    double ny = y - part * ey;
    double last = crest(f, nx, ny);
    double from = last > 0 && last < closest ? last : 0;
    boolean isMissed =
        isClear(f, dx, dy, ex, ey, nx, ny, 0, T)
            || ((from == 0 || isPartClear(f, dx, dy, ex, ey, nx, ny, 0, from))
                && isPartClear(f, dx, dy, ex, ey, nx, ny, from, closest)
                && (closest == T || isPartClear(f, dx, dy, ex, ey, nx, ny, closest, T)));
    return isMissed ? NEVER : GapRoot.DOUBT;
  }

  private static boolean isPartClear(
      Fall f, double dx, double dy, double ex, double ey, double nx, double ny, double from,
      double to) {
    return isClear(f, dx, dy, ex, ey, nx, ny, from, to)
        || isChordClear(f, dx, dy, ex, ey, from, to);
  }

  /** Whether a disk stays in front of a tangent along the chord of a part of its way. */
  private static boolean isChordClear(
      Fall f, double dx, double dy, double ex, double ey, double from, double to) {
    double x = place(dx, f.sx, f.gx, from);
    double y = place(dy, f.sy, f.gy, from);
    double nx = y - place(dy, f.sy, f.gy, to);
    double ny = place(dx, f.sx, f.gx, to) - x;
    double side = Math.copySign(1, nx * (x - 0.5 * ex) + ny * (y - 0.5 * ey));
    return isClear(f, dx, dy, ex, ey, side * nx, side * ny, from, to);
  }

  /**
   * Whether a disk is certain to stay in front of a tangent with the normal n: the Bernstein
   * coefficients of its distance from that, which is quadratic, are all above 0. Any normal will
   * do, for the tangent is moved to where the line is behind it.
   */
  private static boolean isClear(
      Fall f, double dx, double dy, double ex, double ey, double nx, double ny, double from,
      double to) {
    double square = nx * nx + ny * ny;
    double r = f.r + f.radius;
    double reach = r * Math.sqrt(square) + Math.max(0, nx * ex + ny * ey);
    double first = nx * place(dx, f.sx, f.gx, from) + ny * place(dy, f.sy, f.gy, from);
    double speed = nx * (f.sx + f.gx * from) + ny * (f.sy + f.gy * from);
    double middle = first + speed * (0.5 * (to - from));
    double last = nx * place(dx, f.sx, f.gx, to) + ny * place(dy, f.sy, f.gy, to);
    double terms =
        Math.abs(nx) * (r + Math.abs(ex) + Offset.size(dx, f.sx, f.gx, to))
            + Math.abs(ny) * (r + Math.abs(ey) + Offset.size(dy, f.sy, f.gy, to));
    double least = reach + fma(ROUNDING, terms, TINY);
    return first > least
        && middle > least
        && last > least
        && square > LEAST_SQUARE
        && square < MOST
        && to < MOST;
  }
}
