// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * The few events of an {@link EventQueue} that are next, as a heap: of each circle one at most,
 * found by its place. What orders an event must not change while it is here.
 */
final class EventHeap {

  private static final int NONE = EventQueue.NONE;

  private final EventQueue.Order order;

  /** The ints of circles; of each the place of its event here, or NONE. */
  private final int[] codes;

  private int[] heap = new int[16];
  private double[] times = new double[16];
  private int size;

  EventHeap(int count, EventQueue.Order order, int[] codes) {
    this.order = order;
    this.codes = codes;
    for (int i = 0; i < count; i++) {
      setPlace(i, NONE);
    }
  }

  private int place(int i) {
    return codes[Circles.collidingCodesAt(i) + Circles.PLACE];
  }

  private void setPlace(int i, int place) {
    codes[Circles.collidingCodesAt(i) + Circles.PLACE] = place;
  }

  boolean isEmpty() {
    return size == 0;
  }

  boolean contains(int i) {
    return place(i) != NONE;
  }

  /** The circle whose event is first. */
  int first() {
    return heap[0];
  }

  double firstTime() {
    return times[0];
  }

  void add(int i, double time) {
    if (size == heap.length) {
      heap = Arrays.copyOf(heap, 2 * size);
      times = Arrays.copyOf(times, 2 * size);
    }
    up(size++, i, time);
  }

  /** Takes out the event of circle i, if it is here. */
  void remove(int i) {
    int k = place(i);
    if (k != NONE) {
      removeAt(k);
    }
  }

  /** Takes out the first event. */
  void removeFirst() {
    setPlace(heap[0], NONE);
    size--;
    if (size > 0) {
      down(0, heap[size], times[size]);
    }
  }

  private void removeAt(int k) {
    setPlace(heap[k], NONE);
    size--;
    if (k < size) {
      int i = heap[size];
      double time = times[size];
      if (k > 0 && before(i, time, (k - 1) / 2)) {
        up(k, i, time);
      } else {
        down(k, i, time);
      }
    }
  }

  private void put(int k, int i, double time) {
    heap[k] = i;
    times[k] = time;
    setPlace(i, k);
  }

  /** Puts an event at place k of the heap or above. */
  private void up(int k, int i, double time) {
    int at = k;
    while (at > 0) {
      int parent = (at - 1) / 2;
      if (!before(i, time, parent)) {
        break;
      }
      put(at, heap[parent], times[parent]);
      at = parent;
    }
    put(at, i, time);
  }

  /** Puts an event at place k of the heap or below. */
  private void down(int k, int i, double time) {
    int at = k;
    while (2 * at + 1 < size) {
      int child = 2 * at + 1;
      if (child + 1 < size && before(heap[child + 1], times[child + 1], child)) {
        child++;
      }
      if (before(i, time, child)) {
        break;
      }
      put(at, heap[child], times[child]);
      at = child;
    }
    put(at, i, time);
  }

  private boolean before(int i, double time, int k) {
    double other = times[k];
    return time != other ? time < other : order.before(i, heap[k]);
  }
}
