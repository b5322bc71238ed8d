// SPDX-License-Identifier: Apache-2.0

/**
 * Series of scenes along an axis, played by methods that take turns. The sweep has the figures of
 * the published experiment: the time of a frame against the number of circles, their radius, the
 * number of lines, and the impacts of the frame. The scale has time and memory against the number
 * of circles, up to a million. The features have time and memory of one scene with ever more in
 * use.
 */
package dev.carom.bench.series;
