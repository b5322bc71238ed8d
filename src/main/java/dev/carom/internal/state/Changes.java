// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/** The values that one thing had, each with the time from which it holds. */
final class Changes<V> extends History {

  private double[] times = new double[0];
  private Object[] values = new Object[0];

  @Override
  double time(int place) {
    return times[place];
  }

  @Override
  int room() {
    return times.length;
  }

  @Override
  void move(int by, int room) {
    times = Arrays.copyOfRange(times, by, by + room);
    values = Arrays.copyOfRange(values, by, by + room);
  }

  /**
   * Adds a value that holds from a time on.
   *
   * @param horizon values that ended by this time may be dropped
   */
  void set(double from, V value, double horizon) {
    int place = place(from, horizon);
    times[place] = from;
    values[place] = value;
  }

  /** The value at a time; null before the first. */
  V at(double t) {
    return holds(t) ? value(find(t)) : null;
  }

  /** The newest value; null if there is none. */
  V last() {
    return isEmpty() ? null : value(newest());
  }

  @SuppressWarnings("unchecked") // only a V is stored
  private V value(int place) {
    return (V) values[place];
  }
}
