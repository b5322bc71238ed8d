// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * A calendar of at most one event for each circle. Setting, moving and taking an event cost O(1) on
 * average, whatever their number.
 *
 * <p>Two levels of buckets of equal length of time, and a small heap for the current one. Coarse
 * buckets are lists to which an event is only added, in memory that stays in the cache; the current
 * one is dealt out to fine ones. An event that is moved leaves its old entry behind: whether an
 * entry is still meant shows when its bucket's turn comes. The heap alone is kept exact, and its
 * events do not change while they are in it. Events beyond the last bucket wait in one list; when
 * the calendar is through, it begins anew, with buckets as long as suits those that wait.
 *
 * <p>Source of the calendar: G. Paul, A Complexity O(1) priority queue for event driven molecular
 * dynamics simulations, Journal of Computational Physics 221 (2007).
 */
final class EventQueue {

  /** The order of two events of the same time. */
  interface Order {
    boolean before(int i, int j);
  }

  /** No event. */
  static final int NONE = -1;

  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final int LEAST_BUCKETS = 16;
  private static final int MOST_BUCKETS = 1024;

  /** Events for which one coarse bucket is made. */
  private static final int PER_BUCKET = 16;

  /** A round, in mean times that events wait. */
  private static final double ROUND = 4;

  /** A sum of so small parts of times does not overflow. */
  private static final double PART = 0x1p-32;

  /** More than this many times longer than the next shorter one is a length of time too long. */
  private static final double SKEW = 8;

  private final Order order;
  private final int buckets;
  private final EntryLists coarse;
  private final EntryLists fine = new EntryLists(1, 1, 64);

  /** When the event of each circle is due, and its place in the heap or NONE. */
  private final double[] times;

  private final int[] place;

  // The calendar's beginning, and coarse buckets in a unit of time.
  private double base = -1;
  private double perBucket = 0x1p1000;
  private int current;

  // The same within the current coarse bucket.
  private double fineBase;
  private double perFine;
  private int fineBuckets = 1;
  private int currentFine = 1;

  private int[] heap = new int[16];
  private double[] heapTimes = new double[16];
  private int heapSize;

  EventQueue(int count, Order order) {
    this.order = order;
    int fair = Integer.highestOneBit(Math.max(1, count / PER_BUCKET));
    buckets = Math.max(LEAST_BUCKETS, Math.min(MOST_BUCKETS, fair));
    coarse = new EntryLists(buckets + 1, 16, buckets + 2 + count / 8);
    times = new double[count];
    Arrays.fill(times, NEVER);
    place = new int[count];
    Arrays.fill(place, NONE);
    current = buckets;
  }

  /**
   * Sets the event of circle i, in place of the one it had; {@code +infinity} for none. The order
   * of the old one is not asked for any more.
   */
  void set(int i, double time) {
    clear(i);
    times[i] = time;
    if (time != NEVER) {
      insert(i, time);
    }
  }

  /** Takes out the event of circle i: to be done before anything changes what orders it. */
  void clear(int i) {
    int k = place[i];
    if (k != NONE) {
      remove(k);
    }
    times[i] = NEVER;
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
    return heap[0];
  }

  private void insert(int i, double time) {
    double bucket = (time - base) * perBucket;
    if (!(bucket < current + 1)) {
      coarse.add(bucket < buckets ? (int) bucket : buckets, i, time);
      return;
    }
    int f = fineBucket(time);
    if (f <= currentFine) {
      push(i, time);
    } else {
      fine.add(f, i, time);
    }
  }

  private int fineBucket(double time) {
    double f = (time - fineBase) * perFine;
    return f < fineBuckets ? Math.max(0, (int) f) : fineBuckets - 1;
  }

  /** Goes on to the next bucket that holds something; false if no event is left. */
  private boolean turn() {
    while (++currentFine < fineBuckets) {
      if (!fine.isEmpty(currentFine)) {
        drain();
        return true;
      }
    }
    currentFine = fineBuckets;
    while (++current < buckets) {
      if (!coarse.isEmpty(current)) {
        deal();
        return true;
      }
    }
    current = buckets;
    return begin();
  }

  private void drain() {
    int chunk = fine.take(currentFine);
    while (chunk != NONE) {
      for (int k = fine.start(chunk); k < fine.end(chunk); k++) {
        int i = fine.ids[k];
        double time = fine.times[k];
        if (isMeant(i, time)) {
          push(i, time);
        }
      }
      chunk = fine.release(chunk);
    }
  }

  /** Deals out the current coarse bucket to fine ones. */
  private void deal() {
    fineBuckets = Math.max(1, Integer.highestOneBit(coarse.size(current)));
    fine.room(fineBuckets);
    fineBase = base + current / perBucket;
    perFine = perBucket * fineBuckets;
    currentFine = -1;
    int chunk = coarse.take(current);
    while (chunk != NONE) {
      for (int k = coarse.start(chunk); k < coarse.end(chunk); k++) {
        double time = coarse.times[k];
        fine.add(fineBucket(time), coarse.ids[k], time);
      }
      chunk = coarse.release(chunk);
    }
  }

  /** Whether an entry is still that of its circle, and not in the heap already. */
  private boolean isMeant(int i, double time) {
    return times[i] == time && place[i] == NONE;
  }

  /** Begins a new round with what waits beyond the last bucket. */
  private boolean begin() {
    int waiting = coarse.take(buckets);
    if (waiting == NONE) {
      return false;
    }
    double earliest = NEVER;
    for (int chunk = waiting; chunk != NONE; chunk = coarse.next(chunk)) {
      for (int k = coarse.start(chunk); k < coarse.end(chunk); k++) {
        if (isMeant(coarse.ids[k], coarse.times[k])) {
          earliest = Math.min(earliest, coarse.times[k]);
        }
      }
    }
    if (earliest < NEVER) {
      base = earliest;
      perBucket = Math.min(0x1p1000, buckets / ROUND / length(waiting, earliest));
      current = -1;
    }
    while (waiting != NONE) {
      for (int k = coarse.start(waiting); k < coarse.end(waiting); k++) {
        if (isMeant(coarse.ids[k], coarse.times[k])) {
          insert(coarse.ids[k], coarse.times[k]);
        }
      }
      waiting = coarse.release(waiting);
    }
    return earliest < NEVER;
  }

  /** The mean time from the earliest event on, of all those or of the most that are alike. */
  private double length(int waiting, double earliest) {
    double limit = NEVER;
    double mean = NEVER;
    while (true) {
      double sum = 0;
      int count = 0;
      for (int chunk = waiting; chunk != NONE; chunk = coarse.next(chunk)) {
        for (int k = coarse.start(chunk); k < coarse.end(chunk); k++) {
          double wait = coarse.times[k] - earliest;
          if (wait >= 0 && wait <= limit && isMeant(coarse.ids[k], coarse.times[k])) {
            sum += wait * PART;
            count++;
          }
        }
      }
      double shorter = sum / count / PART;
      if (!(shorter > 0) || shorter * SKEW >= mean) {
        return mean == NEVER ? shorter : mean;
      }
      mean = shorter;
      limit = shorter;
    }
  }

  private void push(int i, double time) {
    if (heapSize == heap.length) {
      heap = Arrays.copyOf(heap, 2 * heapSize);
      heapTimes = Arrays.copyOf(heapTimes, 2 * heapSize);
    }
    up(heapSize++, i, time);
  }

  private void remove(int k) {
    place[heap[k]] = NONE;
    heapSize--;
    if (k < heapSize) {
      int i = heap[heapSize];
      double time = heapTimes[heapSize];
      if (k > 0 && before(i, time, (k - 1) / 2)) {
        up(k, i, time);
      } else {
        down(k, i, time);
      }
    }
  }

  private void put(int k, int i, double time) {
    heap[k] = i;
    heapTimes[k] = time;
    place[i] = k;
  }

  /** Puts an event at place k of the heap or above. */
  private void up(int k, int i, double time) {
    int at = k;
    while (at > 0) {
      int parent = (at - 1) / 2;
      if (!before(i, time, parent)) {
        break;
      }
      put(at, heap[parent], heapTimes[parent]);
      at = parent;
    }
    put(at, i, time);
  }

  /** Puts an event at place k of the heap or below. */
  private void down(int k, int i, double time) {
    int at = k;
    while (2 * at + 1 < heapSize) {
      int child = 2 * at + 1;
      if (child + 1 < heapSize && before(heap[child + 1], heapTimes[child + 1], child)) {
        child++;
      }
      if (before(i, time, child)) {
        break;
      }
      put(at, heap[child], heapTimes[child]);
      at = child;
    }
    put(at, i, time);
  }

  private boolean before(int i, double time, int k) {
    double other = heapTimes[k];
    return time != other ? time < other : order.before(i, heap[k]);
  }
}
