// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * The codes of all live lines, pegs or circles, ascending. Removed codes may linger but never
 * outnumber live ones, so iterating is O(live). Codes are stored as a range until many of them are
 * removed.
 */
public final class LiveCodes {

  private final int from;
  private int size;
  private int gone;

  /** The codes; null while they are a range. */
  private int[] codes;

  /** A range of codes from {@code from} on. */
  LiveCodes(int from, int size) {
    this.from = from;
    this.size = size;
  }

  /** The number of listed codes, removed ones included. */
  public int size() {
    return size;
  }

  /** The number of live codes. */
  public int count() {
    return size - gone;
  }

  /** The listed code at an index; it may be removed. */
  public int get(int i) {
    return codes == null ? from + i : codes[i];
  }

  /** The live codes. */
  public IntStream stream(IntPredicate isGone) {
    return IntStream.range(0, size).map(this::get).filter(isGone.negate());
  }

  LiveCodes copy() {
    LiveCodes copy = new LiveCodes(from, size);
    copy.gone = gone;
    copy.codes = codes == null ? null : codes.clone();
    return copy;
  }

  /** Adds a code that is larger than all others. */
  void add(int code) {
    if (codes != null) {
      if (size == codes.length) {
        codes = Arrays.copyOf(codes, 2 * size + 4);
      }
      codes[size] = code;
    }
    size++;
  }

  /** Counts that many more codes as removed. */
  void removed(int more, IntPredicate isGone) {
    gone += more;
    if (gone > size - gone) {
      codes = stream(isGone).toArray();
      size = codes.length;
      gone = 0;
    }
  }
}
