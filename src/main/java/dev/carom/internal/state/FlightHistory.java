// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/** The recorded flights of one circle, the oldest dropped where there is no room. */
public final class FlightHistory {

  /** Doubles of one flight: t, tl, x, y, vx, vy, radius. */
  static final int FLIGHT = 7;

  private static final int FIRST_ROOM = 8;

  private final int most;
  private double[] flights;
  private int oldest;
  private int size;
  private boolean dropped;

  /** The flight that was found last: as a rule the next question is about it, too. */
  private int found;

  /** When the circle was removed. */
  private double end = Double.POSITIVE_INFINITY;

  /** Of so many flights at most. */
  FlightHistory(int most) {
    this.most = most;
    flights = new double[Math.min(most, FIRST_ROOM) * FLIGHT];
  }

  /** Puts a mover's flight down as numbers. */
  static void put(MovingCircle m, double[] numbers, int k) {
    numbers[k] = m.t;
    numbers[k + 1] = m.tl;
    numbers[k + 2] = m.x;
    numbers[k + 3] = m.y;
    numbers[k + 4] = m.vx;
    numbers[k + 5] = m.vy;
    numbers[k + 6] = m.radius;
  }

  /** Adds a flight; the oldest one gives way if there is no room. */
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

  /** Ends it: no flight is added any more. */
  void end(double now) {
    end = now;
    if (!dropped) {
      flights = Arrays.copyOf(flights, size * FLIGHT);
    }
  }

  /** When the circle was removed; infinite while it is there. */
  double end() {
    return end;
  }

  /** The number of flights. */
  int size() {
    return size;
  }

  /** Whether flights were dropped for want of room. */
  boolean hasDropped() {
    return dropped;
  }

  /** When the oldest flight that is left starts. */
  double start() {
    return flights[at(0)];
  }

  /** The place of the flight at a time that is not before the start: the last one begun by then. */
  public int find(double t) {
    if (!isAt(found, t)) {
      found = search(t);
    }
    return at(found);
  }

  private boolean isAt(int i, double t) {
    return i < size && flights[at(i)] <= t && (i + 1 == size || t < flights[at(i + 1)]);
  }

  private int search(double t) {
    int low = 0;
    int high = size - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (flights[at(middle)] <= t) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  public double x(int k, double t, double[] walls) {
    double start = flights[k + 2];
    double x = Math.fma(flights[k + 4], MovingCircle.since(flights[k], flights[k + 1], t), start);
    return Confinement.x(walls, start, x, radius(k));
  }

  public double y(int k, double t, double[] walls) {
    double start = flights[k + 3];
    double y = Math.fma(flights[k + 5], MovingCircle.since(flights[k], flights[k + 1], t), start);
    return Confinement.y(walls, start, y, radius(k));
  }

  public double vx(int k) {
    return flights[k + 4];
  }

  public double vy(int k) {
    return flights[k + 5];
  }

  public double radius(int k) {
    return flights[k + 6];
  }

  /** The place of flight i, from the oldest on; where flights were dropped, room is a ring. */
  private int at(int i) {
    int place = oldest + i;
    return (place >= most ? place - most : place) * FLIGHT;
  }
}
