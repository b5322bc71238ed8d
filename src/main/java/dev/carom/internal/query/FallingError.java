// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.response.Settling;
import dev.carom.internal.state.MovingCircle;

/**
 * Bounds of the error of a circle that falls, to first order, and the roundings that each impact
 * adds. The error of place and velocity, four numbers, lies in an {@link ErrorBox}; flights and
 * impacts move it as they move a path nearby.
 *
 * <p>With {@code u = 2^-53}, a flight of duration d to an impact at the velocity v rounds
 *
 * <ul>
 *   <li>the place, each coordinate by at most u of itself, and by {@code u d} of its mean speed;
 *   <li>the velocity, each component by at most u of itself before the impact, and after it;
 *   <li>the duration, by {@code u d}: the impact is late or early, see {@link FallingMap#late};
 *   <li>the normal by at most 2 u, unless it is that of a wall;
 *   <li>the restitution, if it is not 1, by {@code 2 (1 + e) u} of the normal speed.
 * </ul>
 *
 * <p>A circle that comes back to what it hit last has an impact when its distance is again that at
 * the start of the flight, which is off by the roundings of that start. So the impact is late by
 * this gap over the normal speed.
 */
final class FallingError extends PathError {

  /**
   * An inelastic bounce off something round that is no higher than this part of the distance of the
   * centres may be one that the rules of gravity have made higher.
   */
  private static final double FAINT_HOP = 2 * Settling.LEAST_HOP;

  /** An elastic one, in ulps of the coordinates. */
  private static final double FAINT_ULPS = 8;

  private static final int HALVINGS = 60;

  private final ErrorBox errors = new ErrorBox();
  private final FallingNeighbor nearby;

  /** How far the place at the start of the flight may be from touching what was hit there. */
  private double gap;

  /** The duration of all flights so far, and their number. */
  private double flown;

  private int flights;

  FallingError(
      double x, double y, double vx, double vy, double gx, double gy, double now, double most) {
    super(x, y, vx, vy, gx, gy, now, most);
    boolean moves = vx != 0 || vy != 0;
    nearby = moves ? new FallingNeighbor(-vy, vx) : new FallingNeighbor(-gy, gx);
    if (now != 0) {
      startAt(now);
    }
  }

  /** The flight goes on from an earlier time: place and velocity are rounded now, not there. */
  private void startAt(double now) {
    double ofX = U * (Math.abs(x) + 3 * (Math.abs(vx) + Math.abs(gx) * now) * now);
    double ofY = U * (Math.abs(y) + 3 * (Math.abs(vy) + Math.abs(gy) * now) * now);
    errors.add(ofX, 0, 0, 0);
    errors.add(0, ofY, 0, 0);
    errors.add(0, 0, U * (Math.abs(vx) + 2 * Math.abs(gx) * now), 0);
    errors.add(0, 0, 0, U * (Math.abs(vy) + 2 * Math.abs(gy) * now));
    errors.enclose(now);
  }

  @Override
  public double width(double now) {
    return Math.max(errors.place(0), errors.place(since(now)));
  }

  /** To the left, right, bottom and top: the direction of the path changes. */
  @Override
  public int sides() {
    return 4;
  }

  /** In any direction across, one of the four is as far off as asked. */
  @Override
  public void load(MovingCircle m, int side, double distance) {
    double off = (side % 2 == 0 ? Math.sqrt(2) : -Math.sqrt(2)) * distance;
    m.start(0, side < 2 ? x + off : x, side < 2 ? y : y + off, 0, vx, vy, 1);
    m.fall(gx, gy);
  }

  @Override
  public double horizon(double now) {
    return 2 * since(now);
  }

  @Override
  boolean impact(
      double dt, double x, double y, double nx, double ny, double radius, double e, int code) {
    FallingMap map = new FallingMap(vx, vy, gx, gy, nx, ny, radius, e);
    nearby.fly(dt);
    nearby.bounce(map);
    if (!isKnown()) {
      return false;
    }
    errors.fly(dt);
    double delay = errors.delay(map);
    double steeper = steeper(nx, ny, radius, delay);
    boolean sure = (delay == 0 || delay * steeper < dt) && !isFaint(nx, ny, radius, e, x, y);
    if (!sure) {
      return false;
    }
    addRoundingsBefore();
    errors.bounce(map);
    errors.addDelay(map, (steeper - 1) * delay);
    addRoundings(map, dt, x, y, nx, ny, e, code);
    flown += dt;
    flights++;
    return errors.enclose(flown / flights);
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

  /**
   * Whether the bounce is so low that the circle may leave something round faster than it would.
   */
  private boolean isFaint(double nx, double ny, double radius, double e, double x, double y) {
    double vn = vx * nx + vy * ny;
    double along = vy * nx - vx * ny;
    double pressure = -(gx * nx + gy * ny) - along * along / radius;
    double height =
        e < 1 ? FAINT_HOP * radius : FAINT_ULPS * Math.ulp(Math.max(Math.abs(x), Math.abs(y)));
    return radius < Double.POSITIVE_INFINITY && e * vn * (e * vn) <= 2 * pressure * height;
  }

  /** Those of the velocity before the impact; that along an axis without acceleration is exact. */
  private void addRoundingsBefore() {
    if (gx != 0) {
      errors.add(0, 0, U * vx, 0);
    }
    if (gy != 0) {
      errors.add(0, 0, 0, U * vy);
    }
  }

  private void addRoundings(
      FallingMap map, double dt, double x, double y, double nx, double ny, double e, int code) {
    double vn = vx * nx + vy * ny;
    double placeX = U * (Math.abs(x) + Math.abs(vx - 0.5 * gx * dt) * dt);
    double placeY = U * (Math.abs(y) + Math.abs(vy - 0.5 * gy * dt) * dt);
    double late = U * dt + (code == last ? gap / Math.abs(vn) : 0);
    gap = Math.abs(nx) * placeX + Math.abs(ny) * placeY + Math.abs(vn) * late;
    errors.add(placeX, 0, 0, 0);
    errors.add(0, placeY, 0, 0);
    errors.addLate(map, late);
    boolean isWall = isWall(code);
    if (!isWall) {
      errors.addTurn(map, 2 * U);
    }
    if (!(isWall && e == 1)) {
      errors.add(0, 0, U * (vx - (1 + e) * vn * nx), 0);
      errors.add(0, 0, 0, U * (vy - (1 + e) * vn * ny));
    }
    if (e != 1) {
      errors.add(0, 0, 2 * U * (1 + e) * vn * nx, 2 * U * (1 + e) * vn * ny);
    }
  }

  /**
   * A place is computed as {@code x + (v + g dt / 2) dt}, as is the time dt, and all is rounded.
   */
  @Override
  double after(double dt) {
    double speed = length(vx, vy) + length(gx, gy) * dt;
    return errors.place(dt) + U * (Math.abs(x) + Math.abs(y) + 4 * speed * dt);
  }

  /** The bound is convex in time: it passes a value once from below. */
  @Override
  double reaches(double dt) {
    if (!isKnown() || after(0) > most) {
      return 0;
    }
    double low = 0;
    double high = dt;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = 0.5 * (low + high);
      boolean passed = after(middle) > most;
      low = passed ? low : middle;
      high = passed ? middle : high;
    }
    return high;
  }

  @Override
  double logOfNearby(double dt) {
    return nearby.log(dt);
  }
}
