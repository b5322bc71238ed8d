// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.query.TracedPath;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.DoubleList;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.IntUnaryOperator;
import java.util.stream.Stream;

/**
 * A {@code Trajectory} is the path of one circle among obstacles: straight lines from impact to
 * impact, or arcs of parabolas under gravity. Times count from its start. A coordinate beyond the
 * range of doubles is given as the largest one. Immutable.
 */
public final class Trajectory {

  private final List<Flight> flights;
  private final List<Impact> impacts;
  private final double duration;
  private final boolean complete;

  /** Each flight but the first starts where an impact, or a slide along a line, has ended. */
  Trajectory(List<Flight> flights, List<Impact> impacts, double duration, boolean complete) {
    this.flights = List.copyOf(flights);
    this.impacts = List.copyOf(impacts);
    this.duration = duration;
    this.complete = complete;
  }

  /** Returns the path that a tracer found, with the ids of slots. */
  static Trajectory of(TracedPath path, IntUnaryOperator ids) {
    List<Flight> flights = new ArrayList<>();
    DoubleList f = path.flights();
    for (int k = 0; k < f.size(); k += TracedPath.FLIGHT) {
      flights.add(
          new Flight(
              f.get(k),
              f.get(k + 1),
              f.get(k + 2),
              f.get(k + 3),
              f.get(k + 4),
              f.get(k + 5),
              f.get(k + 6)));
    }
    List<Impact> impacts = new ArrayList<>();
    new ImpactLog(path.impacts(), ids).forEach(impacts::add);
    return new Trajectory(flights, impacts, path.duration(), path.complete());
  }

  /**
   * Returns the impacts on the path, in the order of time, with the sensors that it passes. One at
   * which the path ends is the last one.
   *
   * @return an immutable list
   */
  public List<Impact> impacts() {
    return impacts;
  }

  /**
   * Returns the time that the path covers.
   *
   * @return at least 0
   */
  public double duration() {
    return duration;
  }

  /**
   * Tells whether the path ends where it was asked to: at the duration, at the number of impacts,
   * or at a circle.
   *
   * @return false if the budget of impacts was spent before; the duration is then the time of the
   *     last impact
   */
  public boolean complete() {
    return complete;
  }

  /**
   * Returns the corners of the path: the centre at the start, at each impact that turned it, and at
   * the end. Straight lines join them; with gravity, arcs of parabolas: ask for {@linkplain #at
   * places} between them. There is a point, too, where the circle slides off the end of a line.
   *
   * @return at least two points
   */
  public List<Vec2> points() {
    return Stream.concat(flights.stream().map(f -> f.at(f.t0())), Stream.of(end())).toList();
  }

  /**
   * Returns the centre at a given time.
   *
   * @param t a time, 0..{@link #duration()}
   * @return the centre
   * @throws IllegalArgumentException if the time is NaN or outside of the trajectory
   */
  public Vec2 at(double t) {
    return flightAt(t).at(t);
  }

  /**
   * Returns the velocity at a given time; at an impact, the one after it.
   *
   * @param t a time, 0..{@link #duration()}
   * @return the velocity
   * @throws IllegalArgumentException if the time is NaN or outside of the trajectory
   */
  public Vec2 velocityAt(double t) {
    return flightAt(t).velocity(t);
  }

  /**
   * Returns the centre at the end of the path.
   *
   * @return the centre at the time {@link #duration()}
   */
  public Vec2 end() {
    return at(duration);
  }

  /** Returns the last flight that starts at or before t. */
  private Flight flightAt(double t) {
    if (!(t >= 0 && t <= duration)) {
      throw Check.refused("t", t, "a time from 0 to the trajectory's duration, " + duration);
    }
    int low = 0;
    int high = flights.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (flights.get(middle).t0() <= t) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return flights.get(low);
  }

  /**
   * Tells whether another trajectory takes the same path, with the same impacts, to the bit.
   *
   * @param other any object
   * @return whether it is an equal trajectory
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof Trajectory that
        && flights.equals(that.flights)
        && impacts.equals(that.impacts)
        && Double.compare(duration, that.duration) == 0
        && complete == that.complete;
  }

  @Override
  public int hashCode() {
    return Objects.hash(flights, impacts, duration, complete);
  }

  @Override
  public String toString() {
    return "Trajectory[duration=%s, impacts=%s, complete=%s]"
        .formatted(duration, impacts.size(), complete);
  }
}
