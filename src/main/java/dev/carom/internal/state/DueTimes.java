// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The next event time of each circle. With many circles, each block of {@value #BLOCK} also has a
 * lower bound of its times. So one comparison passes over a block without an event.
 *
 * <p>Times are kept as their bits: the bits of doubles that are at least 0 have the same order.
 */
public final class DueTimes {

  private static final int SHIFT = 6;

  private static final int BLOCK = 1 << SHIFT;

  /** With at most this many circles each one is tested: measured, blocks gain nothing. */
  private static final int SCAN_LIMIT = 1024;

  private static final long NEVER_BITS = Double.doubleToRawLongBits(Double.POSITIVE_INFINITY);

  private long[] due;

  /** A lower bound of the times in each block. */
  private long[] earliest;

  /** Creates the times of circles 0 .. count - 1, all {@code +infinity}. */
  DueTimes(int count) {
    due = new long[count];
    earliest = new long[blocks(count)];
    clear();
  }

  private static int blocks(int circles) {
    return (circles + BLOCK - 1) >> SHIFT;
  }

  /** The number of circles for which there is room. */
  public int size() {
    return due.length;
  }

  /** Removes all events. */
  void clear() {
    Arrays.fill(due, NEVER_BITS);
    Arrays.fill(earliest, NEVER_BITS);
  }

  /** Makes room for more circles. */
  void extend(int count) {
    int before = due.length;
    int blocksBefore = earliest.length;
    due = Arrays.copyOf(due, count);
    earliest = Arrays.copyOf(earliest, blocks(count));
    Arrays.fill(due, before, count, NEVER_BITS);
    Arrays.fill(earliest, blocksBefore, earliest.length, NEVER_BITS);
  }

  public double get(int i) {
    return Double.longBitsToDouble(due[i]);
  }

  /** Sets the time of a circle, at least 0. */
  public void set(int i, double time) {
    // + 0 turns -0 into 0.
    long bits = Double.doubleToRawLongBits(time + 0.0);
    due[i] = bits;
    int block = i >> SHIFT;
    earliest[block] = Math.min(earliest[block], bits);
  }

  /**
   * The first circle from i on with an event until the given time; {@link #size} if there is none.
   */
  public int next(int i, double end) {
    long last = Double.doubleToRawLongBits(end + 0.0);
    return due.length <= SCAN_LIMIT ? first(i, due.length, last) : firstOfBlocks(i, last);
  }

  /** The circle that is due first; {@link #size} if none is due until the given time. */
  public int earliest(double end) {
    long last = Double.doubleToRawLongBits(end + 0.0);
    return due.length <= SCAN_LIMIT ? earliest(0, due.length, last) : earliestOfBlocks(last);
  }

  private int earliestOfBlocks(long last) {
    long best = last;
    int circle = due.length;
    for (int block = 0; block < earliest.length; block++) {
      if (earliest[block] <= best) {
        int from = block << SHIFT;
        int to = Math.min(from + BLOCK, due.length);
        refresh(from, to);
        int k = earliest(from, to, best);
        if (k < due.length) {
          circle = k;
          best = due[k] - 1; // of those due at the same time the first one is as good
        }
      }
    }
    return circle;
  }

  private int earliest(int from, int to, long last) {
    long best = last;
    int circle = due.length;
    for (int k = from; k < to; k++) {
      if (due[k] <= best) {
        best = due[k] - 1;
        circle = k;
      }
    }
    return circle;
  }

  private int firstOfBlocks(int i, long last) {
    int from = i;
    while (from < due.length) {
      int block = from >> SHIFT;
      int to = Math.min((block + 1) << SHIFT, due.length);
      if (earliest[block] <= last) {
        int k = first(from, to, last);
        if (k < to) {
          return k;
        }
        if (from == block << SHIFT) {
          refresh(from, to);
        }
      }
      from = to;
    }
    return due.length;
  }

  private int first(int from, int to, long last) {
    int k = from;
    while (k < to && due[k] > last) {
      k++;
    }
    return k;
  }

  /** Makes the lower bound of a block exact. */
  private void refresh(int from, int to) {
    long first = NEVER_BITS;
    for (int k = from; k < to; k++) {
      first = Math.min(first, due[k]);
    }
    earliest[from >> SHIFT] = first;
  }
}
