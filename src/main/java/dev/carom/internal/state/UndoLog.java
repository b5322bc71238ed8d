// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The state of all circles that a step has advanced, as it was at the start of the step. A step
 * that exhausts its budget restores these circles and is repeated to an earlier time.
 */
public final class UndoLog {

  private final FlightTable rows;
  private int[] circles;
  private int size;

  /** Creates a log with room for some circles. It grows as needed. */
  public UndoLog(int circles) {
    this.circles = new int[Math.max(1, circles)];
    rows = new FlightTable(this.circles.length);
  }

  public void clear() {
    size = 0;
  }

  /** Saves a circle. To be called before the step first advances it. */
  public void save(MovingCircle m) {
    if (size == circles.length) {
      circles = Arrays.copyOf(circles, 2 * size);
      rows.resize(2 * size);
    }
    circles[size] = m.id;
    rows.put(size++, m);
  }

  /** Restores all saved circles, and clears the log. */
  public void restore(CircleTable table) {
    for (int row = 0; row < size; row++) {
      rows.get(row, table.body);
      table.storeAndSetDue(circles[row], table.body);
    }
    size = 0;
  }
}
