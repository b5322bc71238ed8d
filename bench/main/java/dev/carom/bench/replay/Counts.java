// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.bench.methods.Method;

/**
 * Events of one replay. They are the same each time, so they are counted once, untimed.
 *
 * @param impacts with lines and pegs
 * @param wallImpacts with the walls of the bounds
 * @param squareRoots spent on them
 */
public record Counts(long impacts, long wallImpacts, long squareRoots) {

  /**
   * Plays and counts.
   *
   * @param method a scene at time 0
   * @return the sums over all frames
   */
  static Counts of(Method method, int frames) {
    long impacts = 0;
    long wallImpacts = 0;
    long squareRoots = 0;
    for (int frame = 0; frame < frames; frame++) {
      method.frame();
      impacts += method.impacts();
      wallImpacts += method.wallImpacts();
      squareRoots += method.squareRoots();
    }
    return new Counts(impacts, wallImpacts, squareRoots);
  }
}
