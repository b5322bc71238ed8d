// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * The codes of all lines, pegs or circles that are there, ascending, and of no more that are gone:
 * what looks at each costs nothing for all that ever was there. A range, until many are gone.
 */
public final class LiveCodes {

  private final int from;
  private int size;
  private int gone;

  /** Null while they are a range. */
  private int[] codes;

  /** All from a code on. */
  LiveCodes(int from, int size) {
    this.from = from;
    this.size = size;
  }

  /** How many are listed. */
  public int size() {
    return size;
  }

  /** How many are there. */
  public int count() {
    return size - gone;
  }

  /** The code that has so many before it; its thing may be gone. */
  public int get(int i) {
    return codes == null ? from + i : codes[i];
  }

  /** Those that are there. */
  public IntStream stream(IntPredicate isGone) {
    return IntStream.range(0, size).map(this::get).filter(isGone.negate());
  }

  LiveCodes copy() {
    LiveCodes copy = new LiveCodes(from, size);
    copy.gone = gone;
    copy.codes = codes == null ? null : codes.clone();
    return copy;
  }

  /** Adds a code that is larger than any before. */
  void add(int code) {
    if (codes != null) {
      if (size == codes.length) {
        codes = Arrays.copyOf(codes, 2 * size + 4);
      }
      codes[size] = code;
    }
    size++;
  }

  /** Takes notice that so many more are gone. */
  void removed(int more, IntPredicate isGone) {
    gone += more;
    if (gone > size - gone) {
      codes = stream(isGone).toArray();
      size = codes.length;
      gone = 0;
    }
  }
}
