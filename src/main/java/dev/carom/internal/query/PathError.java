// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;

/**
 * A circle's path, followed from impact to impact, and a bound of the distance between the computed
 * path and the true one: to first order, and the roundings that each impact adds. The error of
 * place and velocity, four numbers, lies in an {@link ErrorBox}. Flights and impacts move it as
 * they move a path nearby. Straight flights have the acceleration 0.
 *
 * <p>With {@code u = 2^-53}, a flight of duration d to an impact at the velocity v rounds
 *
 * <ul>
 *   <li>the place, each coordinate by at most u of itself and, along an axis with acceleration, by
 *       {@code u d} of its mean speed;
 *   <li>the velocity, each component by at most u of itself before the impact if there is
 *       acceleration along it, and after the impact;
 *   <li>the duration, by {@code u d}: the impact is late or early, see {@link ImpactMap#late};
 *   <li>the normal by at most 2 u, unless it is that of a wall;
 *   <li>the restitution, if it is not 1, by {@code 2 (1 + e) u} of the normal speed.
 * </ul>
 *
 * <p>A circle that comes back to what it hit last has an impact when its distance is again that at
 * the start of the flight, which is off by the roundings of that start. So the impact is late by
 * this gap over the normal speed.
 */
public final class PathError {

  private static final double U = 0x1p-53;

  /** Two computations of one number in the same flight differ by less than this part of it. */
  private static final double SAME = 0x1p-20;

  private static final int HALVINGS = 60;

  /** Where and when the flight began, and its velocity then. NaN if that is not known. */
  private double x;

  private double y;
  private double t;
  private double vx;
  private double vy;

  /** The acceleration in all flights. */
  private final double gx;

  private final double gy;

  /** The code of the obstacle at which the flight began. */
  private int last = MovingCircle.NOTHING;

  private final double start;

  /** The bound up to which the place counts as known, and the time at which it was passed. */
  private final double most;

  private double lostAt = Double.POSITIVE_INFINITY;

  private boolean known = true;

  private final ErrorBox errors = new ErrorBox();
  private final ErrorSum sum;
  private final NearbyPath nearby;
  private final double nearbyAtStart;

  /** How far the place at the start of the flight may be from touching what was hit there. */
  private double gap;

  /** The duration of all flights so far, and their number. */
  private double flown;

  private int flights;

  /**
   * Begins with a flight whose computed state is taken as exact, but for its rounding at a time
   * other than 0.
   *
   * @param most the bound up to which the place counts as known
   */
  public PathError(
      ErrorSum sum,
      double x,
      double y,
      double vx,
      double vy,
      double gx,
      double gy,
      double now,
      double most) {
    this.sum = sum;
    this.x = x;
    this.y = y;
    this.vx = vx;
    this.vy = vy;
    this.gx = gx;
    this.gy = gy;
    this.most = most;
    t = now;
    start = now;
    boolean moves = vx != 0 || vy != 0;
    nearby = moves ? new NearbyPath(-vy, vx) : new NearbyPath(-gy, gx);
    nearbyAtStart = logOfNearby(0);
    if (now != 0) {
      addRoundingsOfStart(now);
    }
  }

  /** The flight goes on from an earlier time: place and velocity are rounded now, not there. */
  private void addRoundingsOfStart(double now) {
    sum.of(errors);
    double rounded = (falls() ? 3 : 1) * now;
    sum.addParts(
        U * (Math.abs(x) + rounded * (Math.abs(vx) + Math.abs(gx) * now)),
        U * (Math.abs(y) + rounded * (Math.abs(vy) + Math.abs(gy) * now)),
        gx == 0 ? 0 : U * (Math.abs(vx) + 2 * Math.abs(gx) * now),
        gy == 0 ? 0 : U * (Math.abs(vy) + 2 * Math.abs(gy) * now));
    sum.enclose(errors, now);
  }

  private boolean falls() {
    return gx != 0 || gy != 0;
  }

  static double length(double x, double y) {
    return Math.sqrt(x * x + y * y);
  }

  /** Whether the flights are known; else nothing is known of the error. */
  public boolean isFollowed() {
    return !Double.isNaN(x);
  }

  /** Stops to follow the circle: the error is unknown from the end of the last flight on. */
  public void lose() {
    giveUp();
    x = Double.NaN;
  }

  /** Whether the error is known. */
  public boolean isKnown() {
    return known;
  }

  /** From the start of the flight on the true path may have other impacts: nothing is known. */
  public void giveUp() {
    lostAt = Math.min(lostAt, t);
    known = false;
  }

  /** The bound of the distance between the paths, until a time in the present flight. */
  public double width(double now) {
    return Math.max(errors.place(0), errors.place(since(now)));
  }

  /**
   * How many paths beside this one stand for all that are nearer: left and right of a line, also
   * below and above where the direction of the path changes.
   */
  public int sides() {
    return falls() ? 4 : 2;
  }

  /**
   * Puts a circle, of radius 0, beside the start of the flight.
   *
   * @param side from 0 on, below {@link #sides}
   * @param distance how far from the path, in any direction across it on one of the sides; 0 is the
   *     path itself
   */
  public void load(MovingCircle m, int side, double distance) {
    double off = side % 2 == 0 ? distance : -distance;
    double size = falls() ? Math.sqrt(0.5) : length(vx, vy);
    double dx = falls() ? (side < 2 ? 1 : 0) : -vy;
    double dy = falls() ? (side < 2 ? 0 : 1) : vx;
    m.start(0, x + off / size * dx, y + off / size * dy, 0, vx, vy, 1);
    m.fall(gx, gy);
  }

  /** A duration of the present flight within which paths nearby have their next impacts, too. */
  public double horizon(double now) {
    return falls() ? 2 * since(now) : Double.POSITIVE_INFINITY;
  }

  /** How long the present flight lasts until a time. */
  public double since(double now) {
    return now - t;
  }

  /** Stops to follow the circle unless this is its state at a time in the present flight. */
  public void check(double x, double y, double vx, double vy, double gx, double gy, double now) {
    double allowed = falls() ? SAME : 0;
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
  public void setVelocity(double vx, double vy, double gx, double gy, double now) {
    if (!flies(vx, vy, gx, gy, now, SAME)) {
      lose();
    }
    if (vx == 0 && vy == 0 && !falls()) {
      giveUp(); // an impact left the circle at rest
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
  public void bounce(
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
  private boolean impact(
      double dt, double x, double y, double nx, double ny, double radius, double e, int code) {
    ImpactMap map = new ImpactMap(vx, vy, gx, gy, nx, ny, radius, e);
    nearby.fly(dt);
    nearby.bounce(map);
    if (e == 0 && radius == Double.POSITIVE_INFINITY) {
      nearby.join();
    }
    if (!known) {
      return false;
    }
    errors.fly(dt);
    double delay = errors.delay(map);
    double steeper = steeper(nx, ny, radius, delay);
    boolean isOrdered =
        delay == 0 || delay * steeper < dt || (isWall(code) && isWall(last)); // in either order
    if (!isOrdered) {
      return false;
    }
    sum.of(errors);
    addRoundingsBefore();
    sum.bounce(map);
    sum.addDelay(map, (steeper - 1) * delay);
    addRoundings(map, dt, x, y, nx, ny, e, code);
    flown += dt;
    flights++;
    return sum.enclose(errors, flown / flights);
  }

  /**
   * By how much the sensitivity to the place, which grows with 1 / cosine, may exceed that at the
   * computed incidence. The sine of the true one differs by the turns of the normal and of the
   * velocity.
   *
   * @return NaN if the true path may miss the obstacle
   */
  private double steeper(double nx, double ny, double radius, double delay) {
    double speed = length(vx, vy);
    double cosine = Math.min(1, -(vx * nx + vy * ny) / speed);
    double across = errors.place(-vy / speed, vx / speed);
    double rate = errors.velocity(-vy / speed, vx / speed) + length(gx, gy) * delay;
    double sine = Math.sqrt(1 - cosine * cosine) + across / radius + rate / speed;
    return cosine / Math.sqrt(1 - sine * sine);
  }

  /** Those of the velocity before the impact; that along an axis without acceleration is exact. */
  private void addRoundingsBefore() {
    if (gx != 0) {
      sum.add(0, 0, U * vx, 0);
    }
    if (gy != 0) {
      sum.add(0, 0, 0, U * vy);
    }
  }

  private void addRoundings(
      ImpactMap map, double dt, double x, double y, double nx, double ny, double e, int code) {
    double vn = vx * nx + vy * ny;
    double placeX = U * (Math.abs(x) + (gx == 0 ? 0 : Math.abs(vx - 0.5 * gx * dt) * dt));
    double placeY = U * (Math.abs(y) + (gy == 0 ? 0 : Math.abs(vy - 0.5 * gy * dt) * dt));
    double late = U * dt + (code == last ? gap / Math.abs(vn) : 0);
    gap = Math.abs(nx) * placeX + Math.abs(ny) * placeY + Math.abs(vn) * late;
    boolean isWall = isWall(code);
    double ofVelocity = isWall && e == 1 ? 0 : U;
    sum.addParts(
        placeX,
        placeY,
        ofVelocity * (vx - (1 + e) * vn * nx),
        ofVelocity * (vy - (1 + e) * vn * ny));
    sum.addLate(map, late);
    if (!isWall) {
      sum.addTurn(map, 2 * U);
    }
    if (e != 1) {
      sum.add(0, 0, 2 * U * (1 + e) * vn * nx, 2 * U * (1 + e) * vn * ny);
    }
  }

  /** The bound of the distance at a time in the present flight, the rounding of its place added. */
  public double at(double now) {
    return known ? after(now - t) : Double.POSITIVE_INFINITY;
  }

  /**
   * The same after a duration of the present flight. A place is computed as {@code x + (v + g dt /
   * 2) dt}, as is the time dt, and all is rounded: once less where g is 0.
   */
  private double after(double dt) {
    double speed = length(vx, vy) + length(gx, gy) * dt;
    return errors.place(dt) + U * (Math.abs(x) + Math.abs(y) + (falls() ? 4 : 3) * speed * dt);
  }

  /** The time at which the bound passed the length, until a time in the present flight. */
  public double lostAt(double now) {
    if (lostAt <= now || at(now) <= most) {
      return lostAt;
    }
    return Math.max(t, Math.min(now, t + reaches(now - t)));
  }

  /**
   * The time since the start of the flight at which the bound, beyond it at dt, passes {@link
   * #most}. The bound is convex in time: it passes a value once from below.
   */
  private double reaches(double dt) {
    double low = 0;
    double high = known && after(0) <= most ? dt : 0;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (low + high);
      boolean passed = after(middle) > most;
      low = passed ? low : middle;
      high = passed ? middle : high;
    }
    return high;
  }

  /**
   * The mean rate at which the distance of a path nearby grew until now, by its logarithm: that at
   * equal times under gravity, else that across the velocity.
   */
  public double exponent(double now) {
    return isFollowed() ? (logOfNearby(since(now)) - nearbyAtStart) / (now - start) : Double.NaN;
  }

  private double logOfNearby(double dt) {
    return nearby.log(dt, falls() ? 0 : vx, falls() ? 0 : vy);
  }

  private static boolean isWall(int code) {
    return code != MovingCircle.NOTHING && Codes.isWall(code);
  }
}
