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
  private final ImpactRows rows = new ImpactRows(1);
  private final ImpactLog log = new ImpactLog(rows);

  /** Where the circle's obstacles are listed, or null to ask them all. */
  private final Grid grid;

  Tracer(Obstacles obstacles, IntFunction<Obstacle> things, BroadSearch search, Grid grid) {
    this.obstacles = obstacles;
    this.things = things;
    this.search = search;
    this.grid = grid;
    response = new ObstacleResponse(obstacles);
  }

  /**
   * The first contact until a given time, or later by less than rounding: exactly the earliest one,
   * sensors passed over.
   */
  Optional<Candidate> first(Circle circle, Vec2 velocity, double T) {
    Mover mover = Mover.of(circle, velocity, 1);
    if (!search.cast(mover, grid, T)) {
      return Optional.empty();
    }
    return Optional.of(
        new Candidate(
                mover.cleared, () -> search.exactTime(mover), () -> impact(circle, velocity, mover))
            .of(obstacles.kind(mover.next), obstacles.index(mover.next)));
  }

  /** The impact that a search found. */
  private Impact impact(Circle circle, Vec2 v, Mover mover) {
    int code = mover.next;
    int contact = mover.contact;
    double t = mover.cleared;
    Obstacle thing = things.apply(code);
    ObstacleKind kind = obstacles.kind(code);
    return switch (kind) {
      case WALL -> Casts.wall(circle, v, Records.bounds(obstacles.walls), code, t);
      case LINE -> Casts.line(circle, v, (Line) thing, contact, t);
      default -> Casts.disk(circle, v, Casts.peg(thing), Vec2.ZERO, kind, thing, contact, t);
    };
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
        rows.clear();
        response.resolve(mover, rows);
      }
      search.extend(mover, grid, end - mover.t);
    }
    return false;
  }

  private Impact resolve(Mover mover) {
    int code = mover.next;
    rows.clear();
    response.resolve(mover, rows);
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
