// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

import java.util.Arrays;
import java.util.stream.IntStream;

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

  public void clear() {
    size = 0;
  }

  public void add(int value) {
    if (size == values.length) {
      values = Arrays.copyOf(values, 2 * size);
    }
    values[size++] = value;
  }

  public int[] toArray() {
    return Arrays.copyOf(values, size);
  }

  /** The values, ascending, each once; the list is sorted by this. */
  public IntStream sorted() {
    Arrays.sort(values, 0, size);
    return IntStream.range(0, size)
        .filter(i -> i == 0 || values[i] != values[i - 1])
        .map(i -> values[i]);
  }
}
