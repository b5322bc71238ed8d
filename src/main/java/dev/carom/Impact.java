// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The first contact of a moving circle with an obstacle or with another circle.
 *
 * @param time the time of impact, counted from the start of the motion; at least 0
 * @param obstacle what was hit; of two moving circles the second one, as it stood at the start
 * @param feature the part that was hit
 * @param point the contact point: on the obstacle; of two circles the point where they touch; where
 *     they overlap at the start, the point of the obstacle nearest to the centre; a coordinate
 *     beyond the range of doubles is the largest one
 * @param normal unit vector from the obstacle to the circle (of two circles: from the second to the
 *     first), each component within 1e-15 of the true one
 * @param approachSpeed the speed at which the distance falls at contact: {@code -v.n}, greater than
 *     0, unless it is smaller than the range of a double
 */
public record Impact(
    double time,
    Obstacle obstacle,
    Feature feature,
    Vec2 point,
    Vec2 normal,
    double approachSpeed) {}
