// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/** A growing row of doubles. */
final class DoubleList {

  private double[] values = new double[16];
  private int size;

  int size() {
    return size;
  }

  double get(int i) {
    return values[i];
  }

  void add(double... more) {
    if (size + more.length > values.length) {
      values = Arrays.copyOf(values, Math.max(2 * values.length, size + more.length));
    }
    System.arraycopy(more, 0, values, size, more.length);
    size += more.length;
  }

  void setLast(double value) {
    values[size - 1] = value;
  }

  double[] toArray() {
    return Arrays.copyOf(values, size);
  }
}
