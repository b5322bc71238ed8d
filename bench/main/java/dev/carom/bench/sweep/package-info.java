// SPDX-License-Identifier: Apache-2.0
/**
 * The figures of the published experiment: the time of a frame against the number of circles, their
 * radius, the number of lines, and the impacts of the frame.
 */
package dev.carom.bench.sweep;
