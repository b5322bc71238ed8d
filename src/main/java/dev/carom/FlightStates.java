// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/** What determines the flights of all circles, in flat arrays, for a {@link Snapshot}. */
final class FlightStates {

  /**
   * Doubles of one circle: x, y, vx, vy, t, tl, radius, restitution, anchor, sensed among what
   * stands still, and among circles (head and tail).
   */
  static final int NUMBERS = 13;

  /** Ints of one circle: the code last hit, impacts in one place, codes sensed, their pace. */
  static final int CODES = 5;

  final double[] numbers;
  final int[] codes;

  /** Null where no circle is jammed. */
  Jam[] jams;

  FlightStates(double[] numbers, int[] codes, Jam[] jams) {
    this.numbers = numbers;
    this.codes = codes;
    this.jams = jams;
  }

  /** Those of a number of circles, to be {@link #put}. */
  FlightStates(int count) {
    this(new double[count * NUMBERS], new int[count * CODES], null);
  }

  int count() {
    return codes.length / CODES;
  }

  /**
   * Puts a circle in.
   *
   * @param sensed up to when, from the start of the flight, sensors were reported
   * @param sensedCode of those met just then, up to which one
   */
  void put(Mover m, double sensed, int sensedCode) {
    int k = m.id * NUMBERS;
    numbers[k] = m.x;
    numbers[k + 1] = m.y;
    numbers[k + 2] = m.vx;
    numbers[k + 3] = m.vy;
    numbers[k + 4] = m.t;
    numbers[k + 5] = m.tl;
    numbers[k + 6] = m.radius;
    numbers[k + 7] = m.restitution;
    numbers[k + 8] = m.anchorX;
    numbers[k + 9] = m.anchorY;
    numbers[k + 10] = sensed;
    int c = m.id * CODES;
    codes[c] = m.last;
    codes[c + 1] = m.stuck;
    codes[c + 2] = sensedCode;
    codes[c + 4] = m.pace;
    if (m.jam != null) {
      jams = jams == null ? new Jam[count()] : jams;
      jams[m.id] = m.jam;
    }
  }

  /** Puts in the last meeting that circle i sensed; a head of -1 for none. */
  void putSensed(int i, double head, double tail, int partner) {
    numbers[i * NUMBERS + 11] = head;
    numbers[i * NUMBERS + 12] = head < 0 ? 0 : tail;
    codes[i * CODES + 3] = head < 0 ? 0 : partner;
  }

  double sensedHead(int i) {
    return numbers[i * NUMBERS + 11];
  }

  double sensedTail(int i) {
    return numbers[i * NUMBERS + 12];
  }

  int sensedPartner(int i) {
    return codes[i * CODES + 3];
  }

  /** Takes circle i out into a mover, with nothing known ahead of it. */
  void get(int i, Mover m) {
    int k = i * NUMBERS;
    int c = i * CODES;
    m.id = i;
    m.x = numbers[k];
    m.y = numbers[k + 1];
    m.vx = numbers[k + 2];
    m.vy = numbers[k + 3];
    m.t = numbers[k + 4];
    m.tl = numbers[k + 5];
    m.radius = numbers[k + 6];
    m.restitution = numbers[k + 7];
    m.newFlight();
    m.anchorX = numbers[k + 8];
    m.anchorY = numbers[k + 9];
    m.cleared = numbers[k + 10];
    m.last = codes[c];
    m.stuck = codes[c + 1];
    m.contact = codes[c + 2];
    m.pace = codes[c + 4];
    m.jam = jams == null ? null : jams[i];
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof FlightStates that
        && Arrays.equals(numbers, that.numbers)
        && Arrays.equals(codes, that.codes)
        && Arrays.equals(jams, that.jams);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers);
  }
}
