// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * A calendar queue with at most one event per circle. Setting, moving and polling an event take
 * O(1) on average, whatever the number of events.
 *
 * <p>A ring of buckets of equal duration holds the events of two spans of time. There are several
 * buckets per event, so most hold one event or none, and the ring stays in the cache. A small heap
 * holds the events of the current bucket and of all before it.
 *
 * <p>Later events wait in overflow lists, one per span. These lists are append-only: a rescheduled
 * event leaves its old entry behind. Stale entries are skipped when their list is distributed into
 * the consumed half of the ring. One more list holds the events beyond the last span. When all
 * spans are consumed, or the heap or the lists are crowded, a new round begins, with a bucket width
 * that suits the waiting events.
 *
 * <p>Source of the calendar: G. Paul, A Complexity O(1) priority queue for event driven molecular
 * dynamics simulations, Journal of Computational Physics 221 (2007).
 */
public final class CalendarQueue {

  /** Receives the next events some time before they are polled, to prefetch their data. */
  public interface Prefetcher {

    /** Announces the circles whose events are next in the queue, in any order. */
    void next(CalendarQueue queue, int[] circles, int size);
  }

  private static final int NONE = Index.NONE;

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * Events per prefetch: a core has some dozens of reads in flight at once. More are announced, up
   * to {@link #MOST_PREFETCHED}, if many are due at almost the same time.
   */
  private static final int PREFETCHED = 32;

  public static final int MOST_PREFETCHED = 2 * PREFETCHED;

  /** Buckets whose heads are collected before the rest of their lists. */
  private static final int PREFETCH_STEP = 8;

  /** Buckets per event within the mean waiting time. The next event is found by one set bit. */
  private static final int PER_EVENT = 4;

  /**
   * Duration of a round in mean waiting times. A long round spreads the cost of beginning it over
   * many events.
   */
  private static final int ROUND_LENGTH = 16;

  /**
   * The least number of spans in a round, and the number used unless the next limits shorten the
   * spans.
   */
  private static final int SPANS = 8;

  private static final int MOST_SPANS = 1 << 15;

  /** The largest number of buckets in a round: bucket numbers must fit in an int. */
  private static final int MOST_BUCKETS = 1 << 30;

  // Buckets per span, as long as MOST_SPANS is not exceeded: so few that the ring stays in the
  // cache. With prefetch the circles do not fit in the cache. Then there are so few that the values
  // read when a list is distributed are still cached when their events are polled.
  private static final int LEAST_IN_SPAN = 32;
  private static final int MANY_IN_SPAN = 1 << 13;
  private static final int MANY_WITH_PREFETCH = 1 << 11;

  /** With more events in the heap than this a new round begins, unless it just did. */
  private static final int HEAP_CROWDED = 32;

  /**
   * The same with lists so many times longer than they are made for. Where time hardly goes on, as
   * among circles that are squeezed, stale entries would else pile up without end.
   */
  private static final int LISTS_CROWDED = 8;

  /** Scales waiting times so that their sum does not overflow. */
  private static final double WAIT_SCALE = 0x1p-32;

  /**
   * A mean waiting time is dominated by a few long ones if it exceeds the mean of those below it by
   * more than this factor.
   */
  private static final double SKEW_LIMIT = 8;

  /** The mark of an event that waits in an overflow list. */
  private static final int IN_OVERFLOW = NONE - 1;

  /** Null if nothing is prefetched. */
  private final Prefetcher prefetcher;

  private final int[] upcoming = new int[MOST_PREFETCHED + PREFETCH_STEP + 1];

  /** The first bucket whose events have yet to be prefetched; NOWHERE without a prefetcher. */
  private int prefetchedTo;

  /** The time of each circle's event, {@code +infinity} for none. */
  private final double[] times;

  private final BucketRing ring;

  /** The number of buckets in a span, and its binary logarithm. */
  private final int span;

  private final int inSpan;

  private final int spans;

  /** One list for each span, then one for the events beyond the last span. */
  private final OverflowLists lists;

  private final int mostChunks;

  // The start time of the round, buckets per unit of time, the current bucket, and the first bucket
  // that is not on the ring yet.
  private double base = -1;
  private double perUnit = 0x1p1000;
  private int current = -1;
  private int end;

  /** From this bucket on, the ring has to be refilled or events have to be prefetched. */
  private int limit;

  /** The events of the current bucket and of all buckets before it. */
  private final EventHeap heap;

  /** Events polled since the round began, and events that the round began with. */
  private long polled;

  private int atFirst;

  private double polledTime;

  /** Sink for prefetched values. Without a use of them the compiler would remove the loads. */
  @SuppressWarnings("UnusedVariable")
  private double read;

  public CalendarQueue(int count, EventOrder order) {
    this(count, order, null, new int[CircleTable.collidingCodesAt(count)]);
  }

  /**
   * Creates a queue that announces its next events.
   *
   * @param prefetcher null for none
   * @param codes the int rows of that many circles; the queue keeps {@link CircleTable#HEAP_INDEX}
   *     in them
   */
  public CalendarQueue(int count, EventOrder order, Prefetcher prefetcher, int[] codes) {
    this.prefetcher = prefetcher;
    long round = Math.min((long) ROUND_LENGTH * PER_EVENT * count, MOST_BUCKETS);
    int many = prefetcher == null ? MANY_IN_SPAN : MANY_WITH_PREFETCH;
    long fair = Math.max(Math.min(round / SPANS, many), round / MOST_SPANS);
    inSpan = logarithm(Math.max(LEAST_IN_SPAN, fair));
    span = 1 << inSpan;
    spans = Math.max(SPANS, (int) (round >> inSpan));
    ring = new BucketRing(2 * span, count);
    int chunks = spans + 2 + count / 8;
    lists = new OverflowLists(spans + 1, chunks);
    mostChunks = LISTS_CROWDED * chunks;
    end = spans << inSpan; // before the first round every event is beyond the last span
    times = new double[count];
    Arrays.fill(times, NEVER);
    heap = new EventHeap(times, order, codes);
  }

  /** The least n with 2^n at least x. */
  private static int logarithm(long x) {
    return Long.SIZE - Long.numberOfLeadingZeros(x - 1);
  }

  public double time(int i) {
    return times[i];
  }

  /** Sets the event of circle i and replaces the previous one; {@code +infinity} for none. */
  public void set(int i, double time) {
    if (times[i] != NEVER) { // false for most: their event was polled
      clear(i);
    }
    times[i] = time;
    if (time != NEVER) {
      insert(i, time);
    }
  }

  /**
   * Removes the event of circle i. Must be called before anything changes that orders the event.
   */
  public void clear(int i) {
    double time = times[i];
    if (time == NEVER) {
      return;
    }
    if (ring.next(i) == IN_OVERFLOW) {
      ring.mark(i, NONE);
    } else if (heap.contains(i)) {
      heap.remove(i);
    } else {
      ring.remove(bucket(time), i);
    }
    times[i] = NEVER;
  }

  /** Removes the first event if it is due by the given time. */
  public int poll(double last) {
    spread();
    while (heap.isEmpty()) {
      int bucket = nextBucket();
      if (bucket == BucketRing.NOWHERE) {
        return NONE;
      }
      int i = ring.first(bucket);
      if (ring.next(i) != NONE) {
        turnTo(bucket);
      } else { // the usual case: the only event of its bucket
        return times[i] <= last ? pollAlone(bucket, i) : NONE;
      }
    }
    int i = heap.first();
    if (times[i] > last) {
      return NONE;
    }
    heap.removeFirst();
    return poll(i);
  }

  /** The circle whose event is first, or NONE. */
  public int first() {
    spread();
    while (heap.isEmpty()) {
      int bucket = nextBucket();
      if (bucket == BucketRing.NOWHERE) {
        return NONE;
      }
      turnTo(bucket);
    }
    return heap.first();
  }

  private int pollAlone(int bucket, int i) {
    current = bucket;
    ring.drain(bucket);
    return poll(i);
  }

  private int poll(int i) {
    polledTime = times[i];
    times[i] = NEVER;
    polled++;
    return i;
  }

  /** The time of the event polled last. */
  public double polledTime() {
    return polledTime;
  }

  /**
   * Whether a time is earlier than those of all events. May return false wrongly if the answer
   * needs more than the current bucket.
   */
  public boolean isBeforeAll(double time) {
    return bucket(time) <= current && (heap.isEmpty() || time < times[heap.first()]);
  }

  private int bucket(double time) {
    return (int) ((time - base) * perUnit);
  }

  private void insert(int i, double time) {
    int bucket = bucket(time);
    if (bucket <= current) {
      heap.add(i);
    } else if (bucket < end) {
      ring.add(bucket, i);
    } else {
      list(Math.min(bucket >> inSpan, spans), i, time);
    }
  }

  private void list(int list, int i, double time) {
    lists.add(list, i, time);
    ring.mark(i, IN_OVERFLOW);
  }

  /** How long the overflow lists are, in chunks. */
  int overflow() {
    return lists.used();
  }

  /** Whether an entry of an overflow list is not stale. */
  private boolean isCurrent(int i, double time) {
    return times[i] == time && ring.next(i) == IN_OVERFLOW;
  }

  /** The next bucket that holds an event, or NOWHERE if no event is left. */
  private int nextBucket() {
    int bucket = ring.filledFrom(current + 1);
    return bucket < limit ? bucket : goFurther(bucket);
  }

  /**
   * Continues {@link #nextBucket} where the ring is empty, half of it is consumed, or a prefetch is
   * due.
   */
  private int goFurther(int from) {
    int bucket = from;
    while (bucket == BucketRing.NOWHERE) {
      if (!skip()) {
        return bucket;
      }
      bucket = ring.filledFrom(current + 1);
    }
    if (bucket >= end - span) {
      distributeOverflow();
    }
    if (bucket >= prefetchedTo) {
      prefetch(bucket);
    }
    limit = Math.min(end - span, prefetchedTo);
    return bucket;
  }

  private void turnTo(int bucket) {
    current = bucket;
    int i = ring.drain(bucket);
    while (i != NONE) {
      heap.add(i);
      i = ring.next(i);
    }
  }

  /** Announces the next events, from a bucket on. */
  private void prefetch(int from) {
    int size = 0;
    int bucket = from;
    while (bucket < end && size < PREFETCHED) {
      int heads = size;
      // First the heads of some buckets, then their lists: as few reads as possible depend on
      // another one.
      for (int k = 0; k < PREFETCH_STEP && bucket < end; k++) {
        size = addUpcoming(ring.first(bucket), size);
        bucket = ring.filledFrom(bucket + 1);
      }
      for (int k = heads; k < size && size < MOST_PREFETCHED; k++) {
        size = addUpcoming(ring.next(upcoming[k]), size);
      }
    }
    prefetchedTo = Math.min(bucket, end);
    prefetcher.next(this, upcoming, size);
  }

  /** Appends a circle if it is one (NONE is not); returns the new size. Branch-free. */
  private int addUpcoming(int i, int size) {
    upcoming[size] = i;
    return size + 1 + (i >> 31);
  }

  /** Advances the empty ring to the next span that has entries; false if no event is left. */
  private boolean skip() {
    int following = end >> inSpan;
    while (following < spans && lists.isEmpty(following)) {
      following++;
    }
    if (following == spans) {
      return begin();
    }
    end = following << inSpan;
    distributeOverflow();
    return true;
  }

  /** Distributes the list of the next span into the consumed half of the ring. */
  private void distributeOverflow() {
    int following = end >> inSpan;
    if (following == spans) {
      return;
    }
    current = Math.max(current, end - span - 1);
    end += span;
    insertCurrent(lists.drain(following));
  }

  /** Inserts the events of a list's entries that are not stale. */
  private void insertCurrent(int first) {
    int chunk = first;
    while (chunk != OverflowLists.NONE) {
      if (prefetcher != null) {
        read(chunk);
      }
      for (int k = lists.start(chunk); k < chunk; k++) {
        if (isCurrent(lists.id(k), lists.time(k))) {
          ring.mark(lists.id(k), NONE);
          insert(lists.id(k), lists.time(k));
        }
      }
      chunk = lists.release(chunk);
    }
  }

  /**
   * Prefetches the values that are needed of the entries of a chunk. No read depends on another
   * one.
   */
  private void read(int chunk) {
    double sum = 0;
    for (int k = lists.start(chunk); k < chunk; k++) {
      int i = lists.id(k);
      sum += times[i] + ring.next(i);
    }
    read += sum;
  }

  /**
   * Begins a new round if the heap or the lists are crowded and more events were polled since the
   * last round began than it began with. Events at exactly one time stay crowded, so this must not
   * be tried each time.
   */
  private void spread() {
    if ((heap.size() > HEAP_CROWDED || overflow() > mostChunks) && polled > atFirst) {
      gather();
      begin();
    }
  }

  /** Moves all events to the list beyond the last span. */
  private void gather() {
    while (!heap.isEmpty()) {
      int i = heap.first();
      heap.removeFirst();
      list(spans, i, times[i]);
    }
    int bucket = ring.filledFrom(current + 1);
    while (bucket != BucketRing.NOWHERE) {
      int i = ring.drain(bucket);
      while (i != NONE) {
        int next = ring.next(i);
        list(spans, i, times[i]);
        i = next;
      }
      bucket = ring.filledFrom(bucket + 1);
    }
    for (int following = end >> inSpan; following < spans; following++) {
      int chunk = lists.drain(following);
      while (chunk != OverflowLists.NONE) {
        for (int k = lists.start(chunk); k < chunk; k++) {
          lists.add(spans, lists.id(k), lists.time(k));
        }
        chunk = lists.release(chunk);
      }
    }
  }

  /** Begins a new round with the events beyond the last span; false if there are none. */
  private boolean begin() {
    int waiting = lists.drain(spans);
    if (waiting == OverflowLists.NONE) {
      return false;
    }
    double earliest = NEVER;
    atFirst = 0;
    for (int chunk = waiting; chunk != OverflowLists.NONE; chunk = lists.next(chunk)) {
      for (int k = lists.start(chunk); k < chunk; k++) {
        if (isCurrent(lists.id(k), lists.time(k))) {
          earliest = Math.min(earliest, lists.time(k));
          atFirst++;
        }
      }
    }
    polled = 0;
    limit = 0;
    prefetchedTo = prefetcher == null ? BucketRing.NOWHERE : 0;
    if (earliest < NEVER) {
      base = earliest;
      perUnit = Math.min(0x1p1000, PER_EVENT * density(waiting, earliest));
      current = -1;
      end = 2 * span;
    }
    insertCurrent(waiting);
    return earliest < NEVER;
  }

  /**
   * Events per unit of time: the number of waiting events divided by their mean waiting time,
   * counted from the earliest event. If a few wait far longer than the others, only the others
   * count.
   */
  private double density(int waiting, double earliest) {
    double limit = NEVER;
    double density = 0;
    while (true) {
      double sum = 0;
      int count = 0;
      for (int chunk = waiting; chunk != OverflowLists.NONE; chunk = lists.next(chunk)) {
        for (int k = lists.start(chunk); k < chunk; k++) {
          double wait = lists.time(k) - earliest;
          if (wait >= 0 && wait <= limit && isCurrent(lists.id(k), lists.time(k))) {
            sum += wait * WAIT_SCALE;
            count++;
          }
        }
      }
      double mean = sum / count / WAIT_SCALE;
      if (limit == NEVER || (mean > 0 && mean * SKEW_LIMIT < limit)) {
        density = count / mean;
      }
      if (!(mean > 0) || mean * SKEW_LIMIT >= limit) {
        return density;
      }
      limit = mean;
    }
  }
}
