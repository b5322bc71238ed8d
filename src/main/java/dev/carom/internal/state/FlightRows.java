// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * Recorded flights, each with the history of contacts at its start. Other circles are named by
 * their ids.
 */
final class FlightRows {

  // The columns of a flight, after those of a FlightRow.
  private static final int LAST = FlightRow.SIZE;

  /** The bits of an int for the weight of impacts at one place, then of a {@link ContactWord}. */
  private static final int MEMORY = FlightRow.SIZE + 1;

  private static final int FLIGHT = FlightRow.SIZE + 2;

  private double[] flights;

  /** The ignore list of each flight; null until a circle is jammed. */
  private IgnoreList[] jams;

  FlightRows(int room) {
    flights = new double[room * FLIGHT];
  }

  int room() {
    return flights.length / FLIGHT;
  }

  void resize(int room) {
    flights = Arrays.copyOf(flights, room * FLIGHT);
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
    flights[k + LAST] = registry.codeWithId(m.last);
    long word = Integer.toUnsignedLong(ContactWord.of(m, 0));
    flights[k + MEMORY] = Double.longBitsToDouble((long) m.stuck << Integer.SIZE | word);
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
    setJam(i, from.jam(of));
  }

  /** Reads flight i, without a prediction. */
  void get(int i, MovingCircle m) {
    FlightRow.get(m, flights, i * FLIGHT);
    m.radius = radius(i);
    m.newFlight();
    m.last = last(i);
    m.stuck = stuck(i);
    ContactWord.recall((int) memory(i), m);
    m.jam = jam(i);
  }

  int last(int i) {
    return (int) flights[i * FLIGHT + LAST];
  }

  int stuck(int i) {
    return (int) (memory(i) >> Integer.SIZE);
  }

  private long memory(int i) {
    return Double.doubleToRawLongBits(flights[i * FLIGHT + MEMORY]);
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

  /** The sign tells, also of a radius of 0. */
  private boolean isConfined(int i) {
    return Double.doubleToRawLongBits(flights[i * FLIGHT + FlightRow.RADIUS]) >= 0;
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
