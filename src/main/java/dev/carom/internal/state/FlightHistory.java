// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The recorded past of one circle: a row for each flight, and for each change within a flight.
 * Other circles are named by their ids. What contact knows of it is kept at some times only.
 */
public final class FlightHistory extends History {

  /** The rows, by their places. */
  public final FlightTable rows = FlightTable.past();

  /** From when on the newest row holds: often another one replaces it, which starts then. */
  private double newestTime;

  /** From when on each row holds; null as long as all others hold from the start of a flight. */
  private double[] times;

  /** The properties that the circle has had since its last row. */
  private CircleProperties latest;

  /** All its properties; null as long as they are the same. */
  private Changes<CircleProperties> properties;

  /** Its {@link ContactRow}, at times at which all are kept; null before the first. */
  private Changes<double[]> contactRows;

  /** The time at which the circle was removed. */
  private double removed = Double.POSITIVE_INFINITY;

  @Override
  double time(int place) {
    if (place == newest()) {
      return newestTime;
    }
    return times == null ? rows.start(place) : times[place];
  }

  @Override
  int room() {
    return rows.capacity();
  }

  @Override
  void move(int by, int room) {
    rows.move(by, room);
    times = times == null ? null : Arrays.copyOfRange(times, by, by + room);
  }

  /**
   * Adds a row that holds from a time on.
   *
   * @param horizon what ended by this time may be dropped
   */
  void add(MovingCircle m, double time, CircleProperties its, double horizon) {
    boolean isNext = !isEmpty() && newestTime < time;
    int place = place(time, horizon);
    if (isNext && times == null && newestTime != rows.start(place - 1)) {
      times = new double[room()];
      Arrays.setAll(times, rows::start);
      times[place - 1] = newestTime;
    }
    newestTime = time;
    if (times != null) {
      times[place] = time;
    }
    rows.put(place, m);
    if (!its.equals(latest)) {
      setProperties(time, its, horizon);
    }
  }

  /** Keeps what contact knows of the circle from a time on, if that has changed. */
  void keepContact(double time, double[] row, double horizon) {
    contactRows = contactRows == null ? new Changes<>() : contactRows;
    if (!Arrays.equals(contactRows.last(), row)) {
      contactRows.set(time, row, horizon);
    }
  }

  private void setProperties(double time, CircleProperties its, double horizon) {
    if (latest != null && properties == null) {
      properties = new Changes<>();
      properties.set(Double.NEGATIVE_INFINITY, latest, horizon);
    }
    if (properties != null) {
      properties.set(time, its, horizon);
    }
    latest = its;
  }

  /** Ends the history: no row is added after this. */
  void end(double now) {
    removed = now;
    trim();
  }

  /** The time at which the circle was removed; infinite while it exists. */
  double end() {
    return removed;
  }

  public double x(double t, double[] walls) {
    int place = find(t);
    double free = rows.freeX(place, t);
    CircleProperties its = properties(t);
    return its.confined() ? rows.confinedX(place, free, its.radius(), walls) : free;
  }

  public double y(double t, double[] walls) {
    int place = find(t);
    double free = rows.freeY(place, t);
    CircleProperties its = properties(t);
    return its.confined() ? rows.confinedY(place, free, its.radius(), walls) : free;
  }

  private CircleProperties properties(double t) {
    return properties == null ? latest : properties.at(t);
  }

  /** The properties now; null before the first row. */
  CircleProperties properties() {
    return latest;
  }

  public double radius(double t) {
    return properties(t).radius();
  }

  /** Loads the circle as it was at a time, without a prediction, and returns its properties. */
  CircleProperties load(double t, MovingCircle m) {
    rows.get(find(t), m);
    m.forgetPrediction(0, 0);
    CircleProperties its = properties(t);
    m.restitution = its.restitution();
    m.radius = its.radius();
    m.contactRow = m.isMember() && contactRows != null ? contactRows.at(t) : null;
    return its;
  }
}
