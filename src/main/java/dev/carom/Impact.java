// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * An {@code Impact} is the first contact of a moving circle with an obstacle or with another
 * circle. It is an answer: its constructor checks nothing.
 *
 * @param time the time of impact, counted from the start of the motion; at least 0
 * @param kind the kind of thing that was hit
 * @param id the id of the thing that was hit, in the world that was asked. From a {@link Resolver}
 *     it is the place in the list of its kind that the resolver was made of. For a wall it is 0
 *     left, 1 right, 2 bottom, 3 top. From the detector alone it is -1, except for walls
 * @param obstacle the thing that was hit, where it is at the impact: also a line, a peg or a circle
 *     that moves. Of two moving circles it is the second one. A coordinate beyond the range of
 *     doubles is the largest one
 * @param feature the part of it that was hit
 * @param point the contact point, on the obstacle; of two circles the point where they touch. If
 *     they overlap at the start, it is the point of the line or wall that is nearest to the centre;
 *     of a peg or another circle it divides the distance of the centres in the ratio of the radii.
 *     A coordinate beyond the range of doubles is the largest one
 * @param normal the unit vector from the obstacle to the circle (of two circles: from the second to
 *     the first), each component within 1e-15 of the true one
 * @param approachSpeed the speed at which the distance falls at contact: {@code -(v - u).n}, with
 *     the velocity v of the circle and u of the thing that was hit. It is greater than 0, unless it
 *     is smaller than the range of a double, or an acceleration alone makes the distance fall;
 *     infinite if it is larger
 */
public record Impact(
    double time,
    Kind kind,
    int id,
    Obstacle obstacle,
    Feature feature,
    Vec2 point,
    Vec2 normal,
    double approachSpeed) {

  /** The id in an answer of the detector alone, which knows no ids. */
  static final int NO_ID = -1;
}
