// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.MovingCircle;

/**
 * Bounds of the distance between a circle's computed state and the true one, to first order, and
 * the roundings that each impact adds. The circle's flights are followed from impact to impact.
 *
 * <p>With {@code u = 2^-53} a flight of duration d to an impact rounds
 *
 * <ul>
 *   <li>the place, each coordinate by at most u of itself;
 *   <li>the duration, by u d. The circle then bounces {@code u d s} too late or too early, which
 *       moves its later path by {@code (1 + e) c u d s}, and turns the normal of a round obstacle
 *       by {@code u d s g / R};
 *   <li>the normal, each component twice, which turns it by at most 2 u; a turn by w changes the
 *       velocity by {@code (1 + e) s w};
 *   <li>the velocity, each component by at most u of itself, and by {@code 2 (1 + e) c s u} where
 *       the restitution is itself rounded. Walls of restitution 1 round nothing.
 * </ul>
 */
public final class PathError {

  private static final double U = 0x1p-53;

  /** Two computations of one number in the same flight differ by less than this part of it. */
  private static final double SAME = 0x1p-20;

  // Bounds: of the place along and across the velocity, and of their rates of change.
  private double along;
  private double across;
  private double alongRate;
  private double acrossRate;

  /** Where and when the flight began, and its velocity. NaN if that is not known. */
  private double x;

  private double y;
  private double t;
  private double vx;
  private double vy;

  /** Whether the flight began at a wall. */
  private boolean fromWall;

  private final double start;
  private final NearbyPath nearby = new NearbyPath();

  /** The bound up to which the place counts as known, and the time at which it was passed. */
  private final double most;

  private double lostAt = Double.POSITIVE_INFINITY;

  /**
   * Begins with a flight whose computed state is taken as exact, but for the rounding of its place
   * at a time other than 0.
   *
   * @param most the bound up to which the place counts as known
   */
  public PathError(double x, double y, double vx, double vy, double now, double most) {
    this.x = x;
    this.y = y;
    this.vx = vx;
    this.vy = vy;
    this.most = most;
    t = now;
    start = now;
    along = now == 0 ? 0 : U * (length(x, y) + length(vx, vy) * now);
    across = along;
  }

  private static double length(double x, double y) {
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
    return along < Double.POSITIVE_INFINITY;
  }

  /** From the start of the flight on the true path may have other impacts: nothing is known. */
  public void giveUp() {
    lostAt = Math.min(lostAt, t);
    along = Double.POSITIVE_INFINITY;
  }

  /** The bound of the distance between the paths, until a time in the present flight. */
  public double width(double now) {
    return across + acrossRate * (now - t);
  }

  /** Puts a circle beside the start of the flight; returns how long that lasts until a time. */
  public double load(MovingCircle m, double radius, double beside, double now) {
    double share = beside / length(vx, vy);
    m.start(0, x - share * vy, y + share * vx, radius, vx, vy, 1);
    return now - t;
  }

  /** Stops to follow the circle unless this is its state at a time in the present flight. */
  public void check(double x, double y, double vx, double vy, double now) {
    if (!(now >= t && vx == this.vx && vy == this.vy && isAt(x, y, now))) {
      lose();
    }
  }

  /** Whether the flight leads to a place, but for rounding. */
  private boolean isAt(double x, double y, double now) {
    double dt = now - t;
    double off = Math.abs(this.x + vx * dt - x) + Math.abs(this.y + vy * dt - y);
    double way = (Math.abs(vx) + Math.abs(vy)) * (dt + Math.ulp(now) / SAME);
    return off <= SAME * (Math.abs(x) + Math.abs(y) + way);
  }

  /** Takes the velocity of the flight, which the impacts gave but for rounding. */
  public void setVelocity(double vx, double vy) {
    double off = Math.abs(this.vx - vx) + Math.abs(this.vy - vy);
    if (!(off <= SAME * (Math.abs(vx) + Math.abs(vy)))) {
      lose();
    }
    this.vx = vx;
    this.vy = vy;
  }

  /**
   * Ends the flight at an impact, and begins the next one.
   *
   * @param x where the centre is then
   * @param nx the unit normal
   * @param radius the distance of the centre from the centre of curvature, infinite where the
   *     normal does not depend on the place
   * @param e the restitution
   * @param isWall whether the obstacle is a wall: two walls may be hit in either order
   */
  public void bounce(
      double time,
      double x,
      double y,
      double nx,
      double ny,
      double radius,
      double e,
      boolean isWall) {
    double vn = vx * nx + vy * ny;
    if (!(vn < 0 && time >= t && isAt(x, y, time))) {
      lose();
      return;
    }
    double dt = time - t;
    boolean isOrdered = isOrdered(dt) || (isWall && fromWall);
    fly(dt);
    double speed = length(vx, vy);
    double cosine = Math.min(1, -vn / speed);
    ImpactMap map = new ImpactMap(speed, cosine, radius, e);
    nearby.fly(dt);
    nearby.bounce(map);
    spread(map, isOrdered ? leastCosine(speed, cosine, radius) : Double.NaN, cosine);
    round(x, y, dt * speed, speed, cosine, radius, e, isWall && e == 1);
    this.x = x;
    this.y = y;
    t = time;
    vx -= (1 + e) * vn * nx;
    vy -= (1 + e) * vn * ny;
    fromWall = isWall;
    if (!(along + across <= most)) {
      lostAt = Math.min(lostAt, time);
    }
  }

  /** Whether the flight is longer than the error, so that the true one has the same impacts. */
  private boolean isOrdered(double dt) {
    double errors = along + across;
    return errors == 0 || errors < dt * length(vx, vy);
  }

  private void fly(double dt) {
    lostAt = lostAt(t + dt);
    along += alongRate * dt;
    across += acrossRate * dt;
  }

  /**
   * The cosine of the steepest true incidence. On a round obstacle an offset across the velocity
   * changes the sine by its part of R, one of the direction by that angle.
   *
   * @return NaN if the true path may miss the obstacle
   */
  private double leastCosine(double speed, double cosine, double radius) {
    double sine = Math.sqrt(1 - cosine * cosine) + across / radius + acrossRate / speed;
    return radius == Double.POSITIVE_INFINITY ? cosine : Math.sqrt(1 - sine * sine);
  }

  private void spread(ImpactMap map, double leastCosine, double cosine) {
    double steeper = cosine / leastCosine;
    along = map.ratio * along + map.shifted * across;
    alongRate = map.ratio * alongRate + map.braked * acrossRate + map.brakedByPlace * across;
    acrossRate = map.kept * acrossRate + map.turned * steeper * across;
    across *= map.kept;
    if (!(acrossRate + alongRate + across + along <= Double.MAX_VALUE)) {
      along = Double.POSITIVE_INFINITY;
    }
  }

  private void round(
      double x,
      double y,
      double way,
      double speed,
      double cosine,
      double radius,
      double e,
      boolean exactVelocity) {
    double place = U * (length(x, y) + (1 + e) * cosine * way);
    along += place;
    across += place;
    if (!exactVelocity) {
      double sine = Math.sqrt(1 - cosine * cosine);
      double turn = (1 + e) * speed * U * (2 + way * sine / radius);
      double velocity = U * speed * (e == 1 ? 1 : 1 + e + 2 * (1 + e) * cosine);
      acrossRate += turn + velocity;
      alongRate += (e == 1 ? 0 : turn) + velocity;
    }
  }

  /** The bound of the distance at a time in the present flight, the rounding of its place added. */
  public double at(double now) {
    return isKnown() ? bound() + boundRate() * (now - t) : Double.POSITIVE_INFINITY;
  }

  private double bound() {
    return along + across + U * (Math.abs(x) + Math.abs(y));
  }

  /** A place is computed as {@code x + v dt}: dt is rounded, and the place that is dt further. */
  private double boundRate() {
    return alongRate + acrossRate + 3 * U * length(vx, vy);
  }

  /** The time at which the bound passed the length, until a time in the present flight. */
  public double lostAt(double now) {
    if (lostAt <= now || at(now) <= most) {
      return lostAt;
    }
    return Math.max(t, Math.min(now, t + (most - bound()) / boundRate()));
  }

  /** The mean rate at which the distance of a path nearby grew until now, by its logarithm. */
  public double exponent(double now) {
    return isFollowed() ? nearby.log(now - t) / (now - start) : Double.NaN;
  }
}
