// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The circles that a step has advanced, as they were at its start: what it takes to go back where a
 * step runs out of its budget and has to end earlier. Noted is what a step can change.
 */
public final class UndoLog {

  private static final int DOUBLES = 7;
  private static final int INTS = 7;

  private int size;
  private int capacity;
  private double[] state;
  private int[] codes;

  /** Of jammed circles; null as long as there was none. */
  private IgnoreList[] jams;

  /** With room for some circles; it grows as needed. */
  public UndoLog(int circles) {
    capacity = Math.max(1, circles);
    state = new double[capacity * DOUBLES];
    codes = new int[capacity * INTS];
  }

  public void clear() {
    size = 0;
  }

  /** Notes a circle, before it is advanced for the first time. */
  public void save(MovingCircle m) {
    if (size == capacity) {
      grow();
    }
    // The first and the last one first: then compilers need not ask whether the rest is in range.
    int k = size * DOUBLES;
    state[k] = m.x;
    state[k + 6] = m.cleared;
    state[k + 1] = m.y;
    state[k + 2] = m.vx;
    state[k + 3] = m.vy;
    state[k + 4] = m.t;
    state[k + 5] = m.tl;
    int c = size * INTS;
    codes[c] = m.id;
    codes[c + 6] = m.marks();
    codes[c + 1] = m.last;
    codes[c + 2] = m.next;
    codes[c + 3] = m.contact;
    codes[c + 4] = m.lookahead;
    codes[c + 5] = m.stuck;
    if (jams != null || m.jam != null) {
      storeJam(m.jam);
    }
    size++;
  }

  private void storeJam(IgnoreList jam) {
    if (jams == null) {
      jams = new IgnoreList[capacity];
    }
    jams[size] = jam;
  }

  /** Puts all noted circles back, and forgets them. */
  public void restore(CircleTable circles) {
    MovingCircle m = circles.mover;
    for (int i = 0; i < size; i++) {
      circles.load(codes[i * INTS], m);
      load(i, m);
      circles.storeAndSetDue(m.id, m);
    }
    size = 0;
  }

  private void load(int i, MovingCircle m) {
    int k = i * DOUBLES;
    m.x = state[k];
    m.y = state[k + 1];
    m.vx = state[k + 2];
    m.vy = state[k + 3];
    m.t = state[k + 4];
    m.tl = state[k + 5];
    m.cleared = state[k + 6];
    int c = i * INTS;
    m.last = codes[c + 1];
    m.next = codes[c + 2];
    m.contact = codes[c + 3];
    m.lookahead = codes[c + 4];
    m.stuck = codes[c + 5];
    m.setMarks(codes[c + 6]);
    m.jam = jams == null ? null : jams[i];
  }

  private void grow() {
    capacity *= 2;
    state = Arrays.copyOf(state, capacity * DOUBLES);
    codes = Arrays.copyOf(codes, capacity * INTS);
    jams = jams == null ? null : Arrays.copyOf(jams, capacity);
  }
}
