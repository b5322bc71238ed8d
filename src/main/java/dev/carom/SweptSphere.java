// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.response.SphereResponse;
import dev.carom.internal.sweep.SphereSweep;
import dev.carom.internal.util.Check;

/**
 * {@code SweptSphere} is the detector in space: it tells when two moving spheres first touch, whether
 * they overlap, and how they part. Pure functions on doubles, without a world.
 *
 * <pre>{@code
 * // Two spheres of radius 1, 10 apart, that approach each other at 4 units a second.
 * System.out.println(SweptSphere.pair(0, 0, 0, 1, 4, 0, 0, 10, 0, 0, 1, 0, 0, 0, 5)); // 2.0
 * }</pre>
 *
 * <p>{@link SweptCircle} defines an impact, and its mathematics serve here too. Hit or miss is that of
 * real arithmetic on the given doubles, exact ties included, and the time is the correctly rounded
 * one. Spheres whose centres move in a plane z = constant are answered as circles, bit for bit.
 *
 * <p>Lengths share one unit, times another. Coordinates and velocities are finite, radii finite and at
 * least 0. The end of the window, maxTime, is at least 0, {@code +infinity} included. Anything else is
 * an {@link IllegalArgumentException} that names it. Nothing is allocated, unless a query is so close
 * to a tie that only exact arithmetic decides it.
 *
 * <p>Method: seen from the second sphere the first one's centre is a point that moves against a
 * sphere of radius r1 + r2 (C. Ericson, Real-Time Collision Detection, 2005, 5.5.5).
 */
public final class SweptSphere {

  private SweptSphere() {}

  /**
   * Returns the time at which two moving spheres hit each other.
   *
   * @param x1 the x coordinate of the first sphere's centre
   * @param y1 the y coordinate of the first sphere's centre
   * @param z1 the z coordinate of the first sphere's centre
   * @param r1 the radius of the first sphere
   * @param vx1 the x component of the first sphere's velocity
   * @param vy1 the y component of the first sphere's velocity
   * @param vz1 the z component of the first sphere's velocity
   * @param x2 the x coordinate of the second sphere's centre
   * @param y2 the y coordinate of the second sphere's centre
   * @param z2 the z coordinate of the second sphere's centre
   * @param r2 the radius of the second sphere
   * @param vx2 the x component of the second sphere's velocity
   * @param vy2 the y component of the second sphere's velocity
   * @param vz2 the z component of the second sphere's velocity
   * @param maxTime the end of the window
   * @return the time of impact, {@code +infinity} = never
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static double pair(
      double x1, double y1, double z1, double r1, double vx1, double vy1, double vz1, double x2,
      double y2, double z2, double r2, double vx2, double vy2, double vz2, double maxTime) {
    check(x1, y1, z1, r1, x2, y2, z2, r2);
    checkVelocities(vx1, vy1, vz1, vx2, vy2, vz2);
    Check.duration("maxTime", maxTime);
    return SphereSweep.time(x1, y1, z1, r1, vx1, vy1, vz1, x2, y2, z2, r2, vx2, vy2, vz2, maxTime);
  }

  /**
   * Tells whether two spheres overlap: the distance of their centres is less than r1 + r2, exactly.
   * Touching is not overlapping.
   *
   * @param x1 the x coordinate of the first sphere's centre
   * @param y1 the y coordinate of the first sphere's centre
   * @param z1 the z coordinate of the first sphere's centre
   * @param r1 the radius of the first sphere
   * @param x2 the x coordinate of the second sphere's centre
   * @param y2 the y coordinate of the second sphere's centre
   * @param z2 the z coordinate of the second sphere's centre
   * @param r2 the radius of the second sphere
   * @return whether they overlap
   * @throws IllegalArgumentException if a number is outside its range
   */
  public static boolean overlaps(
      double x1, double y1, double z1, double r1, double x2, double y2, double z2, double r2) {
    check(x1, y1, z1, r1, x2, y2, z2, r2);
    return SphereSweep.overlaps(x1, y1, z1, r1, x2, y2, z2, r2);
  }

  /**
   * Computes the velocities of two spheres after an impact, in place.
   *
   * <p>Along the line of centres {@code d = c1 - c2} the relative velocity {@code u = v1 - v2} is
   * reversed and scaled by e, with
   *
   * <pre>
   *   J = (1 + e) (u.d) / (d.d),  v1 -= m2 / (m1 + m2) J d,  v2 += m1 / (m1 + m2) J d
   * </pre>
   *
   * (H. Goldstein, Classical Mechanics, 1980, 3.11). Each component is rounded once, after d and u
   * were; beyond the range of doubles it is infinite. A sphere of infinite mass goes on as it was; two
   * of them pass through each other. Spheres that do not approach each other, {@code u.d >= 0},
   * concentric ones among them, keep their velocities.
   *
   * @param x1 the x coordinate of the first sphere's centre
   * @param y1 the y coordinate of the first sphere's centre
   * @param z1 the z coordinate of the first sphere's centre
   * @param m1 the mass of the first sphere, from 2^-500 to 2^500, or infinite
   * @param x2 the x coordinate of the second sphere's centre
   * @param y2 the y coordinate of the second sphere's centre
   * @param z2 the z coordinate of the second sphere's centre
   * @param m2 the mass of the second sphere, from 2^-500 to 2^500, or infinite
   * @param e the restitution, finite and at least 0: 1 elastic, 0 no bounce
   * @param velocities vx1, vy1, vz1, vx2, vy2, vz2 before the impact, replaced by those after it
   * @throws IllegalArgumentException if a number is outside its range, or there are not six
   *     velocities
   */
  public static void respond(
      double x1, double y1, double z1, double m1, double x2, double y2, double z2, double m2,
      double e, double[] velocities) {
    check(x1, y1, z1, 0, x2, y2, z2, 0);
    Check.mass("m1", m1);
    Check.mass("m2", m2);
    Check.notNegative("e", e);
    if (Check.notNull("velocities", velocities).length != 6) {
      throw Check.refused("velocities.length", velocities.length, "6");
    }
    double[] v = velocities;
    checkVelocities(v[0], v[1], v[2], v[3], v[4], v[5]);
    if (SphereSweep.drift(x1, y1, z1, v[0], v[1], v[2], x2, y2, z2, v[3], v[4], v[5]) < 0) {
      SphereResponse.respond(x1, y1, z1, m1, x2, y2, z2, m2, 1 + e, v);
    }
  }

  private static void check(
      double x1, double y1, double z1, double r1, double x2, double y2, double z2, double r2) {
    Check.finite("x1", x1);
    Check.finite("y1", y1);
    Check.finite("z1", z1);
    Check.notNegative("r1", r1);
    Check.finite("x2", x2);
    Check.finite("y2", y2);
    Check.finite("z2", z2);
    Check.notNegative("r2", r2);
  }

  private static void checkVelocities(
      double vx1, double vy1, double vz1, double vx2, double vy2, double vz2) {
    Check.finite("vx1", vx1);
    Check.finite("vy1", vy1);
    Check.finite("vz1", vz1);
    Check.finite("vx2", vx2);
    Check.finite("vy2", vy2);
    Check.finite("vz2", vz2);
  }
}
