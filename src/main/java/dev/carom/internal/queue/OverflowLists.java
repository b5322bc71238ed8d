// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import java.util.Arrays;

/**
 * Lists of entries of an {@link CalendarQueue}, each a circle and a time. A list is a chain of
 * chunks of entries, all full but the one to which entries are added; what is taken is given back,
 * and serves again while it is still in the cache.
 *
 * <p>A chunk is named by the end of its entries, one more than the place of its last one, which
 * tells how many it holds.
 */
final class OverflowLists {

  /** The end of no chunk. */
  static final int NONE = 0;

  /** Entries of a chunk: 2^4. */
  private static final int SHIFT = 4;

  private static final int CHUNK = 1 << SHIFT;

  /** Of each entry its time, and its circle as a whole number: they are read together. */
  private double[] entries;

  /** Of each list the end of the chunk to which it adds. */
  private final int[] ends;

  /** Of each chunk the end of the one that follows in its list. */
  private int[] next;

  /** The end of a free chunk, if it were full. */
  private int free;

  OverflowLists(int lists, int chunks) {
    ends = new int[lists];
    entries = new double[chunks * CHUNK * 2];
    next = new int[chunks];
    free(0);
  }

  private void free(int from) {
    for (int c = next.length - 1; c >= from; c--) {
      next[c] = free;
      free = (c + 1) << SHIFT;
    }
  }

  void add(int list, int id, double time) {
    int k = ends[list];
    if ((k & (CHUNK - 1)) == 0) {
      k = chunkAfter(k);
    }
    entries[2 * k] = time;
    entries[2 * k + 1] = id;
    ends[list] = k + 1;
  }

  /** The start of a new chunk for a list that is full or empty. */
  private int chunkAfter(int end) {
    if (free == NONE) {
      int chunks = next.length;
      next = Arrays.copyOf(next, 2 * chunks);
      entries = Arrays.copyOf(entries, 2 * entries.length);
      free(chunks);
    }
    int start = start(free);
    free = next[start >> SHIFT];
    next[start >> SHIFT] = end;
    return start;
  }

  double time(int k) {
    return entries[2 * k];
  }

  int id(int k) {
    return (int) entries[2 * k + 1];
  }

  boolean isEmpty(int list) {
    return ends[list] == NONE;
  }

  /** Takes a list's chunks: the end of the first one, or NONE. */
  int drain(int list) {
    int end = ends[list];
    ends[list] = NONE;
    return end;
  }

  /** Where the entries of a chunk start. */
  int start(int end) {
    return (end - 1) & -CHUNK;
  }

  int next(int end) {
    return next[start(end) >> SHIFT];
  }

  /** Gives a chunk back, and returns the next one of its list. */
  int release(int end) {
    int c = start(end) >> SHIFT;
    int following = next[c];
    next[c] = free;
    free = (c + 1) << SHIFT;
    return following;
  }
}
