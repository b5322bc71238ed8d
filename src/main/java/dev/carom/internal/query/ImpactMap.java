// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

/**
 * How an impact with an obstacle at rest changes the offset from a circle's state to that of a path
 * nearby, to first order.
 *
 * <p>Along and across mean: in the direction of the velocity, and at right angles to it; before the
 * impact and after it. Let s be the speed, c and g the cosine and the sine of the angle of
 * incidence, e the restitution, R the distance of the centre from the centre of curvature (infinite
 * for a side or a wall), and {@code k = sqrt(g^2 + e^2 c^2)} the ratio of the speeds. The offset (a
 * along, b across) of the place and (p along, q across) of the velocity becomes, up to signs,
 *
 * <pre>
 * a' = k a + (g/c) (1/k - k) b
 * b' = (e/k) b
 * p' = k p + (1 - e^2) (g/k) (c q + (s/R) b)
 * q' = (e/k) q + (1 + e) (s/R) (g^2 + e c^2) / (c k) b
 * </pre>
 *
 * <p>Source: the derivative of {@code v' = v - (1 + e) (v.n) n} at the time at which the centre
 * reaches the distance R. For e = 1 it is the mirror equation of billiards, {@code q' = q + 2 s b /
 * (R c)}: N. Chernov and R. Markarian, Chaotic Billiards, AMS 2006, section 3.4. As obstacles are
 * convex, b and q never feed on a and p, and no term of theirs is negative. So bounds of their
 * absolute values obey the same equations, and lose nothing by it.
 */
final class ImpactMap {

  /** The ratio of the speeds after and before. */
  final double ratio;

  /** The factor of b in b', and of q in q'. */
  final double kept;

  /** The factor of b in q'. */
  final double turned;

  /** The factor of b in a'. */
  final double shifted;

  /** The factor of q in p'. */
  final double braked;

  /** The factor of b in p'. */
  final double brakedByPlace;

  /**
   * Makes the map of an impact.
   *
   * @param speed the speed before, more than 0
   * @param cosine that of the angle of incidence, above 0 and at most 1
   * @param radius the distance R, infinite for a side or a wall
   * @param e the restitution
   */
  ImpactMap(double speed, double cosine, double radius, double e) {
    double square = Math.max(0, 1 - cosine * cosine);
    double sine = Math.sqrt(square);
    double curvature = speed / radius;
    ratio = e == 1 ? 1 : Math.sqrt(square + e * e * cosine * cosine);
    kept = e / ratio;
    turned = (1 + e) * curvature * (square + e * cosine * cosine) / (cosine * ratio);
    shifted = sine / cosine * Math.abs(1 / ratio - ratio);
    braked = Math.abs(1 - e * e) * sine / ratio * cosine;
    brakedByPlace = Math.abs(1 - e * e) * sine / ratio * curvature;
  }
}
