// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.util;

import java.util.Arrays;

/** A growable list of doubles. */
public final class DoubleList {

  private double[] values = new double[16];
  private int size;

  public int size() {
    return size;
  }

  public double get(int i) {
    return values[i];
  }

  public void add(double... more) {
    if (size + more.length > values.length) {
      values = Arrays.copyOf(values, Math.max(2 * values.length, size + more.length));
    }
    System.arraycopy(more, 0, values, size, more.length);
    size += more.length;
  }

  public void clear() {
    size = 0;
  }

  public void setLast(double value) {
    values[size - 1] = value;
  }

  public double[] toArray() {
    return Arrays.copyOf(values, size);
  }
}
