// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * What determines the flights of all circles that are there, in flat arrays, for a {@link
 * WorldState}.
 */
public final class SavedFlights {

  /**
   * Doubles of one circle: x, y, vx, vy, t, tl, radius, restitution, sensed among what stands
   * still, and among circles (head and tail).
   */
  public static final int NUMBERS = 11;

  /**
   * Ints of one circle: the code last hit, the weight of impacts at one place, codes sensed, marks.
   */
  public static final int CODES = 5;

  /** Of each circle, ascending. */
  private final int[] ids;

  public final double[] numbers;
  public final int[] codes;

  /** Null where no circle is jammed. */
  public IgnoreList[] jams;

  /** The tail of the time of the next edit, where an edit comes after events of other circles. */
  public double tailOfEdit;

  public SavedFlights(int[] ids, double[] numbers, int[] codes, IgnoreList[] jams) {
    this.ids = ids;
    this.numbers = numbers;
    this.codes = codes;
    this.jams = jams;
  }

  /** Those of circles with these ids, to be {@link #put}. */
  public SavedFlights(int[] ids) {
    this(ids, new double[ids.length * NUMBERS], new int[ids.length * CODES], null);
  }

  public int count() {
    return ids.length;
  }

  /**
   * Puts in the circle that is number i of those that are there.
   *
   * @param sensed up to when, from the start of the flight, sensors were reported
   * @param sensedCode of those met just then, up to which one
   */
  public void put(int i, MovingCircle m, double sensed, int sensedCode) {
    int k = i * NUMBERS;
    numbers[k] = m.x;
    numbers[k + 1] = m.y;
    numbers[k + 2] = m.vx;
    numbers[k + 3] = m.vy;
    numbers[k + 4] = m.t;
    numbers[k + 5] = m.tl;
    numbers[k + 6] = m.radius;
    numbers[k + 7] = m.restitution;
    numbers[k + 8] = sensed;
    int c = i * CODES;
    codes[c] = m.last;
    codes[c + 1] = m.stuck;
    codes[c + 2] = sensedCode;
    codes[c + 4] = m.marks();
    if (m.jam != null) {
      jams = jams == null ? new IgnoreList[count()] : jams;
      jams[i] = m.jam;
    }
  }

  /** Puts in the last meeting that this circle sensed; a head of -1 for none. */
  public void putSensed(int i, double head, double tail, int partner) {
    numbers[i * NUMBERS + 9] = head;
    numbers[i * NUMBERS + 10] = head < 0 ? 0 : tail;
    codes[i * CODES + 3] = head < 0 ? 0 : partner;
  }

  public double sensedHead(int i) {
    return numbers[i * NUMBERS + 9];
  }

  public double sensedTail(int i) {
    return numbers[i * NUMBERS + 10];
  }

  public int sensedPartner(int i) {
    return codes[i * CODES + 3];
  }

  /** Takes that circle out into a mover, whose id stays, with nothing known ahead of it. */
  public void get(int i, MovingCircle m) {
    int k = i * NUMBERS;
    int c = i * CODES;
    m.x = numbers[k];
    m.y = numbers[k + 1];
    m.vx = numbers[k + 2];
    m.vy = numbers[k + 3];
    m.t = numbers[k + 4];
    m.tl = numbers[k + 5];
    m.radius = numbers[k + 6];
    m.restitution = numbers[k + 7];
    m.newFlight();
    m.cleared = numbers[k + 8];
    m.last = codes[c];
    m.stuck = codes[c + 1];
    m.contact = codes[c + 2];
    m.setMarks(codes[c + 4]);
    m.jam = jams == null ? null : jams[i];
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SavedFlights that
        && Double.compare(tailOfEdit, that.tailOfEdit) == 0
        && Arrays.equals(ids, that.ids)
        && Arrays.equals(numbers, that.numbers)
        && Arrays.equals(codes, that.codes)
        && Arrays.equals(jams, that.jams);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers);
  }
}
