// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import java.util.Arrays;

/**
 * Append-only lists of entries of a {@link CalendarQueue}, each entry a circle and a time. A list
 * is a chain of chunks. All chunks but the one that is appended to are full. Released chunks are
 * reused first, while they are still in the cache.
 *
 * <p>A chunk is named by the end of its entries, the index after its last one. So its name also
 * gives the number of its entries.
 */
final class OverflowLists {

  /** The name of no chunk. */
  static final int NONE = 0;

  /** The binary logarithm of the entries in a chunk. */
  private static final int SHIFT = 4;

  private static final int CHUNK = 1 << SHIFT;

  /**
   * The time of each entry and, as a double, its circle. They are adjacent because they are read
   * together.
   */
  private double[] entries;

  /** The chunk that each list appends to. */
  private final int[] ends;

  /** The chunk that follows each chunk in its list. */
  private int[] next;

  /** The first free chunk, named as if it were full. */
  private int free;

  /** The number of chunks in use. */
  private int used;

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

  /** Links a new chunk into a list that is full or empty; returns the start of the chunk. */
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
    used++;
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

  /** Empties a list; returns its first chunk, or NONE. */
  int drain(int list) {
    int end = ends[list];
    ends[list] = NONE;
    return end;
  }

  /** The index of the first entry of a chunk. */
  int start(int end) {
    return (end - 1) & -CHUNK;
  }

  int next(int end) {
    return next[start(end) >> SHIFT];
  }

  /** Frees a chunk; returns the next one of its list. */
  int release(int end) {
    int c = start(end) >> SHIFT;
    int following = next[c];
    next[c] = free;
    free = (c + 1) << SHIFT;
    used--;
    return following;
  }

  /** The number of chunks in use. */
  int used() {
    return used;
  }
}
