// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/**
 * Counts the work of exact arithmetic per thread, so that it can be charged to a budget. A decision
 * on numbers of thousands of bits takes as long as a thousand ordinary impacts. The count depends
 * on the numbers alone, so a budget ends at the same impact on every machine.
 */
public final class ExactBudget {

  /** Bits of exact numbers that are computed in about the time of one ordinary impact, 250 ns. */
  static final int BITS_PER_IMPACT = 2048;

  /** The cost of a number besides its bits: measured, some 100 ns. */
  private static final int BITS_PER_NUMBER = 1024;

  /** Pairs of bits that are multiplied in the time of a bit: 64 times 64 in about 1 ns. */
  private static final int PAIRS_PER_BIT = 512;

  /** The cost of one contact in one sweep of a {@code Shock}: measured, some 8 ns. */
  private static final int BITS_PER_RELAXATION = 64;

  private static final ThreadLocal<ExactBudget> OF_THREAD =
      ThreadLocal.withInitial(ExactBudget::new);

  private long bits;

  private ExactBudget() {}

  /** The counter of the current thread. */
  public static ExactBudget ofThread() {
    return OF_THREAD.get();
  }

  /** Counts a number of that many bits. */
  public static void add(int bits) {
    OF_THREAD.get().bits += BITS_PER_NUMBER + bits;
  }

  /** Counts the product of two numbers of that many bits, besides its own. */
  static void addProduct(int bits, int otherBits) {
    OF_THREAD.get().bits += (long) bits * otherBits / PAIRS_PER_BIT;
  }

  /**
   * Counts a root or a quotient of a number of that many bits. Its cost is quadratic: it is
   * computed word by word.
   */
  static void addSquared(int bits) {
    OF_THREAD.get().bits += (long) bits * bits / Long.SIZE;
  }

  /** Counts the relaxation of that many contacts. */
  public static void addRelaxations(int contacts) {
    OF_THREAD.get().bits += (long) contacts * BITS_PER_RELAXATION;
  }

  /** All work so far, in bits. */
  public long bits() {
    return bits;
  }

  /** The work since {@link #bits} was {@code before}, in ordinary impacts. */
  public long impactsSince(long before) {
    return bits == before ? 0 : (bits - before) / BITS_PER_IMPACT; // the usual case: no exact work
  }
}
