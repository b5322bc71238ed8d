// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The acceleration and the support of each circle that falls, slides or rests. A world without
 * gravity has none.
 */
final class Accelerations {

  private double[] values;
  private int[] supports;
  private int[] calms;

  Accelerations(int room) {
    values = new double[2 * room];
    supports = new int[room];
    calms = new int[room];
    Arrays.fill(supports, MovingCircle.NOTHING);
  }

  void resize(int room) {
    int before = supports.length;
    values = Arrays.copyOf(values, 2 * room);
    supports = Arrays.copyOf(supports, room);
    calms = Arrays.copyOf(calms, room);
    if (room > before) {
      Arrays.fill(supports, before, room, MovingCircle.NOTHING);
    }
  }

  void put(int i, MovingCircle m) {
    values[2 * i] = m.gx;
    values[2 * i + 1] = m.gy;
    supports[i] = m.supportWord();
    calms[i] = m.slowContacts;
  }

  void get(int i, MovingCircle m) {
    m.gx = values[2 * i];
    m.gy = values[2 * i + 1];
    m.setSupport(supports[i]);
    m.slowContacts = calms[i];
  }

  /** Copies a row of another table to row i. */
  void copy(int i, Accelerations from, int of) {
    System.arraycopy(from.values, 2 * of, values, 2 * i, 2);
    supports[i] = from.supports[of];
    calms[i] = from.calms[of];
  }

  /** Clears row i: nothing moves that circle. */
  void clear(int i) {
    values[2 * i] = 0;
    values[2 * i + 1] = 0;
    supports[i] = MovingCircle.NOTHING;
    calms[i] = 0;
  }

  double x(int i) {
    return values[2 * i];
  }

  double y(int i) {
    return values[2 * i + 1];
  }

  int support(int i) {
    return supports[i];
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Accelerations that
        && Arrays.equals(values, that.values)
        && Arrays.equals(supports, that.supports)
        && Arrays.equals(calms, that.calms);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(values);
  }
}
