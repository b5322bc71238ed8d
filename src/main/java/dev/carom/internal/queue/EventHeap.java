// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * The few events of an {@link CalendarQueue} that are next, as a heap: of each circle one at most,
 * found by its place. What orders an event must not change while it is here.
 */
final class EventHeap {

  private static final int NONE = Index.NONE;

  private final EventOrder order;

  /** When the event of each circle is due. */
  private final double[] times;

  /** The ints of circles; of each the place of its event here, or NONE. */
  private final int[] codes;

  private int[] heap = new int[16];
  private int size;

  EventHeap(double[] times, EventOrder order, int[] codes) {
    this.times = times;
    this.order = order;
    this.codes = codes;
    for (int i = 0; i < times.length; i++) {
      setIndex(i, NONE);
    }
  }

  private int indexOf(int i) {
    return codes[CircleTable.collidingCodesAt(i) + CircleTable.HEAP_INDEX];
  }

  private void setIndex(int i, int indexOf) {
    codes[CircleTable.collidingCodesAt(i) + CircleTable.HEAP_INDEX] = indexOf;
  }

  boolean isEmpty() {
    return size == 0;
  }

  int size() {
    return size;
  }

  boolean contains(int i) {
    return indexOf(i) != NONE;
  }

  /** The circle whose event is first. */
  int first() {
    return heap[0];
  }

  /** Adds the event of circle i, whose time does not change while it is here. */
  void add(int i) {
    if (size == heap.length) {
      heap = Arrays.copyOf(heap, 2 * size);
    }
    up(size++, i);
  }

  /** Takes out the event of circle i, which is here. */
  void remove(int i) {
    removeAt(indexOf(i));
  }

  /** Takes out the first event. */
  void removeFirst() {
    setIndex(heap[0], NONE);
    size--;
    if (size > 0) {
      down(0, heap[size]);
    }
  }

  private void removeAt(int k) {
    setIndex(heap[k], NONE);
    size--;
    if (k < size) {
      int i = heap[size];
      if (k > 0 && before(i, heap[(k - 1) / 2])) {
        up(k, i);
      } else {
        down(k, i);
      }
    }
  }

  private void put(int k, int i) {
    heap[k] = i;
    setIndex(i, k);
  }

  /** Puts an event at place k of the heap or above. */
  private void up(int k, int i) {
    int at = k;
    while (at > 0) {
      int parent = (at - 1) / 2;
      if (!before(i, heap[parent])) {
        break;
      }
      put(at, heap[parent]);
      at = parent;
    }
    put(at, i);
  }

  /** Puts an event at place k of the heap or below. */
  private void down(int k, int i) {
    int at = k;
    while (2 * at + 1 < size) {
      int child = 2 * at + 1;
      if (child + 1 < size && before(heap[child + 1], heap[child])) {
        child++;
      }
      if (before(i, heap[child])) {
        break;
      }
      put(at, heap[child]);
      at = child;
    }
    put(at, i);
  }

  private boolean before(int i, int j) {
    return times[i] != times[j] ? times[i] < times[j] : order.before(i, j);
  }
}
