// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;

/** The recorded flights of one circle, the oldest dropped where there is no room. */
final class Track {

  /** Doubles of one flight: t, tl, x, y, vx, vy, radius. */
  private static final int FLIGHT = 7;

  private static final int FIRST_ROOM = 8;

  private final int most;
  private double[] flights;
  private int oldest;
  private int size;

  /** When the circle was removed. */
  double end = Double.POSITIVE_INFINITY;

  /** Of so many flights at most. */
  Track(int most) {
    this.most = most;
    flights = new double[Math.min(most, FIRST_ROOM) * FLIGHT];
  }

  int size() {
    return size;
  }

  void add(Mover m) {
    if (size == most) {
      oldest = oldest + 1 == most ? 0 : oldest + 1;
      size--;
    } else if (size * FLIGHT == flights.length) {
      flights = Arrays.copyOf(flights, (int) Math.min(2L * size, most) * FLIGHT);
    }
    int k = at(size++);
    flights[k] = m.t;
    flights[k + 1] = m.tl;
    flights[k + 2] = m.x;
    flights[k + 3] = m.y;
    flights[k + 4] = m.vx;
    flights[k + 5] = m.vy;
    flights[k + 6] = m.radius;
  }

  /** Drops the newest flight. */
  void drop() {
    size--;
  }

  /** When the oldest flight starts; {@code +infinity} without any. */
  double start() {
    return size == 0 ? Double.POSITIVE_INFINITY : flights[at(0)];
  }

  /** The place of the flight at a time that is not before the start: the last one begun by then. */
  int find(double t) {
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
    return at(low);
  }

  double x(int k, double t) {
    return Math.fma(flights[k + 4], t - flights[k] - flights[k + 1], flights[k + 2]);
  }

  double y(int k, double t) {
    return Math.fma(flights[k + 5], t - flights[k] - flights[k + 1], flights[k + 3]);
  }

  double vx(int k) {
    return flights[k + 4];
  }

  double vy(int k) {
    return flights[k + 5];
  }

  double radius(int k) {
    return flights[k + 6];
  }

  /** The place of flight i, from the oldest on; where flights were dropped, room is a ring. */
  private int at(int i) {
    int place = oldest + i;
    return (place >= most ? place - most : place) * FLIGHT;
  }
}
