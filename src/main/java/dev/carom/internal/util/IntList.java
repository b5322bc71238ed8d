// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

import java.util.Arrays;
import java.util.function.IntPredicate;

/** A growable list of ints. */
public final class IntList {

  private int[] values = new int[16];
  private int size;

  public int size() {
    return size;
  }

  public int get(int i) {
    return values[i];
  }

  public void set(int i, int value) {
    values[i] = value;
  }

  public void clear() {
    cut(0);
  }

  /** Keeps only the first so many values. */
  public void cut(int to) {
    size = to;
  }

  /** Sorts the values from an index on; there are few of them. */
  public void sort(int from) {
    Arrays.sort(values, from, size);
  }

  public void add(int value) {
    if (size == values.length) {
      values = Arrays.copyOf(values, 2 * size);
    }
    values[size++] = value;
  }

  public boolean contains(int value) {
    boolean is = false;
    for (int k = 0; k < size && !is; k++) {
      is = values[k] == value;
    }
    return is;
  }

  public int[] toArray() {
    return Arrays.copyOf(values, size);
  }

  /** Keeps the values that pass a test, ascending, each once. */
  public int[] filtered(IntPredicate test) {
    Arrays.sort(values, 0, size);
    int end = 0;
    for (int i = 0; i < size; i++) {
      if ((i == 0 || values[i] != values[i - 1]) && test.test(values[i])) {
        values[end++] = values[i];
      }
    }
    size = end;
    return toArray();
  }
}
