// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.util.DoubleList;
import java.util.Arrays;
import java.util.SortedMap;

/**
 * The motions of obstacles, in the order of their codes: the velocity of each coordinate, and when
 * the motion starts and ends. The row of the obstacle says where it is at the start of a motion
 * that never ends, and else at its end: so it arrives there to the bit, and rests. An obstacle that
 * once moved stays listed.
 *
 * <p>Objects that share motions do not see each other's changes: see {@link #shared}.
 */
public final class ObstacleMotions {

  /** No obstacle moves. */
  public static final ObstacleMotions NONE =
      new ObstacleMotions(new int[0], new double[0]).shared();

  // The columns of a motion; that of a coordinate's velocity is its number in the obstacle's row.
  private static final int SINCE = 4;
  private static final int UNTIL = 5;
  private static final int SIZE = 6;

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private int[] codes;
  private double[] motions;

  /** Whether another object may use these motions. */
  private boolean isShared;

  private ObstacleMotions(int[] codes, double[] motions) {
    this.codes = codes;
    this.motions = motions;
  }

  /** The obstacles with these velocities from time 0 on, by their codes. */
  static ObstacleMotions of(SortedMap<Integer, double[]> velocities) {
    DoubleList motions = new DoubleList();
    velocities.values().forEach(u -> motions.add(motion(u[0], u[1], 0)));
    int[] codes = velocities.keySet().stream().mapToInt(code -> code).toArray();
    return of(codes, motions.toArray());
  }

  /** The motions of obstacles of ascending codes, one after the other. */
  public static ObstacleMotions of(int[] codes, double[] motions) {
    return codes.length == 0 ? NONE : new ObstacleMotions(codes, motions);
  }

  /** A motion of all coordinates with one velocity, which never ends. */
  public static double[] motion(double ux, double uy, double since) {
    return new double[] {ux, uy, ux, uy, since, NEVER};
  }

  /** The same, for one more object to use: whichever is to be changed is copied first. */
  ObstacleMotions shared() {
    if (!isShared) {
      isShared = true; // written only if need be: a scene is used by many threads
    }
    return this;
  }

  private ObstacleMotions own() {
    return isShared ? new ObstacleMotions(codes.clone(), motions.clone()) : this;
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
    return motions[i * SIZE + ObstacleShape.X];
  }

  public double uy(int i) {
    return motions[i * SIZE + ObstacleShape.Y];
  }

  /** The start of motion i. */
  public double since(int i) {
    return motions[i * SIZE + SINCE];
  }

  /** A copy of motion i. */
  double[] motion(int i) {
    return Arrays.copyOfRange(motions, i * SIZE, (i + 1) * SIZE);
  }

  /**
   * Moves the coordinates of an obstacle's row, which are the first so many numbers, from where the
   * row says to where they are at a time, given as head and tail.
   */
  void place(int i, double[] row, int coordinates, double head, double tail) {
    place(motions, i * SIZE, row, coordinates, head, tail);
  }

  /** The same for a motion at k. A coordinate that would be infinite becomes the largest double. */
  static void place(
      double[] motions, int k, double[] row, int coordinates, double head, double tail) {
    double until = motions[k + UNTIL];
    double dt =
        until == NEVER ? (head - motions[k + SINCE]) + tail : Math.min(0, (head - until) + tail);
    for (int c = 0; c < coordinates; c++) {
      row[c] = Coordinates.within(fma(motions[k + c], dt, row[c]));
    }
  }

  /** These motions, of which that of an obstacle never ends and has this velocity. */
  ObstacleMotions with(int code, double ux, double uy, double since) {
    ObstacleMotions all = own();
    int i = indexOf(code);
    if (i < 0) {
      i = -1 - i;
      all.makeRoom(i);
      all.codes[i] = code;
    }
    double[] its = all.motions;
    int k = i * SIZE;
    its[k + LineShape.AX] = ux;
    its[k + LineShape.AY] = uy;
    its[k + LineShape.BX] = ux;
    its[k + LineShape.BY] = uy;
    its[k + SINCE] = since;
    its[k + UNTIL] = NEVER;
    return all;
  }

  private void makeRoom(int i) {
    int after = codes.length - i;
    int[] moreCodes = Arrays.copyOf(codes, codes.length + 1);
    double[] more = Arrays.copyOf(motions, motions.length + SIZE);
    System.arraycopy(codes, i, moreCodes, i + 1, after);
    System.arraycopy(motions, i * SIZE, more, (i + 1) * SIZE, after * SIZE);
    codes = moreCodes;
    motions = more;
  }

  /** These motions without that of an obstacle. */
  ObstacleMotions without(int code) {
    int i = indexOf(code);
    if (i < 0) {
      return this;
    }
    int after = codes.length - i - 1;
    int[] fewerCodes = Arrays.copyOf(codes, codes.length - 1);
    double[] fewer = Arrays.copyOf(motions, motions.length - SIZE);
    System.arraycopy(codes, i + 1, fewerCodes, i, after);
    System.arraycopy(motions, (i + 1) * SIZE, fewer, i * SIZE, after * SIZE);
    return of(fewerCodes, fewer);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ObstacleMotions that
        && Arrays.equals(codes, that.codes)
        && Arrays.equals(motions, that.motions);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(codes) + Arrays.hashCode(motions);
  }
}
