// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.queue.CalendarQueue;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;

/**
 * Reads what the next events will need, for many of them at once: whom they concern, with their
 * masses and times, the lists of the cells around, and the circles listed there. An event by itself
 * waits for memory once for each of these; the reads of many events do not depend on each other, so
 * their waits overlap, the more of them the less is to be computed in between. Nothing changes but
 * what is in the cache.
 */
public final class EventPrefetcher implements CalendarQueue.Prefetcher {

  /** From so many circles on their flights are more than a core's own cache holds: measured. */
  static final int LEAST_CIRCLES = 1 << 13;

  // Cells whose lists are gone through where a flight begins anew, and where one goes on.
  private static final int AROUND = 9;
  private static final int AHEAD = 5;

  private final CircleTable circles;
  private final CircleRegistry registry;
  private final NeighborGrid neighbors;

  /** Those on whom something is to be done, with their partners where two meet. */
  private final int[] concerned = new int[2 * CalendarQueue.MOST_PREFETCHED + 1];

  /** Those that only go on into another cell. */
  private final int[] crossing = new int[CalendarQueue.MOST_PREFETCHED + 1];

  /** The lists that will be needed: their places, and then their first circles. */
  private final int[] lists = new int[AROUND * 2 * CalendarQueue.MOST_PREFETCHED];

  /** What was read comes together here, for else it need not be read. */
  @SuppressWarnings("UnusedVariable")
  private double sum;

  public EventPrefetcher(CircleTable circles, CircleRegistry registry, NeighborGrid neighbors) {
    this.circles = circles;
    this.registry = registry;
    this.neighbors = neighbors;
  }

  @Override
  public void next(CalendarQueue queue, int[] ids, int size) {
    double read = 0;
    for (int k = 0; k < size; k++) {
      read += flight(ids[k]);
    }
    int crossings = 0;
    int others = 0;
    for (int k = 0; k < size; k++) {
      // Which it is cannot be foretold: it is written down for both.
      int isOther = (kind(ids[k]) - EventKind.CROSSING) >>> 31;
      concerned[others] = ids[k];
      others += isOther;
      crossing[crossings] = ids[k];
      crossings += 1 - isOther;
    }
    int end = addPartners(others);
    for (int k = others; k < end; k++) {
      read += flight(concerned[k]);
    }
    for (int k = 0; k < end; k++) {
      read += registry.mass(concerned[k]) + queue.time(concerned[k]);
    }
    listsAround(end);
    listsAhead(AROUND * end, crossings);
    sum += read + listed(firsts(end, crossings));
  }

  /** Adds whom the first circles that are concerned meet, and returns the end. */
  private int addPartners(int others) {
    int end = others;
    for (int k = 0; k < others; k++) {
      int i = concerned[k];
      concerned[end] = circles.codes[CircleTable.collidingCodesAt(i) + CircleTable.PARTNER];
      end += kind(i) == EventKind.PAIR ? 1 : 0;
    }
    return end;
  }

  /** Reads the cache lines of a circle's record: two of doubles, and one of ints. */
  private double flight(int i) {
    int a = CircleTable.collidingAt(i);
    return circles.state[a + FlightRow.X] + circles.state[a + CircleTable.MEETING] + kind(i);
  }

  private int kind(int i) {
    return circles.codes[CircleTable.collidingCodesAt(i) + CircleTable.KIND];
  }

  private void listsAround(int concerns) {
    for (int k = 0; k < concerns; k++) {
      int i = concerned[k];
      int column = neighbors.column(i);
      neighbors.cells(i).listsAround(column, neighbors.row(i), lists, AROUND * k);
    }
  }

  private void listsAhead(int from, int crossings) {
    for (int k = 0; k < crossings; k++) {
      int i = crossing[k];
      int way = kind(i) - EventKind.CROSSING;
      int column = neighbors.column(i);
      int row = neighbors.row(i);
      int dx = CellExit.columns(way);
      int dy = CellExit.rows(way);
      neighbors.cells(i).listsAhead(column, row, dx, dy, lists, from + AHEAD * k);
    }
  }

  /** Reads the lists at these places, and returns how many. */
  private int firsts(int concerns, int crossings) {
    for (int k = 0; k < concerns; k++) {
      neighbors.cells(concerned[k]).firsts(lists, AROUND * k, AROUND * (k + 1));
    }
    int from = AROUND * concerns;
    for (int k = 0; k < crossings; k++) {
      neighbors.cells(crossing[k]).firsts(lists, from + AHEAD * k, from + AHEAD * (k + 1));
    }
    return from + AHEAD * crossings;
  }

  /** Reads the first circles of so many lists. */
  private double listed(int size) {
    double read = 0;
    for (int k = 0; k < size; k++) {
      int j = Math.max(0, lists[k]);
      read += circles.state[CircleTable.collidingAt(j)] + kind(j);
    }
    return read;
  }
}
