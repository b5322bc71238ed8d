// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * Counts how often each level of precision gives the answer. Nothing is counted unless the system
 * property {@code dev.carom.rungs} is true when this class is loaded. If it is not, {@link #COUNT}
 * is a constant null, and the counting vanishes from the compiled code. Not safe for use by several
 * threads.
 */
public final class PrecisionCounters {

  public static final PrecisionCounters COUNT =
      Boolean.getBoolean("dev.carom.rungs") ? new PrecisionCounters() : null;

  /** Decisions that plain doubles left open. */
  public long doubtfulDecisions;

  /** Decisions that sums without rounding left open too. */
  public long exactDecisions;

  /** Square roots of doubles: one for each time of impact, except at walls. */
  public long roots;

  /** Corrections of a time of impact after the first one, except at walls. */
  long steps;

  /** Times of impact, including those at walls, that double-double could not round. */
  public long exactTimes;

  /** Normals of a moving disk that double-double could not round. */
  long exactNormals;

  /** Pairs of a circle and a line or peg that the broad phase tested. */
  public long pairTests;

  /** Questions about accelerated disks, one for each disk, wall or line that is asked for. */
  public long parabolas;

  /** Those among them that exact numbers answered. */
  public long exactParabolas;

  private PrecisionCounters() {}

  /** Counts a decision that goes from plain doubles to exact numbers at once. */
  public static void exactDecision() {
    doubt();
    exactNumbers();
  }

  /** Counts a decision that plain doubles leave open. */
  static void doubt() {
    if (COUNT != null) {
      COUNT.doubtfulDecisions++;
    }
  }

  /** Counts one of them that exact numbers take. */
  static void exactNumbers() {
    if (COUNT != null) {
      COUNT.exactDecisions++;
    }
  }

  /** Counts a question about an accelerated disk. */
  public static void parabola() {
    if (COUNT != null) {
      COUNT.parabolas++;
    }
  }

  /** Counts one that exact numbers answer. */
  static void exactParabola() {
    if (COUNT != null) {
      COUNT.exactParabolas++;
    }
  }

  /** Counts a square root for a time of impact. */
  public static void root() {
    if (COUNT != null) {
      COUNT.roots++;
    }
  }

  /** Counts a correction of a time of impact after the first one. */
  public static void step() {
    if (COUNT != null) {
      COUNT.steps++;
    }
  }

  /** Counts a time of impact by exact numbers. */
  static void exactTime() {
    if (COUNT != null) {
      COUNT.exactTimes++;
    }
  }

  /** Counts a normal by exact numbers. */
  public static void exactNormal() {
    if (COUNT != null) {
      COUNT.exactNormals++;
    }
  }
}
