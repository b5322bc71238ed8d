// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.search;

import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.ObstacleShape;
import java.util.Arrays;

/**
 * An index of the moving obstacles over a window of time. Each obstacle has a box around all that
 * it sweeps in the window. The plane is cut into strips along each axis. For each strip, one set of
 * bits holds the boxes that begin at or before it, and one those that end at or after it. So four
 * sets give the boxes that overlap a box, some others included.
 *
 * <p>{@link FlightSearch} tests the obstacles that it finds.
 *
 * <p>The index is made when a search first needs it. An obstacle that changes later is
 * <i>loose</i>: each search finds it, until so many are loose that a new index pays.
 */
final class MotionWindow {

  /** Strips along an axis. */
  private static final int STRIPS = 64;

  /** Far more than the rounding of a place, in proportion to the coordinates. */
  private static final double ROUNDING = 0x1p-40;

  /** An arc of at most a quarter turn is less than this part of its chord beside that. */
  private static final double SAGITTA = 0.25;

  /** The time at which the window begins, and that at which it ends; it is empty at first. */
  double begin;

  double end;

  /** The boxes that a search found: bits by the numbers of {@link ObstacleMotions}. */
  long[] found = new long[0];

  /** The loose obstacles, as such bits, and their number. */
  private long[] loose = found;

  private int looseCount;

  /** The number of obstacles in the index. */
  private int indexed;

  /** Whether the next search has to make the index anew. */
  private boolean isStale = true;

  private final Axis x = new Axis(BoxTree.LEFT);
  private final Axis y = new Axis(BoxTree.BOTTOM);
  private final double[] row = new double[ObstacleTable.MOST_NUMBERS + 1];
  private final double[] last = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** The boxes, as those of a {@link BoxTree}; the last one is for a place in between. */
  private double[] boxes = new double[0];

  /** One axis of the plane, which is cut into strips. */
  private static final class Axis {

    /** The column of the lower sides in {@link #boxes}; those of the upper sides follow. */
    private final int lower;

    private double origin;
    private double perStrip;

    /** The boxes that begin in each strip or before it, and that end in it or after it. */
    private long[][] begun;

    private long[][] open;

    Axis(int lower) {
      this.lower = lower;
    }

    void index(double[] boxes, int count) {
      begun = cleared(begun, count);
      open = cleared(open, count);
      origin = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (int k = lower; k < count * BoxTree.BOX; k += BoxTree.BOX) {
        origin = Math.min(origin, boxes[k]);
        most = Math.max(most, boxes[k + BoxTree.RIGHT]);
      }
      perStrip = STRIPS / (most - origin);
      for (int i = 0; i < count; i++) {
        int k = i * BoxTree.BOX + lower;
        begun[strip(boxes[k])][i / Long.SIZE] |= 1L << i;
        open[strip(boxes[k + BoxTree.RIGHT])][i / Long.SIZE] |= 1L << i;
      }
      for (int s = 1; s < STRIPS; s++) {
        include(begun[s], begun[s - 1]);
        include(open[STRIPS - 1 - s], open[STRIPS - s]);
      }
    }

    private static void include(long[] set, long[] other) {
      for (int word = 0; word < set.length; word++) {
        set[word] |= other[word];
      }
    }

    private static long[][] cleared(long[][] sets, int count) {
      if (sets == null || sets[0].length != words(count)) {
        return new long[STRIPS][words(count)];
      }
      for (long[] set : sets) {
        Arrays.fill(set, 0);
      }
      return sets;
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
    isStale |= motions.count() != indexed; // other obstacles have these numbers now
    if (i >= 0 && !isStale && (loose[i / Long.SIZE] >>> i & 1) == 0) {
      loose[i / Long.SIZE] |= 1L << i;
      looseCount++;
      isStale = Grids.areTooMany(looseCount, indexed);
    }
  }

  private void index(ObstacleTable obstacles) {
    indexed = obstacles.motions().count();
    if (boxes.length != (indexed + 1) * BoxTree.BOX) {
      boxes = new double[(indexed + 1) * BoxTree.BOX];
      found = new long[words(indexed)];
      loose = new long[words(indexed)];
    }
    for (int i = 0; i < indexed; i++) {
      put(obstacles, i);
    }
    x.index(boxes, indexed);
    y.index(boxes, indexed);
    Arrays.fill(loose, 0);
    looseCount = 0;
    isStale = false;
  }

  /** Puts the box around all that an obstacle sweeps in the window. */
  private void put(ObstacleTable obstacles, int i) {
    ObstacleShape shape = obstacles.of(obstacles.motions().code(i)).shape;
    obstacles.place(i, Math.max(begin, obstacles.motions().since(i)), 0, row);
    obstacles.place(i, end, 0, last);
    double size = 0;
    double chords = 0;
    for (int c = 0; c < shape.restitution; c++) {
      size += Math.abs(row[c]) + Math.abs(last[c]);
      chords += Math.abs(last[c] - row[c]);
    }
    double beside = obstacles.motions().turns(i) ? SAGITTA * chords : 0;
    BoxTree.put(boxes, i, shape, row, 0, ROUNDING * size + beside);
    BoxTree.put(boxes, indexed, shape, last, 0, ROUNDING * size + beside);
    BoxTree.include(boxes, i * BoxTree.BOX, boxes, indexed * BoxTree.BOX);
  }

  /** How many longs hold so many bits. */
  private static int words(int bits) {
    return (bits + Long.SIZE - 1) / Long.SIZE;
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
      found[word] = (begunX[word] & openX[word] & begunY[word] & openY[word]) | loose[word];
    }
  }
}
