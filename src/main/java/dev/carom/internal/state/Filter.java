// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The codec of filters: a category and a mask, each a set of 32 bits, in one long. Two things can
 * meet if each one's mask has a bit of the other one's category. The array of a kind is null as
 * long as all of that kind have the {@link #DEFAULT}.
 */
public final class Filter {

  /** Category 1, which meets everything whose mask has that bit. */
  public static final long DEFAULT = of(1, -1);

  private Filter() {}

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

  /** The filter of number i of a kind. */
  static long of(long[] filters, int i) {
    return filters == null ? DEFAULT : filters[i];
  }

  /** So many defaults. */
  static long[] defaults(int count) {
    long[] filters = new long[count];
    Arrays.fill(filters, DEFAULT);
    return filters;
  }

  /** A copy of another length, with defaults at its end; null for null. */
  static long[] copyOf(long[] filters, int count) {
    if (filters == null) {
      return null;
    }
    long[] copy = Arrays.copyOf(filters, count);
    Arrays.fill(copy, Math.min(count, filters.length), count, DEFAULT);
    return copy;
  }

  /** The first so many filters; null if all are the default. */
  static long[] unlessDefault(long[] filters, int count) {
    for (int i = 0; filters != null && i < count; i++) {
      if (filters[i] != DEFAULT) {
        return Arrays.copyOf(filters, count);
      }
    }
    return null;
  }
}
