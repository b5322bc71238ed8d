// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * The codec of filters: a category and a mask, each a set of 32 bits, in one long. Two things can
 * meet if each one's mask has a bit of the other one's category.
 */
public final class FilterBits {

  /** Category 1, which meets everything whose mask has that bit. */
  public static final long DEFAULT = of(1, -1);

  private FilterBits() {}

  public static long of(int category, int mask) {
    return (long) category << Integer.SIZE | Integer.toUnsignedLong(mask);
  }

  public static int category(long filter) {
    return (int) (filter >>> Integer.SIZE);
  }

  public static int mask(long filter) {
    return (int) filter;
  }

  /** Whether two things can meet. */
  public static boolean meet(long a, long b) {
    // The category of a and the mask of b; the mask of a and the category of b.
    long common = a & Long.rotateLeft(b, Integer.SIZE);
    return common >>> Integer.SIZE != 0 && (int) common != 0;
  }
}
