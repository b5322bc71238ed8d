// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Counts the rows that a recording keeps of removed things. All of these together keep at most as
 * many as the largest number of things that ever existed at once may keep.
 */
final class Remains {

  private final int most;
  private final Deque<Integer> removed = new ArrayDeque<>();
  private long rows;
  private int present;
  private int mostPresent;

  /** Begins with no things, each of which may keep so many rows. */
  Remains(int most) {
    this.most = most;
  }

  /** Counts more things. */
  void appear(int things) {
    present += things;
    mostPresent = Math.max(mostPresent, present);
  }

  /** Counts a thing as removed. */
  void remove(int thing, int itsRows) {
    present--;
    rows += itsRows;
    removed.add(thing);
  }

  /** Whether the thing that was removed first is to be dropped. */
  boolean isFull() {
    return rows > (long) most * mostPresent;
  }

  /** The thing that was removed first and is not dropped yet. */
  int first() {
    return removed.element();
  }

  void dropFirst(int itsRows) {
    rows -= itsRows;
    removed.remove();
  }
}
