// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The {@link ContactFlags} and the {@link FilterBits} of each thing of a kind, by its number. Most
 * things have no flag and the default filter: an array reaches to the last one that has another.
 */
final class TraitColumns {

  private static final byte[] NO_FLAGS = {};
  private static final long[] NO_FILTERS = {};

  private byte[] flags = NO_FLAGS;
  private long[] filters = NO_FILTERS;

  TraitColumns copy() {
    TraitColumns copy = new TraitColumns();
    copy.flags = areFlagged() ? flags.clone() : flags;
    copy.filters = areFiltered() ? filters.clone() : filters;
    return copy;
  }

  /** The columns of some of the things, which get the numbers from 0 on. */
  TraitColumns of(int[] some) {
    TraitColumns its = new TraitColumns();
    for (int k = 0; k < some.length; k++) {
      its.setFlags(k, flags(some[k]));
      its.setFilter(k, filter(some[k]));
    }
    return its;
  }

  int flags(int i) {
    return i < flags.length ? flags[i] : 0;
  }

  long filter(int i) {
    return areFiltered() && i < filters.length ? filters[i] : FilterBits.DEFAULT;
  }

  /** Whether any thing may have a flag. */
  boolean areFlagged() {
    return flags != NO_FLAGS;
  }

  /** Whether any thing may have a filter other than the default. */
  boolean areFiltered() {
    return filters != NO_FILTERS;
  }

  void setFlags(int i, int its) {
    if (its != flags(i)) {
      flags = i < flags.length ? flags : Arrays.copyOf(flags, 2 * i + 2);
      flags[i] = (byte) its;
    }
  }

  void setFilter(int i, long its) {
    if (its != filter(i)) {
      int known = filters.length;
      filters = i < known ? filters : Arrays.copyOf(filters, 2 * i + 2);
      Arrays.fill(filters, known, filters.length, FilterBits.DEFAULT);
      filters[i] = its;
    }
  }

  /** The filters of the first so many things; null if each is the default. */
  long[] filters(int count) {
    for (int i = 0; i < Math.min(count, filters.length); i++) {
      if (filters[i] != FilterBits.DEFAULT) {
        long[] all = Arrays.copyOf(filters, count);
        Arrays.fill(all, Math.min(count, filters.length), count, FilterBits.DEFAULT);
        return all;
      }
    }
    return null;
  }
}
