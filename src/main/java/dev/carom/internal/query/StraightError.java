// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.state.MovingCircle;

/**
 * Bounds of the error of a circle that flies straight, to first order, and the roundings that each
 * impact adds.
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
final class StraightError extends PathError {

  // Bounds: of the place along and across the velocity, and of their rates of change.
  private double along;
  private double across;
  private double alongRate;
  private double acrossRate;

  private final NearbyPath nearby = new NearbyPath();

  StraightError(double x, double y, double vx, double vy, double now, double most) {
    super(x, y, vx, vy, 0, 0, now, most);
    along = now == 0 ? 0 : U * (length(x, y) + length(vx, vy) * now);
    across = along;
  }

  @Override
  public double width(double now) {
    return across + acrossRate * since(now);
  }

  /** To the left and to the right. */
  @Override
  public int sides() {
    return 2;
  }

  @Override
  public void load(MovingCircle m, int side, double distance) {
    double share = (side == 0 ? distance : -distance) / length(vx, vy);
    m.start(0, x - share * vy, y + share * vx, 0, vx, vy, 1);
  }

  @Override
  public double horizon(double now) {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  boolean impact(
      double dt, double x, double y, double nx, double ny, double radius, double e, int code) {
    double speed = length(vx, vy);
    double cosine = Math.min(1, -(vx * nx + vy * ny) / speed);
    ImpactMap map = new ImpactMap(speed, cosine, radius, e);
    nearby.fly(dt);
    nearby.bounce(map);
    if (!isKnown()) {
      return false;
    }
    boolean isWall = isWall(code);
    // Two walls may be hit in either order.
    boolean isOrdered = isOrdered(dt) || (isWall && isWall(last));
    along += alongRate * dt;
    across += acrossRate * dt;
    spread(map, isOrdered ? leastCosine(speed, cosine, radius) : Double.NaN, cosine);
    boolean isFinite = acrossRate + alongRate + across + along <= Double.MAX_VALUE;
    round(x, y, dt * speed, speed, cosine, radius, e, isWall && e == 1);
    return isFinite;
  }

  /** Whether the flight is longer than the error, so that the true one has the same impacts. */
  private boolean isOrdered(double dt) {
    double errors = along + across;
    return errors == 0 || errors < dt * length(vx, vy);
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

  @Override
  double after(double dt) {
    return bound() + boundRate() * dt;
  }

  private double bound() {
    return along + across + U * (Math.abs(x) + Math.abs(y));
  }

  /** A place is computed as {@code x + v dt}: dt is rounded, and the place that is dt further. */
  private double boundRate() {
    return alongRate + acrossRate + 3 * U * length(vx, vy);
  }

  @Override
  double reaches(double dt) {
    return (most - bound()) / boundRate();
  }

  @Override
  double logOfNearby(double dt) {
    return nearby.log(dt);
  }
}
