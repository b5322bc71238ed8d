// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * Everything that determines the future of a world. Two states are equal if they are the same to
 * the bit.
 *
 * @param now the time of the world
 * @param collide whether circles collide with each other
 * @param obstacles the walls, lines and pegs
 * @param registry the circles
 * @param limits the largest coordinate and the least radius that the world ever had
 * @param flights the flights of the circles
 * @param tailOfEdit the tail of the time of the next edit. It is above 0 if events after the head
 *     of that time precede the edit
 * @param gx the x component of gravity
 * @param gy its y component
 */
public record WorldState(
    double now,
    boolean collide,
    ObstacleTable obstacles,
    CircleRegistry registry,
    SizeLimits limits,
    FlightTable flights,
    double tailOfEdit,
    double gx,
    double gy) {}
