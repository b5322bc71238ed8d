// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.sweep.Turn;
import dev.carom.internal.util.DoubleList;
import java.util.Arrays;
import java.util.SortedMap;

/**
 * The motions of obstacles, in the order of their codes: the velocity of each number of the
 * obstacle's row, or the turn about a pivot, and when the motion starts and ends. The row of the
 * obstacle says where it is at the start of a motion that never ends, and else at its end: so it
 * arrives there to the bit, and rests. An obstacle that once moved stays listed.
 *
 * <p>A <i>turn</i> rotates the vector w from the pivot to a point, by a complex number that is
 * linear in the time h from any moment on:
 *
 * <pre>
 * w(h) = w(0) c^2 / |c|^2    c = 1 + q h
 * </pre>
 *
 * <p>Its rate is {@code 2 Im(q) / |c|^2}. Seen from the moment h, q is {@code q / c(h)}. The
 * columns have q at the end of the turn.
 *
 * <p>Objects that share motions do not see each other's changes: see {@link #shared}.
 */
public final class ObstacleMotions {

  /** No obstacle moves. */
  public static final ObstacleMotions NONE =
      new ObstacleMotions(new int[0], new double[0]).shared();

  // The columns of a motion, after the velocities of the numbers of a row.
  private static final int PIVOT_X = ObstacleTable.MOST_NUMBERS;
  private static final int PIVOT_Y = PIVOT_X + 1;
  private static final int TURN_X = PIVOT_Y + 1;
  private static final int TURN_Y = TURN_X + 1;
  private static final int SINCE = TURN_Y + 1;
  private static final int UNTIL = SINCE + 1;

  /** The number of columns. */
  public static final int SIZE = UNTIL + 1;

  /** More than {@link #turn} of a quarter turn, sin(pi / 4). */
  public static final double MOST_TURN = 0.75;

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private int[] codes;
  private double[] motions;

  /** Whether another object may use these motions. */
  private boolean isShared;

  /** The earliest end of a motion; infinite if none ends. */
  private double nextEnd;

  /** Whether any is a turn. */
  private boolean areTurning;

  private ObstacleMotions(int[] codes, double[] motions) {
    this.codes = codes;
    this.motions = motions;
    findNextEnd();
  }

  private void findNextEnd() {
    nextEnd = NEVER;
    areTurning = false;
    for (int k = 0; k < codes.length * SIZE; k += SIZE) {
      nextEnd = Math.min(nextEnd, motions[k + UNTIL]);
      areTurning |= motions[k + TURN_Y] != 0;
    }
  }

  /** The obstacles with these velocities from time 0 on, by their codes. */
  static ObstacleMotions of(SortedMap<Integer, double[]> velocities) {
    DoubleList motions = new DoubleList();
    velocities.forEach((code, u) -> motions.add(motion(code, u[0], u[1], 0)));
    int[] codes = velocities.keySet().stream().mapToInt(code -> code).toArray();
    return of(codes, motions.toArray());
  }

  /** The motions of obstacles of ascending codes, one after the other. */
  public static ObstacleMotions of(int[] codes, double[] motions) {
    return codes.length == 0 ? NONE : new ObstacleMotions(codes, motions);
  }

  /** A motion of an obstacle with one velocity, which never ends. */
  public static double[] motion(int code, double ux, double uy, double since) {
    double[] motion = new double[SIZE];
    setStraight(motion, 0, code, ux, uy, since, NEVER);
    return motion;
  }

  /** Sets the motion at k to one with a velocity between two times. */
  public static void setStraight(
      double[] motions, int k, int code, double ux, double uy, double since, double until) {
    Arrays.fill(motions, k, k + SINCE, 0);
    motions[k + LineShape.AX] = ux;
    motions[k + LineShape.AY] = uy;
    motions[k + LineShape.BX] = Codes.isLine(code) ? ux : 0; // a radius stays
    motions[k + LineShape.BY] = Codes.isLine(code) ? uy : 0;
    motions[k + SINCE] = since;
    motions[k + UNTIL] = until;
  }

  /**
   * Sets a motion to a turn by an angle of at most a quarter turn about a pivot, between two times:
   * q is {@code (1 - e^(-i angle / 2)) / duration}.
   */
  public static void setTurn(
      double[] motion, double pivotX, double pivotY, double angle, double since, double until) {
    Arrays.fill(motion, 0, PIVOT_X, 0);
    motion[PIVOT_X] = pivotX;
    motion[PIVOT_Y] = pivotY;
    motion[TURN_X] = -Turn.q1(angle, until - since);
    motion[TURN_Y] = Turn.q2(angle, until - since);
    motion[SINCE] = since;
    motion[UNTIL] = until;
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

  /** A copy that nobody else uses, in the arrays of another one if they fit. */
  ObstacleMotions copyInto(ObstacleMotions other) {
    if (other.isShared || other.codes.length != codes.length) {
      return new ObstacleMotions(codes.clone(), motions.clone());
    }
    System.arraycopy(codes, 0, other.codes, 0, codes.length);
    System.arraycopy(motions, 0, other.motions, 0, motions.length);
    other.nextEnd = nextEnd;
    other.areTurning = areTurning;
    return other;
  }

  public int count() {
    return codes.length;
  }

  /** The codes of the obstacles, not to be changed. */
  public int[] codes() {
    return codes;
  }

  /** Their motions, {@link #SIZE} numbers each, not to be changed. */
  public double[] motions() {
    return motions;
  }

  public int code(int i) {
    return codes[i];
  }

  /** The number under which a code is listed; negative if it is not. */
  public int indexOf(int code) {
    return Arrays.binarySearch(codes, code);
  }

  public double ux(int i) {
    return velocity(i, ObstacleShape.X);
  }

  public double uy(int i) {
    return velocity(i, ObstacleShape.Y);
  }

  /** The start of motion i. */
  public double since(int i) {
    return motions[i * SIZE + SINCE];
  }

  /** The end of motion i; infinite if it never ends. */
  public double until(int i) {
    return motions[i * SIZE + UNTIL];
  }

  /** The earliest end of a motion; infinite if none ends. */
  public double nextEnd() {
    return nextEnd;
  }

  /** The velocity of a number of the row of obstacle i. */
  public double velocity(int i, int number) {
    return column(i, number);
  }

  private double column(int i, int column) {
    return motions[i * SIZE + column];
  }

  /** The larger component of the way of c in turn i, while |c| is 1 at both ends; else 0. */
  public double turn(int i) {
    double speed = Math.max(Math.abs(column(i, TURN_X)), Math.abs(column(i, TURN_Y)));
    return speed == 0 ? 0 : speed * (until(i) - since(i));
  }

  /** Whether any motion is a turn. */
  boolean areTurning() {
    return areTurning;
  }

  /** Whether motion i is a turn. */
  public boolean turns(int i) {
    return column(i, TURN_Y) != 0;
  }

  public double pivotX(int i) {
    return column(i, PIVOT_X);
  }

  public double pivotY(int i) {
    return column(i, PIVOT_Y);
  }

  /** The real part of q of motion i, seen from a time, given as head and tail. */
  public double turnX(int i, double head, double tail) {
    double qx = column(i, TURN_X);
    double qy = column(i, TURN_Y);
    double dt = elapsed(i, head, tail);
    double x = fma(qx, dt, 1);
    double y = qy * dt;
    return (qx * x + qy * y) / (x * x + y * y);
  }

  /** The imaginary part of that q: half of the angular velocity. */
  public double turnY(int i, double head, double tail) {
    double dt = elapsed(i, head, tail);
    double x = fma(column(i, TURN_X), dt, 1);
    double y = column(i, TURN_Y) * dt;
    return column(i, TURN_Y) / (x * x + y * y);
  }

  /** A copy of motion i. */
  double[] motion(int i) {
    return Arrays.copyOfRange(motions, i * SIZE, (i + 1) * SIZE);
  }

  /** The motion of one obstacle, as number 0. */
  ObstacleMotions only(int code) {
    return of(new int[] {code}, motion(indexOf(code)));
  }

  /**
   * How long obstacle i moves from where its row says to where it is at a time, given as head and
   * tail.
   */
  private double elapsed(int i, double head, double tail) {
    double until = until(i);
    return until == NEVER ? (head - since(i)) + tail : Math.min(0, (head - until) + tail);
  }

  /**
   * Writes the numbers of obstacle i at a time, given as head and tail; the largest double where
   * one would be infinite.
   *
   * @param numbers of them, from k on in an array
   * @param to receives them, from number {@code at} on; it may be the same array
   */
  void place(
      int i, double head, double tail, double[] from, int k, double[] to, int at, int numbers) {
    double dt = elapsed(i, head, tail);
    for (int c = 0; c < numbers; c++) {
      to[at + c] = Coordinates.within(fma(velocity(i, c), dt, from[k + c]));
    }
    if (turns(i)) {
      double x = fma(column(i, TURN_X), dt, 1);
      double y = column(i, TURN_Y) * dt;
      int ends = Codes.isLine(codes[i]) ? LineShape.END : 0;
      for (int c = 0; c <= ends; c += LineShape.END) {
        turn(pivotX(i), pivotY(i), x, y, to, at + c);
      }
    }
  }

  /**
   * Turns the point at k in an array about a pivot as c^2 turns, {@code c = (x, y)}. What is equal
   * stays so.
   *
   * <p>It adds {@code (c^2 / |c|^2 - 1) w}, which is {@code 2 y / |c|^2} times the vector {@code i
   * c w}.
   */
  public static void turn(double pivotX, double pivotY, double x, double y, double[] xy, int k) {
    double wx = xy[k] - pivotX;
    double wy = xy[k + 1] - pivotY;
    double part = 2 * y / (x * x + y * y);
    xy[k] = Coordinates.within(fma(-part, y * wx + x * wy, xy[k]));
    xy[k + 1] = Coordinates.within(fma(part, x * wx - y * wy, xy[k + 1]));
  }

  /** These motions, of which that of an obstacle has this velocity and never ends. */
  ObstacleMotions with(int code, double ux, double uy, double since) {
    ObstacleMotions all = withSome(code);
    setStraight(all.motions, all.indexOf(code) * SIZE, code, ux, uy, since, NEVER);
    all.findNextEnd();
    return all;
  }

  /** These motions, of which that of an obstacle is a given one. */
  ObstacleMotions with(int code, double[] motion) {
    ObstacleMotions all = withSome(code);
    System.arraycopy(motion, 0, all.motions, all.indexOf(code) * SIZE, SIZE);
    all.findNextEnd();
    return all;
  }

  /** These motions, of which that of an obstacle is to be set. */
  private ObstacleMotions withSome(int code) {
    int i = indexOf(code);
    if (i >= 0) {
      return own();
    }
    ObstacleMotions all = spliced(-1 - i, -i);
    all.codes[-1 - i] = code;
    return all;
  }

  /** These motions, of which that of an obstacle is number 0 of others; null if it has none. */
  ObstacleMotions with(int code, ObstacleMotions its) {
    return its == null ? without(code) : with(code, its.motion(0));
  }

  /** These motions without that of an obstacle. */
  ObstacleMotions without(int code) {
    int i = indexOf(code);
    return i < 0 ? this : spliced(i + 1, i);
  }

  /** A copy in which the motions from one number on have the numbers from another one on. */
  private ObstacleMotions spliced(int from, int to) {
    int after = codes.length - from;
    int[] itsCodes = Arrays.copyOf(codes, to + after);
    double[] its = Arrays.copyOf(motions, (to + after) * SIZE);
    System.arraycopy(codes, from, itsCodes, to, after);
    System.arraycopy(motions, from * SIZE, its, to * SIZE, after * SIZE);
    return of(itsCodes, its);
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
