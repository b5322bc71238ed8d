// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * The library's counts of its rungs of precision. The library keeps them to itself, so they are
 * read by reflection; that works on the class path, on which the harness runs.
 *
 * @param doubtfulDecisions decisions that plain doubles left open
 * @param exactDecisions of them, those that double-double left open too
 * @param roots square roots of doubles
 * @param exactTimes times of impact that double-double could not round
 * @param pairTests how often a world looked at a circle and a line or peg together
 */
public record RungCounts(
    long doubtfulDecisions, long exactDecisions, long roots, long exactTimes, long pairTests) {

  private static final RungCounts NONE = new RungCounts(0, 0, 0, 0, 0);

  private static final String PROPERTY = "dev.carom.rungs";

  /** Package-private in the library, as are its fields. */
  private static final String COUNTERS = "dev.carom.Rungs";

  /** The library's counters, found when this process first asks for them. */
  private static final class Library {

    static final VarHandle DOUBTFUL_DECISIONS = counter("doubtfulDecisions");
    static final VarHandle EXACT_DECISIONS = counter("exactDecisions");
    static final VarHandle ROOTS = counter("roots");
    static final VarHandle EXACT_TIMES = counter("exactTimes");
    static final VarHandle PAIR_TESTS = counter("pairTests");

    /** Null in a process that does not count. */
    static final Object RUNGS =
        find((lookup, type) -> lookup.findStaticVarHandle(type, "COUNT", type)).get();

    private interface Search {
      VarHandle in(MethodHandles.Lookup lookup, Class<?> type) throws ReflectiveOperationException;
    }

    private static VarHandle counter(String name) {
      return find((lookup, type) -> lookup.findVarHandle(type, name, long.class));
    }

    private static VarHandle find(Search search) {
      try {
        Class<?> type = Class.forName(COUNTERS);
        return search.in(MethodHandles.privateLookupIn(type, MethodHandles.lookup()), type);
      } catch (ReflectiveOperationException e) {
        throw new LinkageError("the library's counters are not in " + COUNTERS + " any more", e);
      }
    }

    static long read(VarHandle counter) {
      return (long) counter.get(RUNGS);
    }
  }

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

  /**
   * Whether this process counts.
   *
   * @return false unless counts are enabled
   */
  public static boolean areEnabled() {
    return Library.RUNGS != null;
  }

  /**
   * All counts of this process so far.
   *
   * @return the counts
   * @throws IllegalStateException unless they are enabled
   */
  public static RungCounts now() {
    if (!areEnabled()) {
      throw new IllegalStateException("nothing is counted in this process");
    }
    return new RungCounts(
        Library.read(Library.DOUBTFUL_DECISIONS),
        Library.read(Library.EXACT_DECISIONS),
        Library.read(Library.ROOTS),
        Library.read(Library.EXACT_TIMES),
        Library.read(Library.PAIR_TESTS));
  }

  /**
   * All counts of this process so far, at no cost in a process that does not count.
   *
   * @return the counts, all 0 unless they are enabled
   */
  public static RungCounts soFar() {
    return areEnabled() ? now() : NONE;
  }

  /**
   * What was counted since an earlier moment.
   *
   * @param before the counts then
   * @return the differences
   */
  public RungCounts since(RungCounts before) {
    return new RungCounts(
        doubtfulDecisions - before.doubtfulDecisions,
        exactDecisions - before.exactDecisions,
        roots - before.roots,
        exactTimes - before.exactTimes,
        pairTests - before.pairTests);
  }
}
