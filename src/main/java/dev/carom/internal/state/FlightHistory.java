// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The recorded flights of one circle, in a ring buffer that drops the oldest flight when it is
 * full.
 */
public final class FlightHistory {

  /** Doubles of one flight. */
  static final int FLIGHT = FlightRow.SIZE;

  private static final int FIRST_ROOM = 8;

  private final int most;
  private double[] flights;
  private int oldest;
  private int size;
  private boolean dropped;

  /** The flight found last. The next query is usually about the same one. */
  private int found;

  /** The time at which the circle was removed. */
  private double end = Double.POSITIVE_INFINITY;

  /** Creates a history of at most that many flights. */
  FlightHistory(int most) {
    this.most = most;
    flights = new double[Math.min(most, FIRST_ROOM) * FLIGHT];
  }

  /**
   * Writes a flight to the row that begins at k. The radius is negative if walls do not keep the
   * circle inside.
   */
  static void put(MovingCircle m, ObstacleTable here, double[] rows, int k) {
    FlightRow.put(m, rows, k);
    if (here.wallsFor(m.filter) == null) {
      rows[k + FlightRow.RADIUS] = -m.radius;
    }
  }

  /** Adds a flight; drops the oldest one if there is no room. */
  void add(double[] numbers, int k) {
    if (size == most) {
      oldest = oldest + 1 == most ? 0 : oldest + 1;
      size--;
      dropped = true;
    } else if (size * FLIGHT == flights.length) {
      flights = Arrays.copyOf(flights, (int) Math.min(2L * size, most) * FLIGHT);
    }
    System.arraycopy(numbers, k, flights, at(size++), FLIGHT);
  }

  /** Ends the history: no flight is added after this. */
  void end(double now) {
    end = now;
    if (!dropped) {
      flights = Arrays.copyOf(flights, size * FLIGHT);
    }
  }

  /** The time at which the circle was removed; infinite while it exists. */
  double end() {
    return end;
  }

  /** The number of flights. */
  int size() {
    return size;
  }

  /** Whether flights were dropped for lack of room. */
  boolean hasDropped() {
    return dropped;
  }

  /** The start time of the oldest flight that is kept. */
  double start() {
    return startOf(0);
  }

  private double startOf(int i) {
    return flights[at(i) + FlightRow.T];
  }

  /** The index of the last flight that began by a time, which is not before the start. */
  public int find(double t) {
    if (!isAt(found, t)) {
      found = search(t);
    }
    return at(found);
  }

  private boolean isAt(int i, double t) {
    return i < size && startOf(i) <= t && (i + 1 == size || t < startOf(i + 1));
  }

  private int search(double t) {
    int low = 0;
    int high = size - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (startOf(middle) <= t) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  public double x(int k, double t, double[] walls) {
    double start = flights[k + FlightRow.X];
    double x = Math.fma(vx(k), since(k, t), start);
    return Confinement.x(isConfined(k) ? walls : null, start, x, radius(k));
  }

  public double y(int k, double t, double[] walls) {
    double start = flights[k + FlightRow.Y];
    double y = Math.fma(vy(k), since(k, t), start);
    return Confinement.y(isConfined(k) ? walls : null, start, y, radius(k));
  }

  private boolean isConfined(int k) {
    return flights[k + FlightRow.RADIUS] > 0;
  }

  private double since(int k, double t) {
    return MovingCircle.since(flights[k + FlightRow.T], flights[k + FlightRow.TL], t);
  }

  public double vx(int k) {
    return flights[k + FlightRow.VX];
  }

  public double vy(int k) {
    return flights[k + FlightRow.VY];
  }

  public double radius(int k) {
    return Math.abs(flights[k + FlightRow.RADIUS]);
  }

  /**
   * The index of flight i, counted from the oldest. Once flights were dropped, the array is a ring.
   */
  private int at(int i) {
    int place = oldest + i;
    return (place >= most ? place - most : place) * FLIGHT;
  }
}
