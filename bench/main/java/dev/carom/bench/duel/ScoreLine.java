// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

/**
 * A line of a score.
 *
 * @param text the words
 * @param bad whether it reports a failure
 */
public record ScoreLine(String text, boolean bad) {}
