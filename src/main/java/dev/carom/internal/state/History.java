// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

/**
 * What is known of one thing: rows that each hold from a time on, in order of time. A subclass
 * keeps the rows in arrays.
 */
abstract class History {

  private static final int FIRST_ROOM = 4;

  /** The place of the oldest row, and one more than that of the newest. */
  private int first;

  private int end;

  /** The row found last. The next query is usually about the same one. */
  private int found;

  /** From when on the row at a place holds. */
  abstract double time(int place);

  /** The number of places. */
  abstract int room();

  /** Moves all rows towards the beginning, by so many places, into so much room. */
  abstract void move(int by, int room);

  /**
   * The place for a row that holds from a time on: it replaces one that holds from then on.
   *
   * @param horizon rows that ended by this time are dropped, if there is no room
   */
  final int place(double time, double horizon) {
    if (!isEmpty() && since() >= time) {
      return newest();
    }
    if (end == room()) {
      forget(horizon);
      boolean isCrowded = 2 * (end - first) > room();
      pack(Math.max(FIRST_ROOM, isCrowded ? 2 * room() : room()));
    }
    return end++;
  }

  /** Frees the places before the oldest and after the newest row. */
  final void trim() {
    pack(end - first);
  }

  private void pack(int room) {
    move(first, room);
    end -= first;
    found -= first;
    first = 0;
  }

  /** Drops all rows that ended by a time, but not the newest one. */
  private void forget(double time) {
    while (first < newest() && time(first + 1) <= time) {
      first++;
    }
  }

  final boolean isEmpty() {
    return first == end;
  }

  final int newest() {
    return end - 1;
  }

  /** The time from which the thing is known. */
  final double start() {
    return time(first);
  }

  /** From when on the newest row holds. */
  final double since() {
    return time(newest());
  }

  /** The last row that holds from a time or earlier; below that of the oldest one if none does. */
  public final int find(double t) {
    boolean isSame =
        first <= found
            && found < end
            && time(found) <= t
            && (found == newest() || t < time(found + 1));
    if (!isSame) {
      found = search(t);
    }
    return found;
  }

  private int search(double t) {
    int low = first - 1;
    int high = newest();
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (time(middle) <= t) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  /** Whether any row holds at a time. */
  final boolean holds(double t) {
    return find(t) >= first;
  }
}
