// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;

/**
 * A circle's path, followed from impact to impact, and bounds of the distance between the computed
 * path and the true one. {@link StraightError} and {@link FallingError} know the bounds.
 */
public abstract class PathError {

  static final double U = 0x1p-53;

  /** Two computations of one number in the same flight differ by less than this part of it. */
  private static final double SAME = 0x1p-20;

  /** Where and when the flight began, and its velocity then. NaN if that is not known. */
  double x;

  double y;
  double t;
  double vx;
  double vy;

  /** The acceleration in all flights. */
  final double gx;

  final double gy;

  /** The code of the obstacle at which the flight began. */
  int last = MovingCircle.NOTHING;

  private final double start;

  /** The bound up to which the place counts as known, and the time at which it was passed. */
  final double most;

  private double lostAt = Double.POSITIVE_INFINITY;

  private boolean known = true;

  PathError(
      double x, double y, double vx, double vy, double gx, double gy, double now, double most) {
    this.x = x;
    this.y = y;
    this.vx = vx;
    this.vy = vy;
    this.gx = gx;
    this.gy = gy;
    this.most = most;
    t = now;
    start = now;
  }

  /**
   * Begins with a flight whose computed state is taken as exact, but for its rounding at a time
   * other than 0.
   *
   * @param most the bound up to which the place counts as known
   */
  public static PathError of(
      double x, double y, double vx, double vy, double gx, double gy, double now, double most) {
    return gx == 0 && gy == 0
        ? new StraightError(x, y, vx, vy, now, most)
        : new FallingError(x, y, vx, vy, gx, gy, now, most);
  }

  static double length(double x, double y) {
    return Math.sqrt(x * x + y * y);
  }

  /** Whether the flights are known; else nothing is known of the error. */
  public final boolean isFollowed() {
    return !Double.isNaN(x);
  }

  /** Stops to follow the circle: the error is unknown from the end of the last flight on. */
  public final void lose() {
    giveUp();
    x = Double.NaN;
  }

  /** Whether the error is known. */
  public final boolean isKnown() {
    return known;
  }

  /** From the start of the flight on the true path may have other impacts: nothing is known. */
  public final void giveUp() {
    lostAt = Math.min(lostAt, t);
    known = false;
  }

  /** The bound of the distance between the paths, until a time in the present flight. */
  public abstract double width(double now);

  /** How many paths beside this one stand for all that are nearer. */
  public abstract int sides();

  /**
   * Puts a circle, of radius 0, beside the start of the flight.
   *
   * @param side from 0 on, below {@link #sides}
   * @param distance how far from the path; 0 is the path itself
   */
  public abstract void load(MovingCircle m, int side, double distance);

  /** A duration of the present flight within which paths nearby have their next impacts, too. */
  public abstract double horizon(double now);

  /** How long the present flight lasts until a time. */
  public final double since(double now) {
    return now - t;
  }

  /** Stops to follow the circle unless this is its state at a time in the present flight. */
  public final void check(
      double x, double y, double vx, double vy, double gx, double gy, double now) {
    double allowed = gx == 0 && gy == 0 ? 0 : SAME;
    if (!(now >= t && flies(vx, vy, gx, gy, now, allowed) && isAt(x, y, now))) {
      lose();
    }
  }

  /** Whether this flight has a velocity at a time, but for a part of it, and an acceleration. */
  private boolean flies(double vx, double vy, double gx, double gy, double now, double allowed) {
    double dt = now - t;
    double off = Math.abs(this.vx + gx * dt - vx) + Math.abs(this.vy + gy * dt - vy);
    double size = Math.abs(vx) + Math.abs(vy) + (Math.abs(gx) + Math.abs(gy)) * dt;
    return gx == this.gx && gy == this.gy && off <= allowed * size;
  }

  /** Whether the flight leads to a place, but for rounding. */
  private boolean isAt(double x, double y, double now) {
    double dt = now - t;
    double half = 0.5 * dt;
    double off =
        Math.abs(this.x + (vx + gx * half) * dt - x) + Math.abs(this.y + (vy + gy * half) * dt - y);
    double speed = Math.abs(vx) + Math.abs(vy) + (Math.abs(gx) + Math.abs(gy)) * dt;
    double way = speed * (dt + Math.ulp(now) / SAME);
    return off <= SAME * (Math.abs(x) + Math.abs(y) + way);
  }

  /** Takes the velocity of the flight, which the impacts gave but for rounding. */
  public final void setVelocity(double vx, double vy, double gx, double gy, double now) {
    if (!flies(vx, vy, gx, gy, now, SAME)) {
      lose();
    }
    this.vx = vx - gx * (now - t);
    this.vy = vy - gy * (now - t);
  }

  /**
   * Ends the flight at an impact, and begins the next one.
   *
   * @param x where the centre is then
   * @param nx the unit normal
   * @param radius the distance of the centre from the centre of curvature, infinite where the
   *     normal does not depend on the place
   * @param e the restitution
   * @param code the obstacle
   */
  public final void bounce(
      double time, double x, double y, double nx, double ny, double radius, double e, int code) {
    double dt = time - t;
    double wx = vx + gx * dt;
    double wy = vy + gy * dt;
    double vn = wx * nx + wy * ny;
    if (!(vn < 0 && dt >= 0 && isAt(x, y, time))) {
      lose();
      return;
    }
    lostAt = lostAt(time);
    vx = wx;
    vy = wy;
    boolean sure = impact(dt, x, y, nx, ny, radius, e, code);
    this.x = x;
    this.y = y;
    t = time;
    vx -= (1 + e) * vn * nx;
    vy -= (1 + e) * vn * ny;
    last = code;
    known &= sure;
    if (!(at(time) <= most)) {
      lostAt = Math.min(lostAt, time);
    }
  }

  /**
   * Takes the errors through a flight and the impact at its end, and adds their roundings. The
   * velocity is that before the impact; the place and the time are those of the flight's start.
   *
   * @param dt the duration of the flight
   * @return whether the true path has the same impact, and the errors are in the range of doubles
   */
  abstract boolean impact(
      double dt, double x, double y, double nx, double ny, double radius, double e, int code);

  /** The bound of the distance at a time in the present flight, the rounding of its place added. */
  public final double at(double now) {
    return known ? after(now - t) : Double.POSITIVE_INFINITY;
  }

  /** The same after a duration of the present flight, where the error is known. */
  abstract double after(double dt);

  /** The time at which the bound passed the length, until a time in the present flight. */
  public final double lostAt(double now) {
    if (lostAt <= now || at(now) <= most) {
      return lostAt;
    }
    return Math.max(t, Math.min(now, t + reaches(now - t)));
  }

  /**
   * The time since the start of the flight at which the bound, beyond it at dt, passes {@link
   * #most}.
   */
  abstract double reaches(double dt);

  /** The mean rate at which the distance of a path nearby grew until now, by its logarithm. */
  public final double exponent(double now) {
    return isFollowed() ? logOfNearby(now - t) / (now - start) : Double.NaN;
  }

  /** The logarithm of the distance of a path nearby, dt after the start of the flight. */
  abstract double logOfNearby(double dt);

  static boolean isWall(int code) {
    return code != MovingCircle.NOTHING && Codes.isWall(code);
  }
}
