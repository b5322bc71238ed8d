// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * Lists of entries of an {@link EventQueue}, each a circle and a time, most of them empty or of one
 * entry: see {@link EntryLists} for long ones.
 */
final class EntryChains {

  private static final int NONE = EventQueue.NONE;

  int[] ids;
  double[] times;

  /** Of each entry: the one that follows in its list. */
  private int[] next;

  private int[] heads;
  private int free;

  EntryChains(int lists, int entries) {
    heads = new int[lists];
    Arrays.fill(heads, NONE);
    ids = new int[entries];
    times = new double[entries];
    next = new int[entries];
    free = NONE;
    free(0);
  }

  private void free(int from) {
    for (int k = next.length - 1; k >= from; k--) {
      next[k] = free;
      free = k;
    }
  }

  /** Makes room for so many lists; they are empty. */
  void room(int lists) {
    if (lists > heads.length) {
      heads = new int[2 * lists];
      Arrays.fill(heads, NONE);
    }
  }

  void add(int list, int id, double time) {
    if (free == NONE) {
      grow();
    }
    int k = free;
    free = next[k];
    ids[k] = id;
    times[k] = time;
    next[k] = heads[list];
    heads[list] = k;
  }

  private void grow() {
    int entries = next.length;
    ids = Arrays.copyOf(ids, 2 * entries);
    times = Arrays.copyOf(times, 2 * entries);
    next = Arrays.copyOf(next, 2 * entries);
    free(entries);
  }

  /** A list's first entry, or NONE. */
  int head(int list) {
    return heads[list];
  }

  int next(int k) {
    return next[k];
  }

  /** Takes a list's entries: the first one, or NONE. */
  int take(int list) {
    int k = heads[list];
    heads[list] = NONE;
    return k;
  }

  /** Gives an entry back, and returns the next one of its list. */
  int release(int k) {
    int following = next[k];
    next[k] = free;
    free = k;
    return following;
  }
}
