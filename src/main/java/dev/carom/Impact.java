// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The first contact of a moving circle with an obstacle or with another circle.
 *
 * @param time the time of impact, counted from the start of the motion; at least 0
 * @param kind the kind of what was hit
 * @param id its id in the world that was asked, or its place in the list of its kind that a {@link
 *     Resolver} was made of; of a wall 0 left, 1 right, 2 bottom, 3 top; -1 where the detector
 *     alone was asked about one line, peg or circle
 * @param obstacle what was hit; of two moving circles the second one, as it stood at the start
 * @param feature the part that was hit
 * @param point the contact point: on the obstacle; of two circles the point where they touch. Where
 *     they overlap at the start: of a line or a wall the point nearest to the centre; of a peg or
 *     another circle the one between the centres that divides their distance as the radii. A
 *     coordinate beyond the range of doubles is the largest one
 * @param normal unit vector from the obstacle to the circle (of two circles: from the second to the
 *     first), each component within 1e-15 of the true one
 * @param approachSpeed the speed at which the distance falls at contact: {@code -v.n}, greater than
 *     0, unless it is smaller than the range of a double; infinite if it is larger
 */
public record Impact(
    double time,
    ObstacleKind kind,
    int id,
    Obstacle obstacle,
    Feature feature,
    Vec2 point,
    Vec2 normal,
    double approachSpeed) {

  /** What has no id: an answer of the detector alone. */
  static final int NO_ID = -1;
}
