// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * The ring of buckets of a {@link CalendarQueue}. Each bucket is a linked list of circles; most are
 * empty or hold one circle. Bucket numbers increase without end. Numbers one turn apart share a
 * slot, so at most one turn may be in use.
 */
final class BucketRing {

  private static final int NONE = Index.NONE;

  /** No bucket: a number above all others. */
  static final int NOWHERE = Integer.MAX_VALUE;

  /** The binary logarithm of the bits in a long. */
  private static final int WORD = 6;

  /** The first circle of each bucket's list. */
  private final int[] heads;

  /**
   * One bit per bucket, set as long as a circle is in it. So no search for the next event ends at
   * an empty bucket.
   */
  private final long[] filled;

  /** The next circle in the list of each circle. */
  private final int[] after;

  /**
   * The previous circle in the list of circle i, at index i + 1. Undefined for the first circle of
   * a list; entry 0 belongs to NONE and is never read.
   */
  private final int[] before;

  /**
   * Creates an empty ring.
   *
   * @param buckets the number of buckets, a power of two and at least 64
   * @param circles the number of circles
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
    before[next + 1] = i; // written for NONE, too: no branch
    heads[at] = i;
    filled[word(bucket >> WORD)] |= 1L << bucket;
  }

  /** Removes a circle from its bucket. */
  void remove(int bucket, int i) {
    int at = slot(bucket);
    int next = after[i];
    if (heads[at] == i) {
      heads[at] = next;
      filled[word(bucket >> WORD)] &= ~((long) (next >> 31) & 1L << bucket); // if next is NONE
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

  /**
   * The circle after circle i in its list, or NONE; for a circle in no bucket, its {@linkplain
   * #mark mark}.
   */
  int next(int i) {
    return after[i];
  }

  /** Marks a circle that is in no bucket. The mark holds until the circle is added to one. */
  void mark(int i, int mark) {
    after[i] = mark;
  }

  /** Empties a bucket and returns its first circle, or NONE. */
  int drain(int bucket) {
    int at = slot(bucket);
    int i = heads[at];
    heads[at] = NONE;
    filled[word(bucket >> WORD)] &= ~(1L << bucket);
    return i;
  }

  /** The first bucket within one turn from the given one that holds a circle, or NOWHERE. */
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

  // Masked by the length of the array, so that the compiler omits range checks.

  private int slot(int bucket) {
    return bucket & (heads.length - 1);
  }

  private int word(int w) {
    return w & (filled.length - 1);
  }
}
