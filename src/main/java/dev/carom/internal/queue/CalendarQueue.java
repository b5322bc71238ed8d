// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * A calendar of at most one event for each circle. Setting, moving and taking an event cost O(1) on
 * average, whatever their number.
 *
 * <p>A ring of buckets of equal length of time, some for each event, so that most hold one or none,
 * and a small heap for the current one and what is before it. The ring holds two spans of time, in
 * memory that stays in the cache. Later events wait in lists, one for each span, to which an event
 * is only added: one that is moved leaves its old entry behind, and whether an entry is still meant
 * shows when its list is dealt out, to the half of the ring that is through. Events beyond the last
 * span wait in one list more. When the calendar is through, or its heap is crowded, it begins anew,
 * with buckets as long as suits those that wait.
 *
 * <p>Source of the calendar: G. Paul, A Complexity O(1) priority queue for event driven molecular
 * dynamics simulations, Journal of Computational Physics 221 (2007).
 */
public final class CalendarQueue {

  /** Is told which events come next, some time before they come. */
  public interface Prefetcher {

    /** Takes notice of the circles whose events are next in a queue, in any order. */
    void next(CalendarQueue queue, int[] circles, int size);
  }

  private static final int NONE = Index.NONE;

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /**
   * Events that an outlook is told of at a time, and at most where many are due at nearly one time:
   * a core waits for some dozens of reads at once.
   */
  private static final int PREFETCHED = 32;

  public static final int MOST_PREFETCHED = 2 * PREFETCHED;

  /** Buckets of which an outlook is told at once. */
  private static final int PREFETCH_STEP = 8;

  /** Buckets for each event in the mean time that events wait: what is next is told by a bit. */
  private static final int PER_EVENT = 4;

  /** A round, in mean times that events wait: what begins anew each time is shared by many. */
  private static final int ROUND_LENGTH = 16;

  /** Spans of a round, as many as there are if not those of the next bounds are too long. */
  private static final int SPANS = 8;

  private static final int MOST_SPANS = 1 << 15;

  /** Buckets of a round at most, lest their numbers be more than an int holds. */
  private static final int MOST_BUCKETS = 1 << 30;

  // Buckets of a span, unless there were too many spans: few enough to stay in the cache; and where
  // the circles do not, so few that what is read of them to deal out a list still is when its turn
  // comes.
  private static final int LEAST_IN_SPAN = 32;
  private static final int MANY_IN_SPAN = 1 << 13;
  private static final int MANY_WITH_PREFETCH = 1 << 11;

  /** More events than that in the heap are too many, unless they are at one time. */
  private static final int HEAP_CROWDED = 32;

  /** A sum of so small parts of times does not overflow. */
  private static final double WAIT_SCALE = 0x1p-32;

  /** More than this many times longer than the next shorter one is a length of time too long. */
  private static final double SKEW_LIMIT = 8;

  /** What an event is marked with that waits in a list. */
  private static final int IN_OVERFLOW = NONE - 1;

  /** Or null. */
  private final Prefetcher prefetcher;

  private final int[] upcoming = new int[MOST_PREFETCHED + PREFETCH_STEP + 1];

  /** Buckets before this one were told of, or need not be. */
  private int prefetchedTo;

  /** When the event of each circle is due. */
  private final double[] times;

  private final BucketRing ring;

  /** Buckets of a span: so many, which are 2 to this. */
  private final int span;

  private final int inSpan;

  private final int spans;

  /** One for each span, and one for what is beyond. */
  private final OverflowLists lists;

  // The calendar's beginning, buckets in a unit of time, the current bucket, and the first one that
  // is not on the ring yet.
  private double base = -1;
  private double perUnit = 0x1p1000;
  private int current = -1;
  private int end;

  /** From this bucket on there is more to do than to take what it holds. */
  private int limit;

  /** The events of the current bucket and of those before it. */
  private final EventHeap heap;

  /** Events taken since the calendar began, and how many there were then. */
  private long polled;

  private int atFirst;

  private double polledTime;

  /** What was read comes together here, for else it need not be read. */
  @SuppressWarnings("UnusedVariable")
  private double read;

  public CalendarQueue(int count, EventOrder order) {
    this(count, order, null, new int[CircleTable.collidingCodesAt(count)]);
  }

  /**
   * One that tells an outlook which events come next.
   *
   * @param prefetcher or null for none
   * @param codes the ints of so many circles: it keeps their {@link CircleTable#PLACE}
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
    lists = new OverflowLists(spans + 1, spans + 2 + count / 8);
    end = spans << inSpan; // before the first round all is beyond
    times = new double[count];
    Arrays.fill(times, NEVER);
    heap = new EventHeap(times, order, codes);
  }

  /** The least n for which 2^n is no less than x. */
  private static int logarithm(long x) {
    return Long.SIZE - Long.numberOfLeadingZeros(x - 1);
  }

  public double time(int i) {
    return times[i];
  }

  /** Sets the event of circle i, in place of the one it had; {@code +infinity} for none. */
  public void set(int i, double time) {
    if (times[i] != NEVER) { // most events were taken
      clear(i);
    }
    times[i] = time;
    if (time != NEVER) {
      insert(i, time);
    }
  }

  /** Takes out the event of circle i: to be done before anything changes what orders it. */
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

  /**
   * Takes out the first event, if it is due by a given time.
   *
   * @return its circle, or NONE
   */
  public int poll(double last) {
    spread();
    while (heap.isEmpty()) {
      int bucket = nextBucket();
      if (bucket == BucketRing.NOWHERE) {
        return NONE;
      }
      int i = ring.first(bucket);
      if (i == NONE || ring.next(i) != NONE) {
        turnTo(bucket);
      } else { // as a rule it is alone
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

  /** When the event was due that was taken last. */
  public double polledTime() {
    return polledTime;
  }

  /**
   * Whether a time is earlier than those of all events; false too if that takes a longer look than
   * at the current bucket.
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

  /** Whether an entry of a list is still that of its circle. */
  private boolean isCurrent(int i, double time) {
    return times[i] == time && ring.next(i) == IN_OVERFLOW;
  }

  /** The next bucket that may hold something, or NOWHERE if no event is left. */
  private int nextBucket() {
    int bucket = ring.filledFrom(current + 1);
    return bucket < limit ? bucket : goFurther(bucket);
  }

  /** The same where the ring is empty, half of it is through, or it is time for an outlook. */
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

  /** Tells which events come next, from a bucket on. */
  private void prefetch(int from) {
    int size = 0;
    int bucket = from;
    while (bucket < end && size < PREFETCHED) {
      int heads = size;
      // What is read of one circle does not depend on another one, as far as that can be.
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

  /** Adds a circle to those that are told of, if it is one; returns how many they are then. */
  private int addUpcoming(int i, int size) {
    upcoming[size] = i;
    return size + 1 + (i >> 31);
  }

  /** Goes on to the next span that has a list, the ring being empty; false if no event is left. */
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

  /** Deals out the list of the span that follows, to the half of the ring that is through. */
  private void distributeOverflow() {
    int following = end >> inSpan;
    if (following == spans) {
      return;
    }
    current = Math.max(current, end - span - 1);
    end += span;
    int chunk = lists.drain(following);
    while (chunk != OverflowLists.NONE) {
      if (prefetcher != null) {
        read(chunk);
      }
      for (int k = lists.start(chunk); k < chunk; k++) {
        insertIfCurrent(lists.id(k), lists.time(k));
      }
      chunk = lists.release(chunk);
    }
  }

  /** Reads what is asked of the entries of a chunk, none of which waits for another one. */
  private void read(int chunk) {
    double sum = 0;
    for (int k = lists.start(chunk); k < chunk; k++) {
      int i = lists.id(k);
      sum += times[i] + ring.next(i);
    }
    read += sum;
  }

  /** Puts the event of an entry, if it is still meant, where it belongs by now. */
  private void insertIfCurrent(int i, double time) {
    if (isCurrent(i, time)) {
      ring.mark(i, NONE);
      insert(i, time);
    }
  }

  /** Begins a new round if too many events are in the heap, and that was not tried just now. */
  private void spread() {
    if (heap.size() > HEAP_CROWDED && polled > atFirst) {
      gather();
      begin();
    }
  }

  /** Lets all events wait with those beyond the last span. */
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

  /** Begins a new round with what waits beyond the last span; false if that is nothing. */
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
    while (waiting != OverflowLists.NONE) {
      for (int k = lists.start(waiting); k < waiting; k++) {
        insertIfCurrent(lists.id(k), lists.time(k));
      }
      waiting = lists.release(waiting);
    }
    return earliest < NEVER;
  }

  /** Events in their mean time from the earliest on: all of them, or the most that are alike. */
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
