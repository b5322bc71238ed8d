// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

/**
 * How an impact with an obstacle at rest changes the offset (dp, dv) from a circle's state to that
 * of a path nearby, to first order and at equal times.
 *
 * <p>Let v be the velocity before the impact, n the unit normal, a the acceleration, e the
 * restitution, and R the distance of the centre from the centre of curvature, infinite for a side
 * or a wall. The path nearby touches the obstacle later by
 *
 * <pre>
 * tau = -(n.dp) / (n.v)
 * </pre>
 *
 * <p>Its centre is then off by {@code dp + v tau}, along the surface. So its normal is turned by
 * {@code dn = (dp + v tau) / R}, and its velocity differs by {@code dv + a tau}. The impact maps v
 * to {@code v' = v - (1 + e) (v.n) n}. The derivative of that, in the directions of the velocity
 * and the normal, and the same acceleration back over the time tau, give
 *
 * <pre>
 * dp' = dp + (v - v') tau = dp - (1 + e) (n.dp) n
 * dv' = dv - (1 + e) [(n.dv + (n.a) tau + v.dn) n + (v.n) dn]
 * </pre>
 *
 * <p>The acceleration enters only by {@code (n.a) tau}: a path that falls on for tau gains that
 * speed towards the obstacle before the impact, but not after it. Without acceleration and for e =
 * 1 it is the mirror equation of billiards: N. Chernov and R. Markarian, Chaotic Billiards, AMS
 * 2006, section 3.4.
 */
final class ImpactMap {

  /** The numbers of an offset: dp, dv. */
  static final int SIZE = 4;

  private final double vx;
  private final double vy;
  private final double vn;
  private final double gn;
  private final double nx;
  private final double ny;
  private final double bounce;

  /** 1 / R. */
  private final double curvature;

  private final double perNormalSpeed;

  ImpactMap(
      double vx, double vy, double gx, double gy, double nx, double ny, double radius, double e) {
    this.vx = vx;
    this.vy = vy;
    this.nx = nx;
    this.ny = ny;
    curvature = 1 / radius;
    vn = vx * nx + vy * ny;
    gn = gx * nx + gy * ny;
    bounce = 1 + e;
    perNormalSpeed = -1 / vn;
  }

  /** By how much later the path at the offset at k touches the obstacle. */
  double delay(double[] offsets, int k) {
    return (nx * offsets[k] + ny * offsets[k + 1]) * perNormalSpeed;
  }

  /** Replaces the offset at k by that after the impact. */
  void apply(double[] offsets, int k) {
    double height = nx * offsets[k] + ny * offsets[k + 1];
    double delay = height * perNormalSpeed;
    double turnX = (offsets[k] + vx * delay) * curvature;
    double turnY = (offsets[k + 1] + vy * delay) * curvature;
    double rate = nx * offsets[k + 2] + ny * offsets[k + 3];
    offsets[k] -= bounce * height * nx;
    offsets[k + 1] -= bounce * height * ny;
    push(offsets, k, rate + gn * delay + vx * turnX + vy * turnY, turnX, turnY);
  }

  /**
   * Adds to the offset at k what an impact leaves that is late by some time: the path is one that
   * flew on for so long through the obstacle.
   */
  void late(double[] offsets, int k, double time) {
    offsets[k] += bounce * vn * nx * time;
    offsets[k + 1] += bounce * vn * ny * time;
    delay(offsets, k, time);
  }

  /**
   * Adds to the offset at k the change of its velocity that goes with a delay of the impact: that
   * of {@code (n.a) tau}, and of the way {@code v tau} along the surface.
   */
  void delay(double[] offsets, int k, double time) {
    double turnX = (vx - vn * nx) * time * curvature;
    double turnY = (vy - vn * ny) * time * curvature;
    push(offsets, k, gn * time + vx * turnX + vy * turnY, turnX, turnY);
  }

  /** Adds to the offset at k the change of velocity by a turn of the normal to the left. */
  void turn(double[] offsets, int k, double angle) {
    push(offsets, k, (ny * vx - nx * vy) * -angle, -ny * angle, nx * angle);
  }

  /** The change of velocity by a change of v.n, and by one of n. */
  private void push(double[] offsets, int k, double speed, double turnX, double turnY) {
    offsets[k + 2] -= bounce * (speed * nx + vn * turnX);
    offsets[k + 3] -= bounce * (speed * ny + vn * turnY);
  }
}
