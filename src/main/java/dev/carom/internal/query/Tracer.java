// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.Dyadic;
import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.response.LoneContact;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.Shock;
import dev.carom.internal.search.FlightSearch;
import dev.carom.internal.search.Grid;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.CircleRegistry;
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
  private final Hit hit = new Hit();

  /** A circle for a cast. */
  public final MovingCircle body = new MovingCircle();

  /** What arrives at a time. */
  private final IntList arriving = new IntList();

  /** The row of a moving obstacle that is hit. */
  private final double[] placed = new double[ObstacleTable.MOST_NUMBERS + 1];

  /** The grid for the circle that is followed, or null to test each obstacle. */
  private Grid grid;

  /** The acceleration of that circle where nothing carries it. */
  private Gravity gravity;

  /** The circles that it can meet; null to pass all of them. */
  private CircleQueries circles;

  public Tracer(ObstacleIndex index) {
    this.index = index;
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
    double vx = body.vx;
    double vy = body.vy;
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
    body.vx = vx;
    body.vy = vy;
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
    arriving.clear();
    for (int i = 0; i < motions.count(); i++) {
      if (motions.until(i) - obstacles.epoch() <= time) {
        arriving.add(motions.code(i));
      }
    }
    for (int k = 0; k < arriving.size(); k++) { // of an outline all sides, before any is asked
      obstacles.restInQuestion(arriving.get(k));
    }
    for (int k = 0; k < arriving.size(); k++) {
      body.forget(arriving.get(k), 0);
      if (search.meets(body, arriving.get(k))) {
        body.restart(time, 0, obstacles);
      }
    }
    body.clearUpTo(0);
  }

  /** Whether a contact is exactly later than a time to which it rounds. */
  private boolean isLater(MovingCircle body, double time) {
    return exactTime(body).compare(Dyadic.of(time)) > 0;
  }

  /** The exact time of the contact that was found. */
  RealRoot exactTime(MovingCircle body) {
    return search.exactTime(body);
  }

  /** The hit at the contact that was found; always the same object. */
  public Hit hit(MovingCircle m) {
    int code = m.next;
    double t = m.cleared;
    Fall flight = Fall.ofThread().flight(m.x, m.y, m.radius, m.vx, m.vy, m.gx, m.gy);
    if (Codes.isWall(code)) {
      return hit.ofWall(flight, code, obstacles.walls[code], t);
    }
    if (obstacles.moves(code)) {
      obstacles.see(obstacles.motions().indexOf(code), m.t, m.tl, placed, flight);
    } else {
      ObstacleRows rows = obstacles.of(code);
      flight.obstacle(rows.shape, rows.values, rows.offset(code), 0, 0);
    }
    return hit.of(flight, m.contact, t);
  }

  /**
   * The path until the given time, until its impact of a given number, which is resolved, or until
   * it meets a circle.
   *
   * @param itsGravity the acceleration of the circle where nothing carries it
   * @param registry that of the circle; null for one of no world
   * @param targets the circles of the world; null to pass them
   * @param number that of the impact, sensors not counted, at least 0; 0 ends it at the start
   * @param most how many impacts and ends of slides a path may have; one with more ends there,
   *     incomplete
   */
  public TracedPath trace(
      MovingCircle body,
      Gravity itsGravity,
      CircleRegistry registry,
      CircleQueries targets,
      double duration,
      int number,
      int most) {
    grid = index.grid(body.radius);
    gravity = itsGravity;
    circles = targets;
    ObstacleResponse response = new ObstacleResponse(obstacles, registry, gravity, this::addNear);
    Shock shock = new Shock(registry, obstacles, this::addNear, null);
    response.ask(shock);
    LoneContact contact = new LoneContact(obstacles, null, gravity, this::addNear);
    DoubleList flights = new DoubleList();
    ImpactRows impacts = new ImpactRows(1).of(index.obstacles);
    body.fall(gravity.x, gravity.y);
    add(body, flights);
    ExactBudget work = ExactBudget.ofThread();
    long before = work.bits();
    int count = 0;
    for (int done = 0; count < number && next(body, duration, contact, flights); done++) {
      if (done > 0 && done + work.impactsSince(before) >= most) {
        return new TracedPath(flights, impacts, body.t, false);
      }
      int rows = impacts.size();
      int result = ObstacleResponse.NEW_FLIGHT;
      if (body.ticksNext()) {
        contact.tick(body, impacts);
      } else if (Codes.isCircle(body.next)) {
        meet(body, impacts);
        return new TracedPath(flights, impacts, body.after(body.cleared), true);
      } else if (body.isMember() && !obstacles.isSensor(body.next)) {
        contact.meet(body, impacts);
      } else {
        result = response.resolve(body, impacts);
        if (result == ObstacleResponse.JOIN) {
          contact.join(body, impacts);
        } else if (result == ObstacleResponse.STUCK) {
          shock.resolve(impacts, body);
          impacts.cut(rows + 1); // a contact counts once, whatever acts with it
        }
      }
      if (result != ObstacleResponse.SENSED) {
        count += impacts.size() - rows;
        add(body, flights);
      }
    }
    return new TracedPath(flights, impacts, count < number ? duration : body.t, true);
  }

  /** Writes the impact with a circle, which ends the path. */
  private void meet(MovingCircle body, ImpactRows log) {
    Hit at = circles.hit(body, obstacles.epoch() + body.t);
    log.addPair(body.after(body.cleared), body.id, Codes.slot(body.next));
    log.set(at.x(), at.y(), at.nx(), at.ny(), -at.approachSpeed());
  }

  /** Looks for the next impact; false if there is none until the given time. */
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
      contact.changed();
      if (body.isMember() && !gravity.acts() && !obstacles.areTurning()) {
        leave(body, arrival, contact);
        body.forget();
        add(body, flights);
      }
      if (body.t < arrival) {
        body.clearUpTo(arrival - body.t); // up to here it has met all sensors
      }
      arrival = obstacles.nextArrival();
    }
    return comes(body, end);
  }

  /** Whether an impact or a tick comes until a time. */
  private boolean comes(MovingCircle body, double end) {
    do {
      search.extend(body, grid, end - body.t);
      if (circles != null) {
        double until = Math.min(end, body.due()) - body.t;
        circles.firstOfLeg(body, this, until, obstacles.epoch() + body.t);
      }
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
        leave(body, time, contact);
        body.forget(code, 0);
        return true;
      }
    }
    return false;
  }

  private void leave(MovingCircle body, double time, LoneContact contact) {
    if (body.isMember()) {
      contact.leave(body, time);
    }
    body.restart(time, 0, obstacles);
    body.fall(gravity.x, gravity.y);
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
