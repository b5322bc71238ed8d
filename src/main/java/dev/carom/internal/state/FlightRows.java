// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * Recorded flights, each with the history of contacts at its start. Other circles are named by
 * their ids.
 */
final class FlightRows {

  private static final int FLIGHT = FlightRow.SIZE;

  // The ints of a flight.
  private static final int LAST = 0;
  private static final int STUCK = 1;

  /** A {@link ContactWord} without a contact. */
  private static final int MEMORY = 2;

  private static final int CONTACTS = 3;

  private double[] flights;
  private int[] contacts;

  /** The ignore list of each flight; null until a circle is jammed. */
  private IgnoreList[] jams;

  FlightRows(int room) {
    flights = new double[room * FLIGHT];
    contacts = new int[room * CONTACTS];
  }

  int room() {
    return contacts.length / CONTACTS;
  }

  void resize(int room) {
    flights = Arrays.copyOf(flights, room * FLIGHT);
    contacts = Arrays.copyOf(contacts, room * CONTACTS);
    jams = jams == null ? null : Arrays.copyOf(jams, room);
  }

  /**
   * Writes flight i.
   *
   * @param confined whether walls keep the circle inside
   */
  void put(int i, MovingCircle m, boolean confined, CircleRegistry registry) {
    int k = i * FLIGHT;
    FlightRow.put(m, flights, k);
    if (!confined) {
      flights[k + FlightRow.RADIUS] = -m.radius;
    }
    int c = i * CONTACTS;
    contacts[c + LAST] = registry.codeWithId(m.last);
    contacts[c + STUCK] = m.stuck;
    contacts[c + MEMORY] = ContactWord.of(m, 0);
    setJam(i, registry.jamWithIds(m.jam));
  }

  private void setJam(int i, IgnoreList jam) {
    if (jam != null && jams == null) {
      jams = new IgnoreList[room()];
    }
    if (jams != null) {
      jams[i] = jam;
    }
  }

  /** Copies a flight of another table to flight i. */
  void copy(int i, FlightRows from, int of) {
    System.arraycopy(from.flights, of * FLIGHT, flights, i * FLIGHT, FLIGHT);
    System.arraycopy(from.contacts, of * CONTACTS, contacts, i * CONTACTS, CONTACTS);
    setJam(i, from.jam(of));
  }

  /** Reads flight i, without a prediction. */
  void get(int i, MovingCircle m) {
    FlightRow.get(m, flights, i * FLIGHT);
    m.radius = radius(i);
    m.newFlight();
    m.last = last(i);
    m.stuck = stuck(i);
    ContactWord.recall(contacts[i * CONTACTS + MEMORY], m);
    m.jam = jam(i);
  }

  int last(int i) {
    return contacts[i * CONTACTS + LAST];
  }

  int stuck(int i) {
    return contacts[i * CONTACTS + STUCK];
  }

  IgnoreList jam(int i) {
    return jams == null ? null : jams[i];
  }

  /** The head of the start time of flight i. */
  double start(int i) {
    return flights[i * FLIGHT + FlightRow.T];
  }

  double startTail(int i) {
    return flights[i * FLIGHT + FlightRow.TL];
  }

  double x(int i, double t, double[] walls) {
    double start = flights[i * FLIGHT + FlightRow.X];
    double x = Math.fma(vx(i), since(i, t), start);
    return Confinement.x(isConfined(i) ? walls : null, start, x, radius(i));
  }

  double y(int i, double t, double[] walls) {
    double start = flights[i * FLIGHT + FlightRow.Y];
    double y = Math.fma(vy(i), since(i, t), start);
    return Confinement.y(isConfined(i) ? walls : null, start, y, radius(i));
  }

  private boolean isConfined(int i) {
    return flights[i * FLIGHT + FlightRow.RADIUS] > 0;
  }

  private double since(int i, double t) {
    return MovingCircle.since(start(i), startTail(i), t);
  }

  double vx(int i) {
    return flights[i * FLIGHT + FlightRow.VX];
  }

  double vy(int i) {
    return flights[i * FLIGHT + FlightRow.VY];
  }

  double radius(int i) {
    return Math.abs(flights[i * FLIGHT + FlightRow.RADIUS]);
  }
}
