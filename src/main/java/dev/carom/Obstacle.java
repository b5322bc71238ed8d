// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * An {@code Obstacle} is something that a moving circle can hit: a {@link Line}, one of its {@link
 * Endpoint}s, a peg (a static {@link Circle}) or the walls of {@link Bounds}. Obstacles do not
 * move.
 */
public sealed interface Obstacle permits Line, Endpoint, Circle, Bounds {}
