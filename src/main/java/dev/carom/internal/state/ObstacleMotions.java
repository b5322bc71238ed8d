// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.Coordinates;
import java.util.Arrays;
import java.util.SortedMap;

/**
 * The obstacles that move with a constant velocity, in the order of their codes: the velocity of
 * each, and the time at which it was where its row says. An obstacle that once moved stays listed
 * while it rests. Immutable.
 */
public final class ObstacleMotions {

  /** No obstacle moves. */
  public static final ObstacleMotions NONE = new ObstacleMotions(new int[0], new double[0]);

  // The columns of a row.
  private static final int UX = 0;
  private static final int UY = 1;
  private static final int SINCE = 2;
  private static final int ROW = 3;

  private final int[] codes;
  private final double[] rows;

  private ObstacleMotions(int[] codes, double[] rows) {
    this.codes = codes;
    this.rows = rows;
  }

  /** The obstacles with these velocities from time 0 on, by their codes. */
  static ObstacleMotions of(SortedMap<Integer, double[]> velocities) {
    double[] rows = new double[velocities.size() * ROW];
    int k = 0;
    for (double[] velocity : velocities.values()) {
      rows[k + UX] = velocity[0];
      rows[k + UY] = velocity[1];
      k += ROW;
    }
    int[] codes = velocities.keySet().stream().mapToInt(code -> code).toArray();
    return of(codes, rows);
  }

  /**
   * Obstacles of ascending codes.
   *
   * @param rows of each obstacle its velocity and the time at which it was where its row says
   */
  public static ObstacleMotions of(int[] codes, double[] rows) {
    return codes.length == 0 ? NONE : new ObstacleMotions(codes, rows);
  }

  public int count() {
    return codes.length;
  }

  public int code(int i) {
    return codes[i];
  }

  /** The number under which a code is listed; negative if it is not. */
  public int indexOf(int code) {
    return Arrays.binarySearch(codes, code);
  }

  public double ux(int i) {
    return rows[i * ROW + UX];
  }

  public double uy(int i) {
    return rows[i * ROW + UY];
  }

  /** The time at which obstacle i was where its row says. */
  public double since(int i) {
    return rows[i * ROW + SINCE];
  }

  /**
   * Moves the coordinates of a row, which are the first so many numbers, for a time dt. One that
   * would be infinite becomes the largest double.
   */
  static void shift(double[] row, int coordinates, double ux, double uy, double dt) {
    for (int k = 0; k < coordinates; k += 2) {
      row[k] = Coordinates.within(Math.fma(ux, dt, row[k]));
      row[k + 1] = Coordinates.within(Math.fma(uy, dt, row[k + 1]));
    }
  }

  /** A copy in which an obstacle has this velocity, and is where its row says at a given time. */
  public ObstacleMotions with(int code, double ux, double uy, double since) {
    int known = indexOf(code);
    int i = known < 0 ? -1 - known : known;
    int[] newCodes = known < 0 ? grown(codes, i) : codes.clone();
    double[] newRows = known < 0 ? grown(rows, i * ROW) : rows.clone();
    newCodes[i] = code;
    newRows[i * ROW + UX] = ux;
    newRows[i * ROW + UY] = uy;
    newRows[i * ROW + SINCE] = since;
    return new ObstacleMotions(newCodes, newRows);
  }

  private static int[] grown(int[] codes, int at) {
    int[] grown = Arrays.copyOf(codes, codes.length + 1);
    System.arraycopy(codes, at, grown, at + 1, codes.length - at);
    return grown;
  }

  private static double[] grown(double[] rows, int at) {
    double[] grown = Arrays.copyOf(rows, rows.length + ROW);
    System.arraycopy(rows, at, grown, at + ROW, rows.length - at);
    return grown;
  }

  /** A copy without one obstacle. */
  public ObstacleMotions without(int code) {
    int at = indexOf(code);
    if (at < 0) {
      return this;
    }
    int[] fewerCodes = Arrays.copyOf(codes, codes.length - 1);
    double[] fewerRows = Arrays.copyOf(rows, rows.length - ROW);
    System.arraycopy(codes, at + 1, fewerCodes, at, fewerCodes.length - at);
    System.arraycopy(rows, (at + 1) * ROW, fewerRows, at * ROW, fewerRows.length - at * ROW);
    return fewerCodes.length == 0 ? NONE : new ObstacleMotions(fewerCodes, fewerRows);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ObstacleMotions that
        && Arrays.equals(codes, that.codes)
        && Arrays.equals(rows, that.rows);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(codes) + Arrays.hashCode(rows);
  }
}
