// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * An {@code Obstacle} is the shape of something that a moving circle can hit. It is a {@link Line}
 * with its endpoints, an {@link Outline} of joined lines, a {@link Circle} (a peg, another circle,
 * or, of radius 0, a point) or the walls of {@link Bounds}. It holds a place at one moment; in a
 * world lines and pegs may have a velocity.
 */
public sealed interface Obstacle permits Line, Outline, Circle, Bounds {}
