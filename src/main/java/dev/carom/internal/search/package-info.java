// SPDX-License-Identifier: Apache-2.0
/**
 * What a flight hits first: the search among all obstacles, and its indexes. {@code FirstImpact}
 * has the rules of ties, filters and sensors, {@code OneWay} that of one-way lines, {@code
 * CellWalk} the walk of the grid. {@code searchAmongAll} of {@link
 * dev.carom.internal.search.FlightSearch} chooses the obstacles that move, and {@code
 * considerMotion} of each search tests one.
 */
package dev.carom.internal.search;
