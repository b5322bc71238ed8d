// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.internal.exact.PrecisionCounter;

/**
 * The library's counts of its rungs of precision. They are in a package that the library does not
 * export; the harness reads them on the class path.
 *
 * @param doubtfulDecisions decisions that plain doubles left open
 * @param exactDecisions of them, those that sums without rounding left open too
 * @param roots square roots of doubles
 * @param exactTimes times of impact that double-double could not round
 * @param pairTests how often a world looked at a circle and a line or peg together
 * @param falls questions about circles with an acceleration, one for each obstacle asked about
 * @param exactFalls of them, those that exact numbers answered
 */
public record RungCounts(
    long doubtfulDecisions,
    long exactDecisions,
    long roots,
    long exactTimes,
    long pairTests,
    long falls,
    long exactFalls) {

  private static final RungCounts NONE = new RungCounts(0, 0, 0, 0, 0, 0, 0);

  private static final String PROPERTY = "dev.carom.rungs";

  /**
   * Has this process count, for all its life; it is slower then. Call it before the library's first
   * query.
   *
   * @throws IllegalStateException if it is too late
   */
  public static void enable() {
    System.setProperty(PROPERTY, "true");
    if (!areEnabled()) {
      throw new IllegalStateException("the library has already been used without being counted");
    }
  }

  /** Whether this process counts, as it does if counts are enabled. */
  public static boolean areEnabled() {
    return PrecisionCounter.IS_COUNTING;
  }

  /**
   * All counts of this process so far.
   *
   * @throws IllegalStateException unless they are enabled
   */
  public static RungCounts now() {
    if (!areEnabled()) {
      throw new IllegalStateException("nothing is counted in this process");
    }
    return new RungCounts(
        PrecisionCounter.DOUBTFUL_DECISIONS.count(),
        PrecisionCounter.EXACT_DECISIONS.count(),
        PrecisionCounter.ROOTS.count(),
        PrecisionCounter.EXACT_TIMES.count(),
        PrecisionCounter.PAIR_TESTS.count(),
        PrecisionCounter.PARABOLAS.count(),
        PrecisionCounter.EXACT_PARABOLAS.count());
  }

  /**
   * All counts of this process so far, at no cost in a process that does not count: the counts, all
   * 0 unless they are enabled.
   */
  public static RungCounts soFar() {
    return areEnabled() ? now() : NONE;
  }

  /** The counts since an earlier moment. */
  public RungCounts since(RungCounts before) {
    return new RungCounts(
        doubtfulDecisions - before.doubtfulDecisions,
        exactDecisions - before.exactDecisions,
        roots - before.roots,
        exactTimes - before.exactTimes,
        pairTests - before.pairTests,
        falls - before.falls,
        exactFalls - before.exactFalls);
  }
}
