// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * A calendar of at most one event for each circle: buckets of equal length of time, and a small
 * heap for the current one. Setting, moving and taking an event cost O(1) on average, whatever
 * their number.
 *
 * <p>Events are ordered by time (head, then tail), and at equal times by a rank that the caller
 * gives. Those beyond the last bucket wait in one list; when the calendar is through, it begins
 * anew, with buckets as long as the events of the last round were apart. Source: G. Paul, A
 * Complexity O(1) priority queue for event driven molecular dynamics simulations, Journal of
 * Computational Physics 221 (2007).
 */
final class EventQueue {

  /** No event. */
  static final int NONE = -1;

  // Where an event is, if not in a bucket: nowhere, or at place IN_HEAP - place of the heap.
  private static final int NOWHERE = -1;
  private static final int IN_HEAP = -2;

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final int buckets;
  private final int beyond;
  private final int[] heads;
  private final int[] next;
  private final int[] previous;
  private final int[] place;
  private final double[] times;
  private final double[] tails;
  private final long[] ranks;

  private double base;
  private double perBucket = 1;
  private int current;

  // A heap of the events at or before the current bucket.
  private int[] heapIds = new int[16];
  private double[] heapTimes = new double[16];
  private int heapSize;

  EventQueue(int count) {
    buckets = Math.max(16, Integer.highestOneBit(Math.max(1, count)) * 2);
    beyond = buckets;
    heads = new int[buckets + 1];
    Arrays.fill(heads, NONE);
    next = new int[count];
    previous = new int[count];
    place = new int[count];
    Arrays.fill(place, NOWHERE);
    times = new double[count];
    Arrays.fill(times, NEVER);
    tails = new double[count];
    ranks = new long[count];
    current = buckets;
  }

  /** Sets the event of circle i, in place of the one it had; {@code +infinity} for none. */
  void set(int i, double time, double tail, long rank) {
    if (place[i] >= 0) {
      unlink(i);
    } else if (place[i] <= IN_HEAP) {
      remove(IN_HEAP - place[i]);
    }
    times[i] = time;
    tails[i] = tail;
    ranks[i] = rank;
    insert(i);
  }

  double time(int i) {
    return times[i];
  }

  /** The circle whose event is first, or NONE. */
  int first() {
    while (heapSize == 0) {
      if (!turn()) {
        return NONE;
      }
    }
    return heapIds[0];
  }

  private void insert(int i) {
    double t = times[i];
    if (t == NEVER) {
      place[i] = NOWHERE;
      return;
    }
    double bucket = (t - base) * perBucket;
    if (bucket < current + 1) {
      push(i);
    } else {
      link(i, bucket < buckets ? (int) bucket : beyond);
    }
  }

  /** Goes to the next bucket that holds something; false if no event is left. */
  private boolean turn() {
    while (++current < buckets) {
      if (heads[current] != NONE) {
        drain(current);
        return true;
      }
    }
    return begin();
  }

  private void drain(int bucket) {
    for (int i = heads[bucket]; i != NONE; i = next[i]) {
      push(i);
    }
    heads[bucket] = NONE;
  }

  /** Begins a new round with what waits beyond the last bucket. */
  private boolean begin() {
    int waiting = heads[beyond];
    current = buckets - 1;
    if (waiting == NONE) {
      return false;
    }
    double earliest = NEVER;
    double sum = 0;
    int count = 0;
    for (int i = waiting; i != NONE; i = next[i]) {
      earliest = Math.min(earliest, times[i]);
      sum += times[i];
      count++;
    }
    double mean = sum / count - earliest;
    perBucket = mean > 0 && mean < NEVER ? count / mean : 1;
    if (!(perBucket < 0x1p1000)) {
      perBucket = 0x1p1000;
    }
    base = earliest;
    current = 0;
    heads[beyond] = NONE;
    for (int i = waiting; i != NONE; ) {
      int following = next[i];
      insert(i);
      i = following;
    }
    return true;
  }

  private void link(int i, int bucket) {
    int head = heads[bucket];
    next[i] = head;
    previous[i] = NONE;
    if (head != NONE) {
      previous[head] = i;
    }
    heads[bucket] = i;
    place[i] = bucket;
  }

  private void unlink(int i) {
    if (previous[i] == NONE) {
      heads[place[i]] = next[i];
    } else {
      next[previous[i]] = next[i];
    }
    if (next[i] != NONE) {
      previous[next[i]] = previous[i];
    }
  }

  private void push(int i) {
    if (heapSize == heapIds.length) {
      heapIds = Arrays.copyOf(heapIds, 2 * heapSize);
      heapTimes = Arrays.copyOf(heapTimes, 2 * heapSize);
    }
    put(heapSize, i, times[i]);
    up(heapSize++);
  }

  private void remove(int k) {
    heapSize--;
    if (k < heapSize) {
      put(k, heapIds[heapSize], heapTimes[heapSize]);
      up(k);
      down(k);
    }
  }

  private void put(int k, int i, double time) {
    heapIds[k] = i;
    heapTimes[k] = time;
    place[i] = IN_HEAP - k;
  }

  private void up(int k) {
    while (k > 0 && before(k, (k - 1) / 2)) {
      swap(k, (k - 1) / 2);
      k = (k - 1) / 2;
    }
  }

  private void down(int k) {
    while (2 * k + 1 < heapSize) {
      int child = 2 * k + 1;
      if (child + 1 < heapSize && before(child + 1, child)) {
        child++;
      }
      if (!before(child, k)) {
        return;
      }
      swap(k, child);
      k = child;
    }
  }

  private boolean before(int a, int b) {
    double ta = heapTimes[a];
    double tb = heapTimes[b];
    if (ta != tb) {
      return ta < tb;
    }
    int i = heapIds[a];
    int j = heapIds[b];
    return tails[i] != tails[j] ? tails[i] < tails[j] : ranks[i] < ranks[j];
  }

  private void swap(int a, int b) {
    int id = heapIds[a];
    double time = heapTimes[a];
    put(a, heapIds[b], heapTimes[b]);
    put(b, id, time);
  }
}
