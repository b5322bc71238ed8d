// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The state of all circles that a step has advanced, as it was at the start of the step. A step
 * that exhausts its budget restores these circles and is repeated to an earlier time.
 */
public final class UndoLog {

  private int size;
  private int[] circles;
  private double[] state;
  private int[] codes;

  /** The ignore lists of jammed circles; null as long as none was jammed. */
  private IgnoreList[] jams;

  /** Accelerations and supports; null as long as nothing falls. */
  private Accelerations accelerations;

  /** Creates a log with room for some circles. It grows as needed. */
  public UndoLog(int circles) {
    int capacity = Math.max(1, circles);
    this.circles = new int[capacity];
    state = new double[capacity * CircleTable.STATE];
    codes = new int[capacity * CircleTable.CODES];
  }

  public void clear() {
    size = 0;
  }

  /** Saves a circle. To be called before the step first advances it. */
  public void save(MovingCircle m) {
    if (size == circles.length) {
      grow();
    }
    circles[size] = m.id;
    CircleTable.put(m, state, size * CircleTable.STATE, codes, size * CircleTable.CODES);
    if (jams != null || m.jam != null) {
      saveJam(m.jam);
    }
    if (accelerations != null || m.isFalling()) {
      saveAcceleration(m);
    }
    size++;
  }

  private void saveJam(IgnoreList jam) {
    if (jams == null) {
      jams = new IgnoreList[circles.length];
    }
    jams[size] = jam;
  }

  private void saveAcceleration(MovingCircle m) {
    if (accelerations == null) {
      accelerations = new Accelerations(circles.length);
    }
    accelerations.put(size, m);
  }

  /** Restores all saved circles, and clears the log. */
  public void restore(CircleTable table) {
    MovingCircle m = table.body;
    for (int row = 0; row < size; row++) {
      CircleTable.get(m, state, row * CircleTable.STATE, codes, row * CircleTable.CODES);
      m.jam = jams == null ? null : jams[row];
      m.fall(0, 0);
      m.slowContacts = 0;
      if (accelerations != null) {
        accelerations.get(row, m);
      }
      table.storeAndSetDue(circles[row], m);
    }
    size = 0;
  }

  private void grow() {
    circles = Arrays.copyOf(circles, 2 * size);
    state = Arrays.copyOf(state, 2 * state.length);
    codes = Arrays.copyOf(codes, 2 * codes.length);
    jams = jams == null ? null : Arrays.copyOf(jams, 2 * size);
    if (accelerations != null) {
      accelerations.resize(2 * size);
    }
  }
}
