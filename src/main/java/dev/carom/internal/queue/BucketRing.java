// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * A ring of buckets of an {@link CalendarQueue}, each a list of circles, most of them empty or of
 * one circle. Buckets are numbered on without end; those that are one turn apart share a place, so
 * no more than one turn may be in use.
 */
final class BucketRing {

  /** No circle. */
  private static final int NONE = Index.NONE;

  /** No bucket: beyond all. */
  static final int NOWHERE = Integer.MAX_VALUE;

  /** Bits of a word: 2^6. */
  private static final int WORD = 6;

  /** The first circle of each list. */
  private final int[] heads;

  /** A bit for each bucket, set where something was added since it was taken. */
  private final long[] filled;

  /** Of each circle the one that is next in its list. */
  private final int[] after;

  /**
   * Of each circle, by its number and one, the one before it in its list, if it is not the first.
   */
  private final int[] before;

  /**
   * An empty ring.
   *
   * @param buckets how many, a power of two and at least 64
   * @param circles room for so many
   */
  BucketRing(int buckets, int circles) {
    heads = new int[buckets];
    Arrays.fill(heads, NONE);
    filled = new long[buckets >> WORD];
    after = new int[circles];
    Arrays.fill(after, NONE);
    before = new int[circles + 1];
  }

  void add(int bucket, int i) {
    int at = slot(bucket);
    int next = heads[at];
    after[i] = next;
    before[next + 1] = i; // of NONE too, which nobody asks
    heads[at] = i;
    filled[word(bucket >> WORD)] |= 1L << bucket;
  }

  /** Takes a circle out of the bucket in which it is. */
  void remove(int bucket, int i) {
    int at = slot(bucket);
    int next = after[i];
    if (heads[at] == i) {
      heads[at] = next;
      return;
    }
    int previous = before[i + 1];
    after[previous] = next;
    before[next + 1] = previous;
  }

  /** The first circle of a bucket, or NONE. */
  int first(int bucket) {
    return heads[slot(bucket)];
  }

  /** The circle after another one in its list, or NONE; or what it was marked with. */
  int next(int i) {
    return after[i];
  }

  /** Marks a circle that is in no bucket, until it is in one. */
  void mark(int i, int mark) {
    after[i] = mark;
  }

  /** Empties a bucket; returns its first circle, or NONE. */
  int drain(int bucket) {
    int at = slot(bucket);
    int i = heads[at];
    heads[at] = NONE;
    filled[word(bucket >> WORD)] &= ~(1L << bucket);
    return i;
  }

  /** The first bucket from one on, within a turn, that may hold something, or NOWHERE. */
  int filledFrom(int bucket) {
    int w = bucket >> WORD;
    int last = w + filled.length;
    long bits = filled[word(w)] & (-1L << bucket);
    while (bits == 0) {
      if (++w > last) {
        return NOWHERE;
      }
      bits = filled[word(w)];
    }
    return (w << WORD) + Long.numberOfTrailingZeros(bits);
  }

  // By the length, so that compilers know that both are in range.

  private int slot(int bucket) {
    return bucket & (heads.length - 1);
  }

  private int word(int w) {
    return w & (filled.length - 1);
  }
}
