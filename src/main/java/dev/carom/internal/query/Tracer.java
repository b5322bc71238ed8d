// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.search.BroadPhase;
import dev.carom.internal.search.Grid;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.util.DoubleList;

/** Follows one circle among static obstacles, with all its bounces. */
public final class Tracer {

  private final ObstacleTable obstacles;
  private final BroadPhase search;
  private final ObstacleResponse response;

  /** The grid of the obstacles, or null to test each of them. */
  private final Grid grid;

  public Tracer(ObstacleTable obstacles, BroadPhase search, Grid grid) {
    this.obstacles = obstacles;
    this.search = search;
    this.grid = grid;
    response = new ObstacleResponse(obstacles);
  }

  /**
   * The first contact until a given time: exactly the earliest one, sensors ignored; null if there
   * is none.
   *
   * @param mover the circle at the start; the caller must not change it while the answer is in use
   */
  public Candidate first(MovingCircle mover, double maxTime) {
    search.cast(mover, grid, maxTime);
    if (mover.next == MovingCircle.NOTHING) {
      return null;
    }
    Candidate first =
        new Candidate(
            mover.next,
            mover.contact,
            mover.cleared,
            () -> search.exactTime(mover),
            () -> hit(mover, mover.next, mover.cleared));
    return first.isWithin(maxTime) ? first : null;
  }

  /** Where a search found an impact. */
  private Hit hit(MovingCircle m, int code, double t) {
    if (Codes.isWall(code)) {
      return Hit.ofWall(m.x, m.y, m.vx, m.vy, code, obstacles.walls[code], t);
    }
    double[] row = obstacles.rowAt(code, m.t, m.tl);
    ObstacleShape shape = obstacles.of(code).shape;
    return shape.hit(
        m.contact,
        t,
        m.x,
        m.y,
        m.radius,
        m.vx,
        m.vy,
        row,
        0,
        obstacles.ux(code),
        obstacles.uy(code));
  }

  /**
   * The path until the given time, or until the impact after the last bounce that is asked for.
   *
   * @param most how many impacts a path may have; one with more ends there, incomplete
   */
  public TracedPath trace(MovingCircle mover, double duration, int bounces, int most) {
    DoubleList flights = new DoubleList();
    ImpactRows impacts = new ImpactRows(1);
    add(mover, flights);
    ExactBudget work = ExactBudget.ofThread();
    long before = work.bits();
    while (next(mover, duration)) {
      int count = impacts.size();
      if (count == bounces) {
        return new TracedPath(flights, impacts, mover.due(), true);
      }
      if (count > 0 && count + work.impactsSince(before) >= most) {
        return new TracedPath(flights, impacts, mover.t, false);
      }
      response.resolve(mover, impacts);
      add(mover, flights);
    }
    return new TracedPath(flights, impacts, duration, true);
  }

  /** Looks for the next impact, past sensors; false if there is none until the given time. */
  private boolean next(MovingCircle mover, double end) {
    do {
      search.extendPastSensors(mover, grid, end - mover.t);
      if (mover.due() <= end && mover.next != MovingCircle.NOTHING) {
        return true;
      }
    } while (mover.due() <= end && mover.cleared < Double.POSITIVE_INFINITY);
    return false;
  }

  private static void add(MovingCircle m, DoubleList flights) {
    flights.add(m.t, m.x, m.y, m.vx, m.vy);
  }
}
