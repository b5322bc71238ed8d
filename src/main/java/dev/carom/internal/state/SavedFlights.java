// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.Objects;

/** The saved flights of all live circles, in flat arrays, for a {@link WorldState}. */
public final class SavedFlights {

  // Columns of a circle, after those of its flight.
  public static final int RESTITUTION = FlightRow.SIZE;

  /**
   * Contacts with sensors among lines and pegs were reported up to this time, from the start of the
   * flight.
   */
  public static final int SENSED = 8;

  // The last contact of two circles that a sensor reported, as head and tail.
  private static final int MEETING = 9;
  private static final int MEETING_TAIL = 10;

  /** The number of doubles. */
  public static final int NUMBERS = 11;

  // The ints of a circle.
  public static final int LAST = 0;
  public static final int STUCK = 1;

  /** The largest code of the sensors met at exactly {@link #SENSED} that were reported. */
  public static final int SENSED_CODE = 2;

  private static final int PARTNER = 3;

  /** A {@link ContactWord} without a contact. */
  private static final int MEMORY = 4;

  /** The number of ints. */
  public static final int CODES = 5;

  /** The ids of the circles, ascending. */
  private final int[] ids;

  public final double[] numbers;
  public final int[] codes;

  /** The ignore list of each jammed circle; null if no circle is jammed. */
  public IgnoreList[] jams;

  /** Accelerations and supports; null if no circle falls, slides or rests. */
  private Accelerations accelerations;

  /**
   * The tail of the time of the next edit. It is above 0 if events after the head of that time
   * precede the edit.
   */
  public double tailOfEdit;

  public SavedFlights(int[] ids, double[] numbers, int[] codes, IgnoreList[] jams) {
    this.ids = ids;
    this.numbers = numbers;
    this.codes = codes;
    this.jams = jams;
  }

  /** Creates rows for circles with these ids, to be filled by {@link #put}. */
  public SavedFlights(int[] ids) {
    this(ids, new double[ids.length * NUMBERS], new int[ids.length * CODES], null);
  }

  public int count() {
    return ids.length;
  }

  /**
   * Saves the flight of the i-th live circle.
   *
   * @param sensed contacts with sensors were reported up to this time, from the start of the flight
   * @param sensedCode of the sensors met at exactly that time, those with a code up to this one
   *     were reported
   */
  public void put(int i, MovingCircle m, double sensed, int sensedCode) {
    int k = i * NUMBERS;
    FlightRow.put(m, numbers, k);
    numbers[k + RESTITUTION] = m.restitution;
    numbers[k + SENSED] = sensed;
    int c = i * CODES;
    codes[c + LAST] = m.last;
    codes[c + STUCK] = m.stuck;
    codes[c + SENSED_CODE] = sensedCode;
    codes[c + MEMORY] = ContactWord.of(m, 0);
    if (m.jam != null) {
      jams = jams == null ? new IgnoreList[count()] : jams;
      jams[i] = m.jam;
    }
    if (m.isFalling()) {
      putAcceleration(i, m);
    }
  }

  /** Saves what moves the i-th circle. */
  public void putAcceleration(int i, MovingCircle m) {
    accelerations = accelerations == null ? new Accelerations(count()) : accelerations;
    accelerations.put(i, m);
  }

  /** Whether any circle falls, slides or rests. */
  public boolean haveAccelerations() {
    return accelerations != null;
  }

  /**
   * Saves the last contact of the i-th circle that a sensor among circles reported; a head of -1
   * for none.
   */
  public void putSensed(int i, double head, double tail, int partner) {
    numbers[i * NUMBERS + MEETING] = head;
    numbers[i * NUMBERS + MEETING_TAIL] = head < 0 ? 0 : tail;
    codes[i * CODES + PARTNER] = head < 0 ? 0 : partner;
  }

  public double sensedHead(int i) {
    return numbers[i * NUMBERS + MEETING];
  }

  public double sensedTail(int i) {
    return numbers[i * NUMBERS + MEETING_TAIL];
  }

  /** The {@link ContactWord} of the i-th circle. */
  public int memory(int i) {
    return codes[i * CODES + MEMORY];
  }

  public int sensedPartner(int i) {
    return codes[i * CODES + PARTNER];
  }

  /**
   * Loads the flight of the i-th circle, without a prediction. The id of the moving circle stays.
   */
  public void get(int i, MovingCircle m) {
    int k = i * NUMBERS;
    int c = i * CODES;
    FlightRow.get(m, numbers, k);
    m.restitution = numbers[k + RESTITUTION];
    m.newFlight();
    m.cleared = numbers[k + SENSED];
    m.last = codes[c + LAST];
    m.stuck = codes[c + STUCK];
    m.sensedCode = codes[c + SENSED_CODE];
    ContactWord.recall(codes[c + MEMORY], m);
    m.jam = jams == null ? null : jams[i];
    m.fall(0, 0);
    m.slowContacts = 0;
    if (accelerations != null) {
      accelerations.get(i, m);
    }
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SavedFlights that
        && Double.compare(tailOfEdit, that.tailOfEdit) == 0
        && Arrays.equals(ids, that.ids)
        && Arrays.equals(numbers, that.numbers)
        && Arrays.equals(codes, that.codes)
        && Arrays.equals(jams, that.jams)
        && Objects.equals(accelerations, that.accelerations);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(numbers);
  }
}
