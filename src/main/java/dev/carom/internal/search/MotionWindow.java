// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.ObstacleShape;
import java.util.Arrays;

/**
 * An index of the moving obstacles over a window of time. Each obstacle has a box around all that
 * it sweeps in the window. The plane is cut into strips along each axis. For each strip, one set of
 * bits holds the boxes that begin at or before it, and one those that end at or after it. So four
 * sets give the boxes that overlap a box, some others included.
 *
 * <p>The index is made when a search first needs it. An obstacle that changes later is
 * <i>loose</i>: each search finds it, until so many are loose that a new index pays.
 */
final class MotionWindow {

  /** Strips along an axis. */
  private static final int STRIPS = 64;

  /**
   * So many obstacles may be loose before a new index is made, besides the root of their number.
   */
  private static final int FEW = 8;

  /** Far more than the rounding of a place, in proportion to the coordinates. */
  private static final double ROUNDING = 0x1p-40;

  /** The time at which the window begins, and that at which it ends; it is empty at first. */
  double begin;

  double end;

  /** The boxes that a search found: bits by the numbers of {@link ObstacleMotions}. */
  long[] found = new long[0];

  /** The loose obstacles, as such bits, and their number. */
  private long[] loose = found;

  private int looseCount;

  /** Whether the next search has to make the index anew. */
  private boolean isStale = true;

  private final Axis x = new Axis();
  private final Axis y = new Axis();
  private final double[] row = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** One axis: the least and the largest coordinate of each box, and the sets of each strip. */
  private static final class Axis {

    private double[] low = new double[0];
    private double[] high = low;
    private double origin;
    private double perStrip;

    /** The boxes that begin in each strip or before it, and that end in it or after it. */
    private long[][] begun;

    private long[][] open;

    void clear(int count) {
      if (count != low.length) {
        low = new double[count];
        high = new double[count];
        begun = new long[STRIPS][words(count)];
        open = new long[STRIPS][words(count)];
      }
      Arrays.fill(low, Double.POSITIVE_INFINITY);
      Arrays.fill(high, Double.NEGATIVE_INFINITY);
    }

    void include(int i, double p, double radius) {
      double margin = radius + ROUNDING * (Math.abs(p) + radius);
      low[i] = Math.min(low[i], p - margin);
      high[i] = Math.max(high[i], p + margin);
    }

    void index() {
      origin = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (int i = 0; i < low.length; i++) {
        origin = Math.min(origin, low[i]);
        most = Math.max(most, high[i]);
      }
      perStrip = STRIPS / (most - origin);
      for (int s = 0; s < STRIPS; s++) {
        Arrays.fill(begun[s], 0);
        Arrays.fill(open[s], 0);
      }
      for (int i = 0; i < low.length; i++) {
        insert(i);
      }
    }

    private void insert(int i) {
      int word = i / Long.SIZE;
      long bit = 1L << i;
      for (int s = strip(low[i]); s < STRIPS; s++) {
        begun[s][word] |= bit;
      }
      for (int s = strip(high[i]); s >= 0; s--) {
        open[s][word] |= bit;
      }
    }

    /** The strip of a coordinate, or the nearest one. It never falls as the coordinate grows. */
    int strip(double p) {
      return (int) Math.max(0, Math.min(STRIPS - 1, (p - origin) * perStrip)); // 0 for NaN
    }
  }

  /** Opens a window of time; the index of the one before is dropped. */
  void open(double from, double to) {
    begin = from;
    end = to;
    isStale = true;
  }

  /** Notes that all obstacles may be others. */
  void changedAll() {
    isStale = true;
  }

  /** Notes that an obstacle is new, moves otherwise, or is gone. */
  void changed(ObstacleMotions motions, int code) {
    int i = motions.indexOf(code);
    isStale |= motions.count() != x.low.length; // other obstacles have these numbers now
    if (i >= 0 && !isStale && (loose[i / Long.SIZE] >>> i & 1) == 0) {
      loose[i / Long.SIZE] |= 1L << i;
      looseCount++;
      isStale = looseCount > FEW + Math.sqrt(motions.count());
    }
  }

  private void index(ObstacleTable obstacles) {
    int count = obstacles.motions().count();
    x.clear(count);
    y.clear(count);
    for (int i = 0; i < count; i++) {
      include(obstacles, i, begin);
      include(obstacles, i, end);
    }
    x.index();
    y.index();
    if (found.length != words(count)) {
      found = new long[words(count)];
      loose = new long[words(count)];
    }
    Arrays.fill(loose, 0);
    looseCount = 0;
    isStale = false;
  }

  /** How many longs hold so many bits. */
  private static int words(int bits) {
    return (bits + Long.SIZE - 1) / Long.SIZE;
  }

  private void include(ObstacleTable obstacles, int i, double time) {
    ObstacleRows rows = obstacles.of(obstacles.motions().code(i));
    ObstacleShape shape = rows.shape;
    obstacles.place(i, time, 0, row);
    double radius = shape.radius(row, 0);
    for (int k = 0; k <= shape.toEnd; k += 2) {
      x.include(i, row[k + ObstacleShape.X], radius);
      y.include(i, row[k + ObstacleShape.Y], radius);
    }
  }

  /**
   * Finds the obstacles whose boxes overlap a box, and maybe others. {@link #found} receives them.
   */
  void find(ObstacleTable obstacles, double left, double bottom, double right, double top) {
    if (isStale) {
      index(obstacles);
    }
    if (!((right - left) + (top - bottom) < Double.POSITIVE_INFINITY)) {
      System.arraycopy(x.begun[STRIPS - 1], 0, found, 0, found.length); // all
      return;
    }
    long[] begunX = x.begun[x.strip(right)];
    long[] openX = x.open[x.strip(left)];
    long[] begunY = y.begun[y.strip(top)];
    long[] openY = y.open[y.strip(bottom)];
    for (int word = 0; word < found.length; word++) {
      found[word] = begunX[word] & openX[word] & begunY[word] & openY[word] | loose[word];
    }
  }
}
