// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * Lists of entries of an {@link EventQueue}, each a circle and a time. A list is a chain of chunks
 * of entries; what is taken is given back, and serves again while it is still in the cache.
 */
final class EntryLists {

  private static final int NONE = EventQueue.NONE;

  private final int chunk;
  int[] ids;
  double[] times;

  /** Of each chunk: the one that follows in its list, and how many entries it holds. */
  private int[] next;

  private int[] filled;
  private final int[] heads;
  private int free;

  EntryLists(int lists, int chunk, int chunks) {
    this.chunk = chunk;
    heads = new int[lists];
    Arrays.fill(heads, NONE);
    ids = new int[chunks * chunk];
    times = new double[chunks * chunk];
    next = new int[chunks];
    filled = new int[chunks];
    free = NONE;
    free(0);
  }

  private void free(int from) {
    for (int c = next.length - 1; c >= from; c--) {
      next[c] = free;
      free = c;
    }
  }

  void add(int list, int id, double time) {
    int c = heads[list];
    if (c == NONE || filled[c] == chunk) {
      c = chunkFor(list);
    }
    int k = c * chunk + filled[c]++;
    ids[k] = id;
    times[k] = time;
  }

  private int chunkFor(int list) {
    if (free == NONE) {
      int chunks = next.length;
      next = Arrays.copyOf(next, 2 * chunks);
      filled = Arrays.copyOf(filled, 2 * chunks);
      ids = Arrays.copyOf(ids, 2 * chunks * chunk);
      times = Arrays.copyOf(times, 2 * chunks * chunk);
      free(chunks);
    }
    int c = free;
    free = next[c];
    next[c] = heads[list];
    filled[c] = 0;
    heads[list] = c;
    return c;
  }

  boolean isEmpty(int list) {
    return heads[list] == NONE;
  }

  /** The number of entries of a list. */
  int size(int list) {
    int size = 0;
    for (int c = heads[list]; c != NONE; c = next[c]) {
      size += filled[c];
    }
    return size;
  }

  /** Takes a list's chunks: the first one, or NONE. */
  int take(int list) {
    int c = heads[list];
    heads[list] = NONE;
    return c;
  }

  /** Where the entries of a chunk start. */
  int start(int c) {
    return c * chunk;
  }

  /** Where they end. */
  int end(int c) {
    return c * chunk + filled[c];
  }

  int next(int c) {
    return next[c];
  }

  /** Gives a chunk back, and returns the next one of its list. */
  int release(int c) {
    int following = next[c];
    next[c] = free;
    free = c;
    return following;
  }
}
