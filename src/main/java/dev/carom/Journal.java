// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/**
 * The circles that a step has advanced, as they were at its start: what it takes to go back where a
 * step runs out of its budget and has to end earlier.
 */
final class Journal {

  private final int doublesEach;
  private final int intsEach;
  private int size;
  private int[] ids;
  private double[] dues;
  private double[] state;
  private int[] codes;
  private Jam[] jams;

  /** With room for some circles, of so many doubles and ints each; it grows as needed. */
  Journal(int circles, int doublesEach, int intsEach) {
    this.doublesEach = doublesEach;
    this.intsEach = intsEach;
    int capacity = Math.max(1, circles);
    ids = new int[capacity];
    dues = new double[capacity];
    jams = new Jam[capacity];
    state = new double[capacity * doublesEach];
    codes = new int[capacity * intsEach];
  }

  void clear() {
    size = 0;
  }

  /** Notes circle i, before it is advanced for the first time. */
  void save(int i, double due, Jam jam, double[] allState, int[] allCodes) {
    if (size == ids.length) {
      grow();
    }
    ids[size] = i;
    dues[size] = due;
    jams[size] = jam;
    System.arraycopy(allState, i * doublesEach, state, size * doublesEach, doublesEach);
    System.arraycopy(allCodes, i * intsEach, codes, size * intsEach, intsEach);
    size++;
  }

  /** Puts all noted circles back, and forgets them. */
  void restore(Agenda allDues, Jam[] allJams, double[] allState, int[] allCodes) {
    for (int k = 0; k < size; k++) {
      int i = ids[k];
      allDues.set(i, dues[k]);
      if (allJams != null) {
        allJams[i] = jams[k];
      }
      System.arraycopy(state, k * doublesEach, allState, i * doublesEach, doublesEach);
      System.arraycopy(codes, k * intsEach, allCodes, i * intsEach, intsEach);
    }
    size = 0;
  }

  private void grow() {
    int capacity = 2 * size;
    ids = Arrays.copyOf(ids, capacity);
    dues = Arrays.copyOf(dues, capacity);
    jams = Arrays.copyOf(jams, capacity);
    state = Arrays.copyOf(state, capacity * doublesEach);
    codes = Arrays.copyOf(codes, capacity * intsEach);
  }
}
