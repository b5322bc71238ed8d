// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.response.SphereResponse;
import dev.carom.internal.sweep.SphereSweep;
import dev.carom.internal.util.Check;

/**
 * A {@code SweptSphere} is a sphere in space that moves straight on from time 0. It is the
 * detector, too: it tells when it first touches another one, whether they overlap, and how they
 * part. It needs no world.
 *
 * <pre>{@code
 * // Two spheres of radius 1, 10 apart, that approach each other at 4 units a second.
 * SweptSphere first = new SweptSphere(0, 0, 0, 1, 4, 0, 0);
 * System.out.println(first.timeToSphere(new SweptSphere(10, 0, 0, 1, 0, 0, 0), 5)); // 2.0
 * }</pre>
 *
 * <p>{@link SweptCircle} defines an impact, and its mathematics serve here too. Hit or miss is that
 * of real arithmetic on the given doubles, exact ties included, and the time is the correctly
 * rounded one. Spheres whose centres move in a plane z = constant are answered as circles, bit for
 * bit.
 *
 * <p>Lengths share one unit, times another. Coordinates and velocities are finite, radii finite and
 * at least 0. The end of the window, maxTime, is at least 0, {@code +infinity} included. Anything
 * else is an {@link IllegalArgumentException} that names it. A question allocates nothing, unless
 * it is so close to a tie that only exact arithmetic decides it.
 *
 * <p>Method: seen from the second sphere the first one's centre is a point that moves against a
 * sphere of radius r1 + r2 (C. Ericson, Real-Time Collision Detection, 2005, 5.5.5).
 *
 * @param x the x coordinate of the centre at time 0
 * @param y the y coordinate of the centre at time 0
 * @param z the z coordinate of the centre at time 0
 * @param radius the radius; 0 for a point
 * @param vx the x component of the velocity
 * @param vy the y component of the velocity
 * @param vz the z component of the velocity
 */
public record SweptSphere(
    double x, double y, double z, double radius, double vx, double vy, double vz) {

  /**
   * Checks the components.
   *
   * @param x the x coordinate of the centre
   * @param y the y coordinate of the centre
   * @param z the z coordinate of the centre
   * @param radius the radius
   * @param vx the x component of the velocity
   * @param vy the y component of the velocity
   * @param vz the z component of the velocity
   * @throws IllegalArgumentException if a number is not finite, or the radius negative
   */
  public SweptSphere {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.finite("z", z);
    Check.notNegative("radius", radius);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
    Check.finite("vz", vz);
  }

  /**
   * Returns the time at which this sphere and another one hit each other.
   *
   * @param other the other sphere
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if maxTime is NaN or negative
   */
  public double timeToSphere(SweptSphere other, double maxTime) {
    SweptSphere o = Check.notNull("other", other);
    Check.duration("maxTime", maxTime);
    return SphereSweep.time(
        x, y, z, radius, vx, vy, vz, o.x, o.y, o.z, o.radius, o.vx, o.vy, o.vz, maxTime);
  }

  /**
   * Tells whether this sphere and another one overlap at time 0: the distance of their centres is
   * less than the sum of the radii, exactly. Touching is not overlapping.
   *
   * @param other the other sphere
   * @return whether they overlap
   */
  public boolean overlaps(SweptSphere other) {
    SweptSphere o = Check.notNull("other", other);
    return SphereSweep.overlaps(x, y, z, radius, o.x, o.y, o.z, o.radius);
  }

  /**
   * Computes the velocities of two spheres after an impact.
   *
   * <p>Along the line of centres {@code d = c1 - c2} the relative velocity {@code u = v1 - v2} is
   * reversed and scaled by the restitution e, with
   *
   * <pre>
   *   J = (1 + e) (u.d) / (d.d),  v1 -= m2 / (m1 + m2) J d,  v2 += m1 / (m1 + m2) J d
   * </pre>
   *
   * (H. Goldstein, Classical Mechanics, 1980, 3.11). Each component is rounded once, after d and u
   * were; beyond the range of doubles it is infinite. A sphere of infinite mass goes on as it was;
   * two of them pass through each other. Spheres that do not approach each other, {@code u.d >= 0},
   * concentric ones among them, keep their velocities.
   *
   * @param first the first sphere: its centre at the impact, and its velocity before it
   * @param m1 its mass, from 2^-500 to 2^500, or infinite
   * @param second the second sphere at the impact, in the same way
   * @param m2 its mass, from 2^-500 to 2^500, or infinite
   * @param restitution finite and at least 0: 1 elastic, 0 no bounce
   * @param velocities receives vx1, vy1, vz1, vx2, vy2, vz2 after the impact
   * @throws IllegalArgumentException if a mass or the restitution is outside its range, or there is
   *     no room for six velocities
   */
  public static void respond(
      SweptSphere first,
      double m1,
      SweptSphere second,
      double m2,
      double restitution,
      double[] velocities) {
    SweptSphere a = Check.notNull("first", first);
    Check.mass("m1", m1);
    SweptSphere b = Check.notNull("second", second);
    Check.mass("m2", m2);
    Check.notNegative("restitution", restitution);
    double[] v = Check.notNull("velocities", velocities);
    if (v.length != 6) {
      throw Check.refused("velocities.length", v.length, "6");
    }
    v[0] = a.vx;
    v[1] = a.vy;
    v[2] = a.vz;
    v[3] = b.vx;
    v[4] = b.vy;
    v[5] = b.vz;
    if (SphereSweep.drift(a.x, a.y, a.z, a.vx, a.vy, a.vz, b.x, b.y, b.z, b.vx, b.vy, b.vz) < 0) {
      SphereResponse.respond(a.x, a.y, a.z, m1, b.x, b.y, b.z, m2, 1 + restitution, v);
    }
  }
}
