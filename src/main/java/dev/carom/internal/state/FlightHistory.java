// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * The recorded past of one circle: a row for each flight, and for each change within a flight, in
 * order of time. Other circles are named by their ids.
 */
public final class FlightHistory extends FlightTable {

  private static final int FIRST_ROOM = 8;

  private final int most;

  /** The properties of the circle at first. */
  private CircleProperties firstProperties;

  /** Those since; null until the first change. */
  private Changes<CircleProperties> properties;

  /** From when on each row holds; null as long as each holds from the start of its flight. */
  private double[] times;

  /** The number of rows, and the place of the oldest one in the arrays: these are a ring. */
  private int size;

  private int oldest;

  /** From when on the newest row holds. */
  private double newest = Double.NEGATIVE_INFINITY;

  /** The row found last. The next query is usually about the same one. */
  private int found;

  /** The time at which the circle was removed. */
  private double removed = Double.POSITIVE_INFINITY;

  /** Creates a history of at most that many rows. */
  FlightHistory(int most) {
    super(Math.min(most, FIRST_ROOM), 0, NUMBERS, 0, 0);
    this.most = most;
  }

  /**
   * Adds a row that holds from a time on, in place of one that holds from the same time.
   *
   * @return whether the oldest row was dropped
   */
  boolean add(MovingCircle m, double time, CircleProperties its) {
    boolean replaces = newest >= time;
    newest = time;
    boolean drops = !replaces && size == most;
    if (drops) {
      oldest = place(1);
    } else if (!replaces && size++ == capacity()) {
      extend((int) Math.min(2L * size, most));
    }
    int k = place(size - 1);
    if (times == null && time != m.t) {
      times = new double[capacity()];
      Arrays.setAll(times, this::start);
    }
    if (times != null) {
      times[k] = time;
    }
    put(k, m);
    setProperties(time, its);
    return drops;
  }

  private void setProperties(double time, CircleProperties its) {
    if (firstProperties == null) {
      firstProperties = its;
    } else if (!its.equals(properties())) {
      properties = properties == null ? new Changes<>() : properties;
      properties.set(time, its);
      properties.keep(most); // each change has a row
    }
  }

  private void extend(int room) {
    resize(room);
    times = times == null ? null : Arrays.copyOf(times, room);
  }

  /** The place of row i in the arrays. */
  private int place(int i) {
    int place = oldest + i;
    return place < capacity() ? place : place - capacity();
  }

  /** Ends the history: no row is added after this. */
  void end(double now) {
    removed = now;
    if (size < capacity()) {
      extend(size);
    }
  }

  /** The time at which the circle was removed; infinite while it exists. */
  double end() {
    return removed;
  }

  int size() {
    return size;
  }

  /** The time from which the circle is known. */
  double start() {
    return time(place(0));
  }

  private double time(int k) {
    return times == null ? start(k) : times[k];
  }

  /** The last row that holds from a time or earlier; the time is not before the start. */
  public int find(double t) {
    boolean isSame =
        found < size
            && time(place(found)) <= t
            && (found + 1 == size || t < time(place(found + 1)));
    if (!isSame) {
      found = search(t);
    }
    return place(found);
  }

  private int search(double t) {
    int low = 0;
    int high = size - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (time(place(middle)) <= t) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  public double x(int k, double t, double[] walls) {
    double free = freeX(k, t);
    double confined = confinedX(k, free, walls);
    return confined == free || properties(t).confined() ? confined : free;
  }

  public double y(int k, double t, double[] walls) {
    double free = freeY(k, t);
    double confined = confinedY(k, free, walls);
    return confined == free || properties(t).confined() ? confined : free;
  }

  /** The properties at a time. */
  CircleProperties properties(double t) {
    CircleProperties changed = properties == null ? null : properties.at(t);
    return changed == null ? firstProperties : changed;
  }

  /** The properties now; null before the first row. */
  CircleProperties properties() {
    return properties == null ? firstProperties : properties.last();
  }

  /** Loads the circle as it was at a time, without a prediction. */
  void load(double t, MovingCircle m) {
    get(find(t), m);
    m.forgetPrediction(0, 0);
    m.restitution = properties(t).restitution();
  }
}
