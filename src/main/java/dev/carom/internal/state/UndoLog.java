// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The rows of the circles that a step has advanced, as they were at its start. When a step runs out
 * of its budget they are put back, and the step is taken anew to an earlier time.
 */
public final class UndoLog {

  private int size;
  private int[] circles;
  private double[] state;
  private int[] codes;

  /** Of jammed circles; null as long as there was none. */
  private IgnoreList[] jams;

  /** With room for some circles; it grows as needed. */
  public UndoLog(int circles) {
    int capacity = Math.max(1, circles);
    this.circles = new int[capacity];
    state = new double[capacity * CircleTable.STATE];
    codes = new int[capacity * CircleTable.CODES];
  }

  public void clear() {
    size = 0;
  }

  /** Saves the row of circle i, before it is advanced for the first time. */
  public void save(CircleTable table, int i) {
    if (size == circles.length) {
      grow();
    }
    circles[size] = i;
    table.copyRow(i, state, codes, size);
    IgnoreList jam = table.jam(i);
    if (jams != null || jam != null) {
      saveJam(jam);
    }
    size++;
  }

  private void saveJam(IgnoreList jam) {
    if (jams == null) {
      jams = new IgnoreList[circles.length];
    }
    jams[size] = jam;
  }

  /** Puts all saved rows back, and forgets them. */
  public void restore(CircleTable table) {
    for (int row = 0; row < size; row++) {
      table.setRow(circles[row], state, codes, row, jams == null ? null : jams[row]);
    }
    size = 0;
  }

  private void grow() {
    circles = Arrays.copyOf(circles, 2 * size);
    state = Arrays.copyOf(state, 2 * state.length);
    codes = Arrays.copyOf(codes, 2 * codes.length);
    jams = jams == null ? null : Arrays.copyOf(jams, 2 * size);
  }
}
