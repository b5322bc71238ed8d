// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.queue.CalendarQueue;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.FlightRow;

/**
 * Prefetches what the next events will need, for many events at once: the flights, masses and times
 * of their circles, the lists of the cells around, and the circles listed there.
 *
 * <p>A single event pays the latency of each of these reads in turn. The reads of many events are
 * independent, so their latencies overlap. The less is computed between the reads, the more they
 * overlap. Nothing changes but the content of the cache.
 */
public final class EventPrefetcher implements CalendarQueue.Prefetcher {

  /** From this number on, the flights exceed a core's own cache: measured. */
  static final int LEAST_CIRCLES = 1 << 13;

  // The number of cells whose lists are needed: for an event that begins a flight, and for a
  // crossing.
  private static final int AROUND = 9;
  private static final int AHEAD = 5;

  private final CircleTable circles;
  private final CircleRegistry registry;
  private final NeighborGrid neighbors;

  /** Circles with an event other than a crossing, then their partners in collisions. */
  private final int[] concerned = new int[2 * CalendarQueue.MOST_PREFETCHED + 1];

  /** Circles that only cross into another cell. */
  private final int[] crossing = new int[CalendarQueue.MOST_PREFETCHED + 1];

  /** The lists that will be needed: first their indices, later their first circles. */
  private final int[] lists = new int[AROUND * 2 * CalendarQueue.MOST_PREFETCHED];

  /** Sink for prefetched values. Without a use of them the compiler would remove the loads. */
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
      // The kind is unpredictable, so the circle is written to both arrays, and one end advances.
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

  /** Appends the partners of the first circles that collide; returns the new end. */
  private int addPartners(int others) {
    int end = others;
    for (int k = 0; k < others; k++) {
      int i = concerned[k];
      concerned[end] = circles.codes[CircleTable.collidingCodesAt(i) + CircleTable.PARTNER];
      end += kind(i) == EventKind.PAIR ? 1 : 0;
    }
    return end;
  }

  /** Reads the three cache lines of a circle's row: two of doubles, one of ints. */
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

  /** Replaces the index of each list by its first circle; returns the number of lists. */
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

  /** Reads the first circles of that many lists. */
  private double listed(int size) {
    double read = 0;
    for (int k = 0; k < size; k++) {
      int j = Math.max(0, lists[k]);
      read += circles.state[CircleTable.collidingAt(j)] + kind(j);
    }
    return read;
  }
}
