// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.exact.ExactTime;
import dev.carom.internal.response.LoneContact;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.Shock;
import dev.carom.internal.search.FlightSearch;
import dev.carom.internal.search.Grid;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleMotions;
import dev.carom.internal.state.ObstacleRows;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.IntList;

/** Follows one circle among obstacles at rest and in motion, with all its bounces. */
public final class Tracer {

  private final ObstacleTable obstacles;
  private final ObstacleIndex index;
  private final FlightSearch search;
  private final Gravity gravity;
  private final Hit hit = new Hit();

  /** The row of a moving obstacle that is hit. */
  private final double[] placed = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** The grid for the circle that is followed, or null to test each obstacle. */
  private Grid grid;

  public Tracer(ObstacleIndex index) {
    this(index, new Gravity(0, 0));
  }

  /** Makes a tracer of paths under gravity; the casts go straight on. */
  public Tracer(ObstacleIndex index, Gravity gravity) {
    this.index = index;
    this.gravity = gravity;
    obstacles = index.obstacles;
    search = index.search();
  }

  /**
   * Finds the first contact until a given time: exactly the earliest one, sensors ignored. Among
   * obstacles that arrive on the way, a circle that meets one where it rests goes on from its
   * rounded place at that time.
   *
   * @param body the circle at the start, at time 0; it receives the contact: {@code next}, {@code
   *     contact} and its time {@code cleared}; {@code next} is NOTHING if there is none
   */
  public void first(MovingCircle body, double maxTime) {
    double x = body.x;
    double y = body.y;
    double arrival = obstacles.nextArrival();
    while (arrival < maxTime && !findFirst(body, arrival)) {
      arrive(body, arrival);
      arrival = obstacles.nextArrival();
    }
    if (body.next == MovingCircle.NOTHING) {
      findFirst(body, maxTime);
    }
    body.x = x;
    body.y = y;
    body.cleared += body.t;
    body.t = 0;
  }

  private boolean findFirst(MovingCircle body, double maxTime) {
    double end = maxTime - body.t;
    search.cast(body, index.grid(body.radius), end);
    boolean hits = body.next != MovingCircle.NOTHING;
    double t = body.cleared;
    if (hits && (t > end || (t == end && isLater(body, end)))) {
      body.next = MovingCircle.NOTHING;
    }
    return body.next != MovingCircle.NOTHING;
  }

  /** Lets the obstacles rest that arrive at a time, as the engine does. */
  private void arrive(MovingCircle body, double time) {
    ObstacleMotions motions = obstacles.motions();
    for (int i = 0; i < motions.count(); i++) {
      if (motions.until(i) - obstacles.epoch() <= time) {
        obstacles.restInQuestion(motions.code(i));
        body.forget(motions.code(i), 0);
        if (search.meets(body, motions.code(i))) {
          body.restart(time, 0, obstacles.wallsFor(body.filter));
        }
      }
    }
    body.clearUpTo(0);
  }

  /** Whether a contact is exactly later than a time to which it rounds. */
  private boolean isLater(MovingCircle body, double time) {
    return exactTime(body).compare(ExactTime.of(time)) > 0;
  }

  /** The exact time of the contact that was found. */
  ExactTime exactTime(MovingCircle body) {
    return search.exactTime(body);
  }

  /** The hit at the contact that was found; always the same object. */
  public Hit hit(MovingCircle m) {
    int code = m.next;
    double t = m.cleared;
    Fall flight = Fall.ofThread().flight(m.x, m.y, m.radius, m.vx, m.vy, 0, 0);
    if (Codes.isWall(code)) {
      return hit.ofWall(flight, code, obstacles.walls[code], t);
    }
    ObstacleRows rows = obstacles.of(code);
    double[] values = rows.values;
    int k = rows.offset(code);
    if (obstacles.moves(code)) {
      obstacles.place(obstacles.motions().indexOf(code), m.t, m.tl, placed);
      values = placed;
      k = 0;
    }
    double ux = obstacles.ux(code);
    double uy = obstacles.uy(code);
    return hit.of(flight.obstacle(rows.shape, values, k, ux, uy), m.contact, t);
  }

  /**
   * The path until the given time, or until its impact of a given number, which is resolved.
   *
   * @param number that of the impact, at least 0; 0 ends it at the start
   * @param most how many impacts and ends of slides a path may have; one with more ends there,
   *     incomplete
   */
  public TracedPath trace(MovingCircle body, double duration, int number, int most) {
    grid = index.grid(body.radius);
    ObstacleResponse response = new ObstacleResponse(obstacles, null, gravity, this::addNear);
    Shock shock = new Shock(null, obstacles, this::addNear, null);
    response.ask(shock);
    LoneContact contact = new LoneContact(obstacles, null, gravity, this::addNear);
    DoubleList flights = new DoubleList();
    ImpactRows impacts = new ImpactRows(1);
    body.fall(gravity.x, gravity.y);
    add(body, flights);
    ExactBudget work = ExactBudget.ofThread();
    long before = work.bits();
    while (impacts.size() < number && next(body, duration, contact, flights)) {
      int count = impacts.size();
      int done = flights.size() / TracedPath.FLIGHT - 1; // impacts and ends of slides
      if (done > 0 && done + work.impactsSince(before) >= most) {
        return new TracedPath(flights, impacts, body.t, false);
      }
      if (body.ticksNext()) {
        contact.tick(body, impacts);
      } else if (body.isMember()) {
        contact.meet(body, impacts);
      } else {
        int result = response.resolve(body, impacts);
        if (result == ObstacleResponse.JOIN) {
          contact.join(body, impacts);
        } else if (result == ObstacleResponse.STUCK) {
          shock.resolve(impacts, body);
          impacts.cut(count + 1); // a contact counts once, whatever acts with it
        }
      }
      add(body, flights);
    }
    double end = impacts.size() < number ? duration : body.t;
    return new TracedPath(flights, impacts, end, true);
  }

  /** Looks for the next impact, past sensors; false if there is none until the given time. */
  private boolean next(MovingCircle body, double end, LoneContact contact, DoubleList flights) {
    double arrival = obstacles.nextArrival();
    while (arrival < end) {
      if (comes(body, arrival)) {
        return true;
      }
      if (isLeftBy(body, arrival, contact)) {
        add(body, flights);
      }
      arrive(body, arrival);
      arrival = obstacles.nextArrival();
    }
    return comes(body, end);
  }

  /** Whether an impact or a tick comes until a time. */
  private boolean comes(MovingCircle body, double end) {
    do {
      search.extendPastSensors(body, grid, end - body.t);
      if (body.due() <= end && (body.next != MovingCircle.NOTHING || body.ticksNext())) {
        return true;
      }
    } while (body.due() <= end && body.cleared < Double.POSITIVE_INFINITY);
    return false;
  }

  /** Lets a circle fall if it is in contact with what arrives; returns whether it was. */
  private boolean isLeftBy(MovingCircle body, double time, LoneContact contact) {
    contact.changed();
    ObstacleMotions motions = obstacles.motions();
    for (int i = 0; i < motions.count(); i++) {
      int code = motions.code(i);
      if (motions.until(i) - obstacles.epoch() <= time && isHeld(body, code, time, contact)) {
        if (body.isMember()) {
          contact.leave(body, time);
        }
        body.restart(time, 0, obstacles.wallsFor(body.filter));
        body.forget(code, 0);
        body.fall(gravity.x, gravity.y);
        return true;
      }
    }
    return false;
  }

  private static boolean isHeld(MovingCircle body, int code, double time, LoneContact contact) {
    return body.isMember()
        ? contact.isNear(body, code, time)
        : body.support == code || body.landing == code;
  }

  private void addNear(MovingCircle m, double reach, double now, IntList into) {
    search.addNear(m, grid, reach, now, into);
  }

  private static void add(MovingCircle m, DoubleList flights) {
    flights.add(m.t, m.x, m.y, m.vx, m.vy, m.gx, m.gy);
  }
}
