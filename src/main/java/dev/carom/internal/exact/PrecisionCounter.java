// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * Counts how often each level of precision gives the answer. Nothing is counted unless the system
 * property {@code dev.carom.rungs} is true when this class is loaded. If it is not, the counting
 * vanishes from the compiled code. Not safe for use by several threads.
 */
public enum PrecisionCounter {
  /** Decisions that plain doubles left open. */
  DOUBTFUL_DECISIONS,

  /** Decisions that sums without rounding left open too. */
  EXACT_DECISIONS,

  /** Square roots of doubles: one for each time of impact, except at walls. */
  ROOTS,

  /** Times of impact, including those at walls, that double-double could not round. */
  DOUBTFUL_TIMES,

  /** Those among them that sums without rounding left open, too. */
  EXACT_TIMES,

  /** Normals of a moving disk that double-double could not round. */
  EXACT_NORMALS,

  /** Pairs of a circle and a line or peg that the broad phase tested. */
  PAIR_TESTS,

  /** Questions about accelerated disks, one for each disk, wall or line that is asked for. */
  PARABOLAS,

  /** Those among them that the quick filter left to the certified search. */
  SEARCHED_PARABOLAS,

  /** Those among them that exact numbers answered. */
  EXACT_PARABOLAS;

  public static final boolean IS_COUNTING = Boolean.getBoolean("dev.carom.rungs");

  private static final long[] COUNTS = new long[values().length];

  /** Counts one more. */
  public void add() {
    add(1);
  }

  public void add(int more) {
    if (IS_COUNTING) {
      COUNTS[ordinal()] += more;
    }
  }

  public long count() {
    return COUNTS[ordinal()];
  }
}
