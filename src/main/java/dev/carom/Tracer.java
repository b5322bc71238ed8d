// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;

/** Follows one circle among things that stand still, with all its bounces. */
final class Tracer {

  private final Obstacles obstacles;

  /** The thing that a code stands for. */
  private final IntFunction<Obstacle> things;

  private final BroadSearch search;
  private final ObstacleResponse response;
  private final ImpactLog log = new ImpactLog(1);

  /** Where the circle's obstacles are listed, or null to ask them all. */
  private final Grid grid;

  Tracer(
      Obstacles obstacles,
      IntFunction<Obstacle> things,
      BroadSearch search,
      Grid grid,
      int patience) {
    this.obstacles = obstacles;
    this.things = things;
    this.search = search;
    this.grid = grid;
    response = new ObstacleResponse(obstacles, patience);
  }

  /** The first impact until the given time, as the detector tells it. */
  Optional<Impact> first(Circle circle, Vec2 velocity, double T) {
    Mover mover = Mover.of(circle, velocity, 1);
    while (next(mover, T)) {
      int code = mover.next;
      Optional<Impact> hit = cast(circle, velocity, code, T);
      if (hit.isPresent()) {
        return hit.map(impact -> impact.of(obstacles.kind(code), obstacles.index(code)));
      }
      // Later than T by less than rounding: something else, as near to T, may not be.
      mover.jam = Jam.with(mover.jam, code);
      mover.newFlight();
    }
    return Optional.empty();
  }

  private Optional<Impact> cast(Circle circle, Vec2 velocity, int code, double T) {
    return code < Obstacles.WALLS
        ? Casts.firstAtWall(circle, velocity, obstacles.bounds, code, T)
        : SweptCircle.cast(circle, velocity, things.apply(code), T);
  }

  /**
   * The way until the given time, or until the impact after the last bounce that is asked for.
   *
   * @param most impacts at which the way ends unfinished
   */
  Trajectory trace(Mover mover, double duration, int bounces, int most) {
    List<Flight> flights = new ArrayList<>(List.of(flight(mover)));
    List<Impact> impacts = new ArrayList<>();
    ExactWork work = ExactWork.ofThread();
    long before = work.bits();
    while (next(mover, duration)) {
      if (impacts.size() == bounces) {
        return new Trajectory(flights, impacts, mover.due(), true);
      }
      if (!impacts.isEmpty() && impacts.size() + work.impactsSince(before) >= most) {
        return new Trajectory(flights, impacts, mover.t, false);
      }
      impacts.add(resolve(mover));
      flights.add(flight(mover));
    }
    return new Trajectory(flights, impacts, duration, true);
  }

  /** Looks for the next impact, past sensors; false if there is none until the given time. */
  private boolean next(Mover mover, double end) {
    search.extend(mover, grid, end - mover.t);
    while (mover.due() <= end && mover.cleared < Double.POSITIVE_INFINITY) {
      if (mover.next != Mover.NOTHING && !obstacles.isSensor(mover.next)) {
        return true;
      }
      if (mover.next != Mover.NOTHING) {
        log.clear();
        response.resolve(mover, log);
      }
      search.extend(mover, grid, end - mover.t);
    }
    return false;
  }

  private Impact resolve(Mover mover) {
    int code = mover.next;
    log.clear();
    response.resolve(mover, log);
    return new Impact(
        log.time(0),
        log.kind(0),
        log.id(0),
        things.apply(code),
        log.feature(0),
        new Vec2(log.x(0), log.y(0)),
        new Vec2(log.nx(0), log.ny(0)),
        log.approachSpeed(0));
  }

  private static Flight flight(Mover m) {
    return new Flight(m.t, m.x, m.y, m.vx, m.vy);
  }
}
