// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.List;

/**
 * The way of one circle among obstacles: its flights, and the impacts between them.
 *
 * @param flights at least one; flight i + 1 starts where and when impact i ends flight i
 * @param impacts one fewer than the flights; their times count from the start of the trajectory
 * @param duration the time covered, counted from the start
 * @param outcome {@link Outcome#UNFINISHED} if the budget of impacts was spent before the time
 *     asked for; the duration is then that of the last impact
 */
public record Trajectory(
    List<Flight> flights, List<Impact> impacts, double duration, Outcome outcome) {

  /**
   * Copies the lists.
   *
   * @param flights the flights
   * @param impacts the impacts between them
   * @param duration the time covered
   * @param outcome how it ended
   */
  public Trajectory {
    flights = List.copyOf(flights);
    impacts = List.copyOf(impacts);
  }

  /**
   * Where the centre is at a given time.
   *
   * @param t a time, 0..{@link #duration()}
   * @return the centre
   * @throws IllegalArgumentException if the time is NaN or outside of the trajectory
   */
  public Vec2 at(double t) {
    return flightAt(t).at(t);
  }

  /**
   * The velocity at a given time; at an impact, the one after it.
   *
   * @param t a time, 0..{@link #duration()}
   * @return the velocity
   * @throws IllegalArgumentException if the time is NaN or outside of the trajectory
   */
  public Vec2 velocityAt(double t) {
    Flight flight = flightAt(t);
    return new Vec2(flight.vx(), flight.vy());
  }

  /**
   * Where the trajectory ends.
   *
   * @return the centre at the time {@link #duration()}
   */
  public Vec2 end() {
    return at(duration);
  }

  /** The last flight that starts at or before t. */
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
}
