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

  /** Acceleration and support in each flight; null until one falls, slides or rests. */
  private Accelerations accelerations;

  FlightRows(int room) {
    flights = new double[room * FLIGHT];
  }

  int room() {
    return flights.length / FLIGHT;
  }

  void resize(int room) {
    flights = Arrays.copyOf(flights, room * FLIGHT);
    jams = jams == null ? null : Arrays.copyOf(jams, room);
    if (accelerations != null) {
      accelerations.resize(room);
    }
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
    if (accelerations != null || m.isFalling()) {
      allowGravity();
      accelerations.put(i, m);
    }
  }

  private void allowGravity() {
    if (accelerations == null) {
      accelerations = new Accelerations(room());
    }
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
    if (from.accelerations != null) {
      allowGravity();
      accelerations.copy(i, from.accelerations, of);
    } else if (accelerations != null) {
      accelerations.clear(i);
    }
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
    m.fall(0, 0);
    m.slowContacts = 0;
    if (accelerations != null) {
      accelerations.get(i, m);
    }
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
    double x = MovingCircle.place(start, flights[i * FLIGHT + FlightRow.VX], gx(i), since(i, t));
    return Confinement.x(isConfined(i) ? walls : null, start, x, radius(i));
  }

  double y(int i, double t, double[] walls) {
    double start = flights[i * FLIGHT + FlightRow.Y];
    double y = MovingCircle.place(start, flights[i * FLIGHT + FlightRow.VY], gy(i), since(i, t));
    return Confinement.y(isConfined(i) ? walls : null, start, y, radius(i));
  }

  /** The sign tells, also of a radius of 0. */
  private boolean isConfined(int i) {
    return Double.doubleToRawLongBits(flights[i * FLIGHT + FlightRow.RADIUS]) >= 0;
  }

  private double since(int i, double t) {
    return MovingCircle.since(start(i), startTail(i), t);
  }

  double vx(int i, double t) {
    return MovingCircle.velocity(flights[i * FLIGHT + FlightRow.VX], gx(i), since(i, t));
  }

  double vy(int i, double t) {
    return MovingCircle.velocity(flights[i * FLIGHT + FlightRow.VY], gy(i), since(i, t));
  }

  private double gx(int i) {
    return accelerations == null ? 0 : accelerations.x(i);
  }

  private double gy(int i) {
    return accelerations == null ? 0 : accelerations.y(i);
  }

  double radius(int i) {
    return Math.abs(flights[i * FLIGHT + FlightRow.RADIUS]);
  }
}
