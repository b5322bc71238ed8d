// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/** A list of codes of {@link Obstacles}, each at most once. */
final class CodeList {

  int size;
  int[] codes = new int[4];

  void add(int code) {
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

  void clear() {
    size = 0;
  }
}
