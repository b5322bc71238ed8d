// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The order of a log's rows by time, found by a stable sort. Times within a step are spread about
 * evenly. So rows are first distributed over as many time slots as there are rows, and a final
 * insertion sort moves little. If times cluster, it would move much, and a merge sort replaces it.
 * A few rows are sorted by counting, see {@link #rank}.
 */
final class TimeOrder {

  /** Up to this many rows, each is compared with each. Merging starts from runs of this length. */
  private static final int INSERTION_SORT_SIZE = 16;

  /** Moves per row after which insertion is abandoned: the cost of merging a million rows. */
  private static final int MOVES = 20;

  /** The row numbers in order; before {@link #sort}, in order of arrival. */
  int[] rows;

  private int[] merged;

  /** The position of the next row of each slot; in {@link #rank}, the position of each row. */
  private int[] ends;

  private double[] numbers;
  private final int stride;

  /**
   * Creates the order of the rows of an array, which is still empty.
   *
   * @param numbers rows that begin with their time
   * @param stride doubles of a row
   */
  TimeOrder(double[] numbers, int stride) {
    this.stride = stride;
    rows = new int[0];
    extend(numbers);
  }

  /** Replaces the array by a longer one that begins with the same rows. */
  final void extend(double[] numbers) {
    this.numbers = numbers;
    int capacity = numbers.length / stride;
    rows = Arrays.copyOf(rows, capacity);
    merged = new int[capacity];
    ends = new int[capacity];
  }

  /** Sorts the first rows, which are in order of arrival. */
  void sort(int size) {
    if (size <= INSERTION_SORT_SIZE) {
      rank(size);
      return;
    }
    distribute(size);
    if (!insert(0, size, (long) MOVES * size)) {
      merge(size);
    }
  }

  /** Counts, for each of a few rows, the rows before it. Branch-free on times. */
  private void rank(int size) {
    int[] before = ends;
    for (int i = 0; i < size; i++) {
      double time = time(i);
      int earlier = i;
      for (int k = 0; k < i; k++) {
        int isLater = (int) (Double.doubleToRawLongBits(time - time(k)) >>> 63);
        earlier -= isLater;
        before[k] += isLater;
      }
      before[i] = earlier;
    }
    for (int i = 0; i < size; i++) {
      rows[before[i]] = i;
    }
  }

  private double time(int row) {
    return numbers[row * stride];
  }

  private void distribute(int size) {
    double low = time(0);
    double high = low;
    for (int row = 1; row < size; row++) {
      low = Math.min(low, time(row));
      high = Math.max(high, time(row));
    }
    double perTime = size / (high - low);
    Arrays.fill(ends, 0, size, 0);
    for (int row = 0; row < size; row++) {
      ends[slot(row, low, perTime, size)]++;
    }
    int end = 0;
    for (int slot = 0; slot < size; slot++) {
      int count = ends[slot];
      ends[slot] = end;
      end += count;
    }
    for (int row = 0; row < size; row++) {
      rows[ends[slot(row, low, perTime, size)]++] = row;
    }
  }

  /** The slot of a row. Later times have no lower slots; NaN, from 0 / 0, counts as slot 0. */
  private int slot(int row, double low, double perTime, int size) {
    return Math.min((int) ((time(row) - low) * perTime), size - 1);
  }

  /**
   * Sorts a part; false if that takes more moves than allowed, with the part left in some order.
   */
  private boolean insert(int from, int to, long most) {
    long left = most;
    for (int i = from + 1; i < to && left >= 0; i++) {
      int row = rows[i];
      double time = time(row);
      int k = i - 1;
      while (k >= from && time(rows[k]) > time) {
        rows[k + 1] = rows[k];
        k--;
      }
      rows[k + 1] = row;
      left -= i - 1 - k;
    }
    return left >= 0;
  }

  private void merge(int size) {
    for (int i = 0; i < size; i += INSERTION_SORT_SIZE) {
      insert(i, Math.min(i + INSERTION_SORT_SIZE, size), Long.MAX_VALUE);
    }
    for (int width = INSERTION_SORT_SIZE; width < size; width *= 2) {
      for (int i = 0; i < size; i += 2 * width) {
        merge(i, Math.min(i + width, size), Math.min(i + 2 * width, size));
      }
      int[] before = rows;
      rows = merged;
      merged = before;
    }
  }

  private void merge(int from, int middle, int to) {
    int i = from;
    int k = middle;
    for (int out = from; out < to; out++) {
      boolean second = i == middle || (k < to && time(rows[k]) < time(rows[i]));
      merged[out] = second ? rows[k++] : rows[i++];
    }
  }
}
