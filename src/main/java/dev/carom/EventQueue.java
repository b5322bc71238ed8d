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

  /** Is told which events come next, some time before they come. */
  interface Outlook {

    /** Takes notice of the circles whose events are next in a queue, in any order. */
    void next(EventQueue queue, int[] circles, int size);
  }

  /** No event. */
  static final int NONE = -1;

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Bits of a word: 2^6. */
  private static final int WORD = 6;

  /**
   * Events that an outlook is told of at a time, and at most where many are due at nearly one time:
   * a core waits for some dozens of reads at once.
   */
  private static final int OUTLOOK = 32;

  static final int MOST_OUTLOOK = 2 * OUTLOOK;

  private static final int LEAST_BUCKETS = 64;
  private static final int MOST_BUCKETS = 4096;

  /** Events for which one coarse bucket is made. */
  private static final int PER_BUCKET = 16;

  /**
   * Fine buckets made for each event: most then hold one event or none, and what is next is found
   * by one look at 64 bits, not by comparing events, which cannot be foretold. As long as there are
   * no more than so many, that is; beyond, one for each event.
   */
  private static final int FINE_PER_EVENT = 8;

  private static final int MANY_FINE = 1 << 16;

  /** A round, in mean times that events wait: what begins anew each time is shared by many. */
  private static final double ROUND = 16;

  /** A sum of so small parts of times does not overflow. */
  private static final double PART = 0x1p-32;

  /** More than this many times longer than the next shorter one is a length of time too long. */
  private static final double SKEW = 8;

  /** Or null. */
  private final Outlook outlook;

  private final int[] next = new int[MOST_OUTLOOK];

  /** Fine buckets before this one were told of. */
  private int lookedAt;

  private final int buckets;
  private final EntryLists coarse;
  private final EntryChains fine = new EntryChains(64, 64);

  /** When the event of each circle is due. */
  private final double[] times;

  // The calendar's beginning, and coarse buckets in a unit of time.
  private double base = -1;
  private double perBucket = 0x1p1000;
  private int current;

  // The same within the current coarse bucket.
  private double fineBase;
  private double perFine;
  private int fineBuckets = 1;
  private int currentFine = 1;

  /** Which fine buckets hold something: a bit for each. */
  private long[] filled = new long[1];

  /** The events of the current fine bucket and of those before it. */
  private final EventHeap heap;

  EventQueue(int count, Order order) {
    this(count, order, null, new int[Circles.collidingCodesAt(count)]);
  }

  /**
   * One that tells an outlook which events come next.
   *
   * @param outlook or null for none
   * @param codes the ints of so many circles: it keeps their {@link Circles#PLACE}
   */
  EventQueue(int count, Order order, Outlook outlook, int[] codes) {
    this.outlook = outlook;
    int fair = Integer.highestOneBit(Math.max(1, count / PER_BUCKET));
    buckets = Math.max(LEAST_BUCKETS, Math.min(MOST_BUCKETS, fair));
    coarse = new EntryLists(buckets + 1, buckets + 2 + count / 8);
    times = new double[count];
    Arrays.fill(times, NEVER);
    heap = new EventHeap(times, order, codes);
    current = buckets;
  }

  /**
   * Sets the event of circle i, in place of the one it had; {@code +infinity} for none. The order
   * of the old one is not asked for any more.
   */
  void set(int i, double time) {
    if (times[i] != NEVER) { // most events were taken
      heap.remove(i);
    }
    times[i] = time;
    if (time != NEVER) {
      insert(i, time);
    }
  }

  /** Takes out the event of circle i: to be done before anything changes what orders it. */
  void clear(int i) {
    heap.remove(i);
    times[i] = NEVER;
  }

  double time(int i) {
    return times[i];
  }

  /** Takes out the event of circle i, which is {@link #first}. */
  void take(int i) {
    heap.removeFirst();
    times[i] = NEVER;
  }

  /** The circle whose event is first, or NONE. */
  int first() {
    while (heap.isEmpty()) {
      if (!turn()) {
        return NONE;
      }
    }
    return heap.first();
  }

  /**
   * Whether a time is earlier than those of all events; false too if that takes a longer look than
   * at the current bucket.
   */
  boolean isBeforeAll(double time) {
    return isCurrent(time) && (heap.isEmpty() || time < times[heap.first()]);
  }

  private boolean isCurrent(double time) {
    return (int) ((time - base) * perBucket) <= current && fineBucket(time) <= currentFine;
  }

  private void insert(int i, double time) {
    int bucket = (int) ((time - base) * perBucket);
    if (bucket > current) {
      coarse.add(Math.min(bucket, buckets), i, time);
      return;
    }
    int f = fineBucket(time);
    if (f <= currentFine) {
      heap.add(i);
    } else {
      addFine(f, i, time);
    }
  }

  private void addFine(int f, int i, double time) {
    fine.add(f, i, time);
    filled[f >> WORD] |= 1L << f;
  }

  private int fineBucket(double time) {
    int f = (int) ((time - fineBase) * perFine);
    return Math.max(0, Math.min(f, fineBuckets - 1));
  }

  /** Goes on to the next bucket that holds something; false if no event is left. */
  private boolean turn() {
    currentFine = nextFilled(currentFine + 1);
    if (currentFine < fineBuckets) {
      if (outlook != null && currentFine >= lookedAt) {
        lookAhead();
      }
      drain();
      return true;
    }
    while (++current < buckets) {
      if (!coarse.isEmpty(current)) {
        deal();
        return true;
      }
    }
    current = buckets;
    return begin();
  }

  /** The first fine bucket from one on that holds something, or their number. */
  private int nextFilled(int from) {
    if (from >= fineBuckets) {
      return fineBuckets;
    }
    int word = from >> WORD;
    long bits = filled[word] & (-1L << from);
    while (bits == 0) {
      if ((++word << WORD) >= fineBuckets) {
        return fineBuckets;
      }
      bits = filled[word];
    }
    return (word << WORD) + Long.numberOfTrailingZeros(bits);
  }

  /** Tells which events come next. */
  private void lookAhead() {
    int size = 0;
    int f = currentFine;
    while (f < fineBuckets && size < OUTLOOK) {
      for (int k = fine.head(f); k != NONE && size < MOST_OUTLOOK; k = fine.next(k)) {
        next[size++] = fine.ids[k];
      }
      f = nextFilled(f + 1);
    }
    lookedAt = f;
    outlook.next(this, next, size);
  }

  private void drain() {
    filled[currentFine >> WORD] &= ~(1L << currentFine);
    int k = fine.take(currentFine);
    while (k != NONE) {
      int i = fine.ids[k];
      double time = fine.times[k];
      // A second entry for the same time finds the first one in the heap.
      if (isMeant(i, time) && (heap.isEmpty() || !heap.contains(i))) {
        heap.add(i);
      }
      k = fine.release(k);
    }
  }

  /** Deals out the current coarse bucket to fine ones. */
  private void deal() {
    int events = Integer.highestOneBit(coarse.size(current));
    fineBuckets = Math.max(events, Math.min(FINE_PER_EVENT * events, MANY_FINE));
    fine.room(fineBuckets);
    if ((filled.length << WORD) < fineBuckets) {
      filled = new long[fineBuckets >> (WORD - 1)];
    }
    fineBase = base + current / perBucket;
    perFine = perBucket * fineBuckets;
    currentFine = -1;
    lookedAt = 0;
    int chunk = coarse.take(current);
    while (chunk != EntryLists.NONE) {
      for (int k = coarse.start(chunk); k < chunk; k++) {
        double time = coarse.time(k);
        if (isMeant(coarse.id(k), time)) {
          addFine(fineBucket(time), coarse.id(k), time);
        }
      }
      chunk = coarse.release(chunk);
    }
  }

  /** Whether an entry is still that of its circle. */
  private boolean isMeant(int i, double time) {
    return times[i] == time;
  }

  /** Begins a new round with what waits beyond the last bucket. */
  private boolean begin() {
    int waiting = coarse.take(buckets);
    if (waiting == EntryLists.NONE) {
      return false;
    }
    double earliest = NEVER;
    for (int chunk = waiting; chunk != EntryLists.NONE; chunk = coarse.next(chunk)) {
      for (int k = coarse.start(chunk); k < chunk; k++) {
        if (isMeant(coarse.id(k), coarse.time(k))) {
          earliest = Math.min(earliest, coarse.time(k));
        }
      }
    }
    if (earliest < NEVER) {
      base = earliest;
      perBucket = Math.min(0x1p1000, buckets / ROUND / length(waiting, earliest));
      current = -1;
    }
    while (waiting != EntryLists.NONE) {
      for (int k = coarse.start(waiting); k < waiting; k++) {
        if (isMeant(coarse.id(k), coarse.time(k))) {
          insert(coarse.id(k), coarse.time(k));
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
      for (int chunk = waiting; chunk != EntryLists.NONE; chunk = coarse.next(chunk)) {
        for (int k = coarse.start(chunk); k < chunk; k++) {
          double wait = coarse.time(k) - earliest;
          if (wait >= 0 && wait <= limit && isMeant(coarse.id(k), coarse.time(k))) {
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
}
