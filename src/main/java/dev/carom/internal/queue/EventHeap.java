// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.queue;

import dev.carom.internal.state.CircleTable;
import dev.carom.internal.util.Index;
import java.util.Arrays;

/**
 * The binary heap of the next few events of a {@link CalendarQueue}, at most one per circle. Each
 * circle's row holds the position of its event, so an event is found in O(1). Whatever orders an
 * event must not change while the event is in the heap.
 */
final class EventHeap {

  private static final int NONE = Index.NONE;

  private final EventOrder order;

  /** The time of each circle's event. */
  private final double[] times;

  /**
   * The int rows of the circles. {@link CircleTable#HEAP_INDEX} is the position of the circle's
   * event in the heap, or NONE.
   */
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

  /** The circle with the first event. */
  int first() {
    return heap[0];
  }

  /** Adds the event of circle i. Its time must not change while it is in the heap. */
  void add(int i) {
    if (size == heap.length) {
      heap = Arrays.copyOf(heap, 2 * size);
    }
    up(size++, i);
  }

  /** Removes the event of circle i, which must be in the heap. */
  void remove(int i) {
    removeAt(indexOf(i));
  }

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

  /** Puts an event at position k, or above if it comes before its parent. */
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

  /** Puts an event at position k, or below if a child comes before it. */
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
