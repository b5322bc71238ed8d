// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * Counts the work of exact arithmetic, by thread, so that a budget of work can hold it: a decision
 * on numbers of thousands of bits takes as long as a thousand ordinary impacts. The count depends
 * on the numbers alone, so a budget ends at the same impact everywhere.
 */
public final class ExactBudget {

  /** Bits of exact numbers that are made in about the time of one ordinary impact, 250 ns. */
  static final int BITS_PER_IMPACT = 2048;

  /** What a number takes beside its bits: measured, some 100 ns. */
  private static final int BITS_PER_NUMBER = 1024;

  /** What one contact takes in one sweep of an {@code InelasticShock}: measured, some 8 ns. */
  private static final int BITS_PER_RELAXATION = 64;

  private static final ThreadLocal<ExactBudget> OF_THREAD =
      ThreadLocal.withInitial(ExactBudget::new);

  private long bits;

  private ExactBudget() {}

  /** The count of this thread. */
  public static ExactBudget ofThread() {
    return OF_THREAD.get();
  }

  /** Counts a number of so many bits. */
  public static void add(int bits) {
    OF_THREAD.get().bits += BITS_PER_NUMBER + bits;
  }

  /** Counts a root or a quotient of a number of so many bits, which are computed word by word. */
  static void addSquared(int bits) {
    OF_THREAD.get().bits += (long) bits * bits / Long.SIZE;
  }

  /** Counts the relaxation of so many contacts. */
  public static void addRelaxations(int contacts) {
    OF_THREAD.get().bits += (long) contacts * BITS_PER_RELAXATION;
  }

  /** All work so far, in bits. */
  public long bits() {
    return bits;
  }

  /** The work since there were so many bits, in ordinary impacts. */
  public long impactsSince(long before) {
    return bits == before ? 0 : (bits - before) / BITS_PER_IMPACT; // as a rule there is none
  }
}
