// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/** A list of {@link Codes}, each at most once. */
public final class CodeSet {

  public int size;
  public int[] codes = new int[4];

  public void add(int code) {
    for (int i = 0; i < size; i++) {
      if (codes[i] == code) {
        return;
      }
    }
    if (size == codes.length) {
      codes = Arrays.copyOf(codes, 2 * size);
    }
    codes[size++] = code;
  }

  public void clear() {
    size = 0;
  }
}
