// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Objects;

/**
 * The recorded flights of one circle, in a ring buffer that drops the oldest flight when it is
 * full, and what changed within them.
 */
public final class FlightHistory {

  private static final int FIRST_ROOM = 8;

  /**
   * A change within a flight, which holds for the rest of it.
   *
   * @param flight the number of the flight, counted from the first that was ever added
   * @param sensedHead the time of the last contact of two circles that a sensor reported, as head
   *     and tail; -1 for none
   * @param partner the id of the other circle in that contact
   */
  private record Amendment(
      long flight,
      int last,
      int stuck,
      IgnoreList jam,
      double sensedHead,
      double sensedTail,
      int partner) {

    boolean isContact(int itsLast, int itsStuck, IgnoreList itsJam) {
      return last == itsLast && stuck == itsStuck && Objects.equals(jam, itsJam);
    }
  }

  private final int most;
  private final FlightRows rows;
  private int oldest;
  private int size;

  /** The number of flights that were ever added. */
  private long begun;

  private final CircleProperties firstProperties;

  /** The properties since; null until the first change. */
  private Changes<CircleProperties> properties;

  /** Null until the first. */
  private Changes<Amendment> amendments;

  /** Whether anything was dropped for lack of room. */
  private boolean drops;

  /** The time from which no change within a flight was dropped. */
  private double completeFrom = Double.NEGATIVE_INFINITY;

  /** The flight found last. The next query is usually about the same one. */
  private int found;

  /** The time at which the circle was removed. */
  private double end = Double.POSITIVE_INFINITY;

  /** Creates a history of at most that many flights. */
  FlightHistory(int most, CircleProperties properties) {
    this.most = most;
    firstProperties = properties;
    rows = new FlightRows(Math.min(most, FIRST_ROOM));
  }

  /** Adds a flight; drops the oldest one if there is no room. */
  void add(MovingCircle m, boolean confined, CircleRegistry registry) {
    rows.put(next(), m, confined, registry);
  }

  /** Adds flight i of a table. */
  void add(FlightRows from, int i) {
    rows.copy(next(), from, i);
  }

  /** The index of the row for the next flight. */
  private int next() {
    begun++;
    if (size == most) {
      oldest = oldest + 1 == most ? 0 : oldest + 1;
      size--;
      drops = true;
    } else if (size == rows.room()) {
      rows.resize((int) Math.min(2L * size, most));
    }
    return at(size++);
  }

  /** Notes that properties are other ones from a time on. */
  void noteProperties(double from, CircleProperties its) {
    properties = properties == null ? new Changes<>() : properties;
    properties.set(from, its);
    if (properties.keep(most)) {
      complete(properties.start());
    }
  }

  /** Notes the contacts of the last flight from a time on, if they are not those known. */
  void noteContacts(double from, int last, int stuck, IgnoreList jam) {
    Amendment known = lastAmendment();
    if (!known.isContact(last, stuck, jam)) {
      amend(
          from,
          new Amendment(
              begun, last, stuck, jam, known.sensedHead, known.sensedTail, known.partner));
    }
  }

  /** Notes a contact with another circle that a sensor reported. */
  void noteSensed(double head, double tail, int partner) {
    Amendment known = lastAmendment();
    amend(head, new Amendment(begun, known.last, known.stuck, known.jam, head, tail, partner));
  }

  private void amend(double from, Amendment amendment) {
    amendments = amendments == null ? new Changes<>() : amendments;
    amendments.set(from, amendment);
    if (amendments.keep(most)) {
      complete(amendments.start());
    }
  }

  private void complete(double from) {
    drops = true;
    completeFrom = Math.max(completeFrom, from);
  }

  private Amendment lastAmendment() {
    Amendment last = amendments == null ? null : amendments.last();
    return last != null && last.flight == begun ? last : unamended(size - 1);
  }

  private Amendment unamended(int i) {
    int row = at(i);
    return new Amendment(number(i), rows.last(row), rows.stuck(row), rows.jam(row), -1, 0, 0);
  }

  private Amendment amendment(int i, double t) {
    Amendment last = amendments == null ? null : amendments.at(t);
    return last != null && last.flight == number(i) ? last : unamended(i);
  }

  /** The number of flight i, counted from the first that was ever added. */
  private long number(int i) {
    return begun - size + 1 + i;
  }

  /** Ends the history: no flight is added after this. */
  void end(double now) {
    end = now;
    if (begun == size) {
      rows.resize(size);
    }
  }

  /** The time at which the circle was removed; infinite while it exists. */
  double end() {
    return end;
  }

  /** The number of flights and of changes within them. */
  int size() {
    return size
        + (amendments == null ? 0 : amendments.size())
        + (properties == null ? 0 : properties.size());
  }

  /** The time from which nothing was dropped for lack of room. */
  double completeFrom() {
    return drops ? Math.max(completeFrom, startOf(0)) : completeFrom;
  }

  /** Whether anything was dropped for lack of room. */
  boolean hasDropped() {
    return drops;
  }

  /** The start time of the oldest flight that is kept. */
  double start() {
    return startOf(0);
  }

  private double startOf(int i) {
    return rows.start(at(i));
  }

  /** The index of the last flight that began by a time, which is not before the start. */
  public int find(double t) {
    return at(indexAt(t));
  }

  private int indexAt(double t) {
    if (!isAt(found, t)) {
      found = search(t);
    }
    return found;
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
    return rows.x(k, t, walls);
  }

  public double y(int k, double t, double[] walls) {
    return rows.y(k, t, walls);
  }

  public double vx(int k, double t) {
    return rows.vx(k, t);
  }

  public double vy(int k, double t) {
    return rows.vy(k, t);
  }

  public double radius(int k) {
    return rows.radius(k);
  }

  /** The properties at a time. */
  CircleProperties properties(double t) {
    CircleProperties changed = properties == null ? null : properties.at(t);
    return changed == null ? firstProperties : changed;
  }

  /** Loads the circle as it was at a time, with ids for other circles, without a prediction. */
  void load(double t, MovingCircle m) {
    int i = indexAt(t);
    rows.get(at(i), m);
    m.restitution = properties(t).restitution();
    Amendment its = amendment(i, t);
    m.last = its.last;
    m.stuck = its.stuck;
    m.jam = its.jam;
  }

  /**
   * Saves the last contact that a sensor among circles had reported at a time, as number k.
   *
   * @param ids the ids of the circles that existed then, ascending
   */
  void saveSensed(double t, int[] ids, int k, SavedFlights states) {
    Amendment its = amendment(indexAt(t), t);
    states.putSensed(k, its.sensedHead, its.sensedTail, CircleRegistry.lastId(ids, its.partner));
  }

  /** The tail of the last event of this circle if that was at a time; at least 0. */
  double tail(double t) {
    int i = indexAt(t);
    Amendment its = amendment(i, t);
    double ofFlight = startOf(i) == t ? rows.startTail(at(i)) : 0;
    double ofSensor = its.sensedHead == t ? its.sensedTail : 0;
    return Math.max(0, Math.max(ofFlight, ofSensor));
  }

  /**
   * The index of flight i, counted from the oldest. Once flights were dropped, the array is a ring.
   */
  private int at(int i) {
    int place = oldest + i;
    return place >= most ? place - most : place;
  }
}
