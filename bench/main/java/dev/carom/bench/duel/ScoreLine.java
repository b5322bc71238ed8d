// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

/**
 * A line of a score.
 *
 * @param text what is to be read
 * @param bad whether it tells of something that went wrong
 */
public record ScoreLine(String text, boolean bad) {}
