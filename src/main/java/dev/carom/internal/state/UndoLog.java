// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * A list of circles as they were. One holds all that a step has advanced, as they were at the start
 * of the step: a step that exhausts its budget restores them and is repeated to an earlier time. A
 * recording has another one: it keeps the flights of a step until the step is complete.
 */
public final class UndoLog {

  private final FlightTable rows;
  private int[] circles;
  private int size;

  /** Creates a list with room for some circles. It grows as needed. */
  public UndoLog(int circles) {
    this.circles = new int[Math.max(1, circles)];
    rows = new FlightTable(this.circles.length);
  }

  public void clear() {
    size = 0;
  }

  int size() {
    return size;
  }

  /** Loads the circle that was saved as number i. */
  void load(int i, MovingCircle m) {
    rows.get(i, m);
    m.id = circles[i];
  }

  /** Saves a circle. */
  public void save(MovingCircle m) {
    if (size == circles.length) {
      circles = Arrays.copyOf(circles, 2 * size);
      rows.resize(2 * size);
    }
    circles[size] = m.id;
    rows.put(size++, m);
  }

  /** Restores all saved circles, and clears the list. */
  public void restore(CircleTable table) {
    for (int i = 0; i < size; i++) {
      load(i, table.body);
      table.storeAndSetDue(circles[i]);
    }
    size = 0;
  }
}
