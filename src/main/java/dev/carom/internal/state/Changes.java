// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/** The values that one thing had, each with the time from which it holds, in order of time. */
final class Changes<V> {

  private static final int FIRST_ROOM = 2;

  private double[] times = new double[FIRST_ROOM];
  private Object[] values = new Object[FIRST_ROOM];

  /** The index of the oldest value that is kept, and one more than that of the newest. */
  private int first;

  private int end;

  int size() {
    return end - first;
  }

  /** The time from which the oldest kept value is valid. */
  double start() {
    return times[first];
  }

  /** Adds a value that holds from a time on, or from the time of the newest value if later. */
  void add(double from, V value) {
    if (end == times.length) {
      makeRoom();
    }
    times[end] = end == first ? from : Math.max(from, times[end - 1]);
    values[end++] = value;
  }

  /** Adds a value, in place of those from the same time on. */
  void set(double from, V value) {
    if (size() > 0 && times[end - 1] >= from) {
      values[end - 1] = value;
    } else {
      add(from, value);
    }
  }

  private void makeRoom() {
    int size = size();
    int room = Math.max(FIRST_ROOM, 2 * size);
    times = Arrays.copyOf(Arrays.copyOfRange(times, first, end), room);
    values = Arrays.copyOf(Arrays.copyOfRange(values, first, end), room);
    first = 0;
    end = size;
  }

  /** Drops the oldest values until there are no more than that many; returns whether any was. */
  boolean keep(int most) {
    boolean drops = size() > most;
    while (size() > most) {
      values[first++] = null;
    }
    return drops;
  }

  /** The value at a time; null before the first. */
  V at(double t) {
    int low = first - 1;
    int high = end - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (times[middle] <= t) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low < first ? null : value(low);
  }

  /** The newest value; null if there is none. */
  V last() {
    return size() == 0 ? null : value(end - 1);
  }

  @SuppressWarnings("unchecked") // only a V is stored
  private V value(int i) {
    return (V) values[i];
  }
}
