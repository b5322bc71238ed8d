// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static dev.carom.internal.state.MovingCircle.place;

import dev.carom.internal.search.Grid;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.DueTimes;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.sweep.LineShape;

/**
 * Finds the circles that are due in a step, some at a time, and prefetches what they will need:
 * their flights, the lines that they hit, and the lists of the cells around. Used for many circles
 * that ignore each other.
 *
 * <p>A single circle pays the latency of each of these reads in turn. The reads of several circles
 * are independent, so their latencies overlap. Nothing changes but the content of the cache.
 */
public final class DuePrefetcher {

  /** From this number on, the circles and their lines exceed a core's own cache. */
  public static final int LEAST_CIRCLES = 1 << 12;

  /** Circles found at a time. Measured: 8 to 64 gain the same. */
  private static final int BATCH = 16;

  /** If more than half of all circles are due, memory is read in order and needs no prefetch. */
  private static final int DENSE_SPAN = 2 * BATCH;

  private final CircleTable circles;
  private final StaticScene staticScene;
  private final int[] found = new int[BATCH];
  private int size;

  /** The number of found circles that were returned. */
  private int returned;

  /** The circle from which to search on. */
  private int from;

  /** Sink for prefetched values. Without a use of them the compiler would remove the loads. */
  @SuppressWarnings("UnusedVariable")
  private long sum;

  public DuePrefetcher(CircleTable circles, StaticScene staticScene) {
    this.circles = circles;
    this.staticScene = staticScene;
  }

  /** The first circle that is due until the given time; {@link DueTimes#size} if there is none. */
  public int first(double end) {
    from = 0;
    find(end);
    return next(end);
  }

  /**
   * The next circle that is due; {@link DueTimes#size} if there is none.
   *
   * @param end not later than in the call before
   */
  public int next(double end) {
    while (size > 0) {
      while (returned < size) {
        int i = found[returned++];
        if (circles.due.get(i) <= end) {
          return i;
        }
      }
      find(end);
    }
    return circles.due.size();
  }

  private void find(double end) {
    DueTimes due = circles.due;
    size = 0;
    returned = 0;
    int i = due.next(from, end);
    while (i < due.size() && size < BATCH) {
      found[size++] = i;
      i = due.next(i + 1, end);
    }
    from = i;
    if (size > 0 && found[size - 1] - found[0] > DENSE_SPAN) {
      read();
    }
  }

  private void read() {
    long read = 0;
    for (int k = 0; k < size; k++) {
      read += flight(found[k]);
    }
    for (int k = 0; k < size; k++) {
      read += whereItHits(found[k]);
    }
    sum += read;
  }

  /** Reads the first and the last number of each of its rows, which may lie in two cache lines. */
  private long flight(int i) {
    int k = circles.at(i);
    int c = circles.codesAt(i);
    return bits(circles.state[k + FlightRow.X])
        + bits(circles.state[k + CircleTable.RESTITUTION])
        + circles.codes[c + CircleTable.LAST]
        + circles.codes[c + CircleTable.STUCK]
        + bits(circles.gx(i))
        + circles.support(i);
  }

  private long whereItHits(int i) {
    int k = circles.at(i);
    double[] state = circles.state;
    double dt = state[k + CircleTable.CLEARED];
    double x = place(state[k + FlightRow.X], state[k + FlightRow.VX], circles.gx(i), dt);
    double y = place(state[k + FlightRow.Y], state[k + FlightRow.VY], circles.gy(i), dt);
    Grid grid = staticScene.grid(i);
    return line(circles.codes[circles.codesAt(i) + CircleTable.NEXT])
        + (grid == null ? 0 : grid.around(x, y));
  }

  private long line(int code) {
    if (!Codes.isLine(code)) {
      return 0;
    }
    double[] lines = staticScene.obstacles.lines.values;
    int k = code * LineShape.ROW;
    return bits(lines[k]) + bits(lines[k + LineShape.ROW - 1]);
  }

  private static long bits(double number) {
    return Double.doubleToRawLongBits(number);
  }
}
