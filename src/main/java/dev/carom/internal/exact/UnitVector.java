// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * A unit vector in the plane.
 *
 * @param x the first component
 * @param y the second component
 */
public record UnitVector(double x, double y) {}
