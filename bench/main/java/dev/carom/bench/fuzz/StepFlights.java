// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Circle;
import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Outcome;
import dev.carom.Outline;
import dev.carom.Timeline;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;

/** The flights of one step, from its log and its timeline; each must lead to the next one. */
final class StepFlights {

  /** A circle in contact under gravity has a tick of about sqrt(2^-8 R / g); parts are shorter. */
  private static final double PART_OF_TICK = 0x1p-4;

  private static final double TICK = 0x1p-8;

  /** Its flight is no faster than this multiple of its speed, and of the kick of a tick. */
  private static final double SPEED = 1.5;

  private static final double KICKS = 8;

  /** A circle that is squeezed flies aside so many times as fast as what moves. */
  private static final double ASIDE = 6;

  /** In radii: in a tick that is cut short it may still make the room that contacts keep. */
  private static final double ROOM = 1;

  /** A flight is looked at in its middle, in the middle of its first half, and so on. */
  private static final int HALVINGS = 8;

  /** So many parts of one circle are looked at. */
  private static final int MOST_PARTS = 2_000;

  private final World world;
  private final Timeline timeline;
  private final double start;
  private final Rounding rounding;
  private final DeepHits deep;

  /** Whether there is gravity, and whether circles may be in contact. */
  private final boolean falls;

  private final boolean mayTouch;

  private int parts;

  /**
   * Reads a step.
   *
   * @param deep the deep hits before it
   * @param turned whether circles may be in contact without gravity
   */
  StepFlights(
      World world,
      Timeline timeline,
      double start,
      Rounding rounding,
      DeepHits deep,
      boolean turned) {
    this.world = world;
    this.timeline = timeline;
    this.start = start;
    this.rounding = rounding;
    this.deep = deep;
    falls = !world.gravity().equals(Vec2.ZERO);
    mayTouch = falls || turned;
  }

  /** Of all circles, one list each; none for those that are out of the range of doubles. */
  List<List<Flight>> all() throws FindingException {
    List<List<Double>> moments = moments();
    List<List<Flight>> flights = new ArrayList<>();
    for (int i = 0; i < moments.size(); i++) {
      flights.add(world.contains(Kind.CIRCLE, i) ? of(i, moments.get(i)) : List.of());
    }
    return flights;
  }

  /**
   * The start of the step, each circle's impacts, and the end; a sensor does not bend a parabola.
   */
  private List<List<Double>> moments() {
    List<List<Double>> moments = new ArrayList<>();
    for (int i = 0; i < world.idLimit(Kind.CIRCLE); i++) {
      moments.add(new ArrayList<>(List.of(start)));
    }
    ImpactLog log = world.impacts();
    for (int row = 0; row < log.size(); row++) {
      if (!falls || log.outcome(row) != Outcome.SENSED) {
        moments.get(log.circle(row)).add(log.time(row));
        if (log.kind(row) == Kind.CIRCLE) {
          moments.get(log.id(row)).add(log.time(row));
        }
      }
    }
    moments.forEach(of -> of.add(world.now()));
    return moments;
  }

  private List<Flight> of(int i, List<Double> moments) throws FindingException {
    parts = 0;
    List<Flight> flights = new ArrayList<>();
    for (int k = 1; k < moments.size(); k++) {
      double from = moments.get(k - 1);
      double to = moments.get(k);
      if (to > from && !isBurst(moments, k)) {
        add(flights, i, from, to, k > 1 || !falls || !deep.isDeep(i));
      }
    }
    return flights;
  }

  /**
   * Whether three impacts or more have the stored time of moment k. Bumpers then may have driven
   * the circle any way within one ulp of the clock, and the timeline tells its last place only.
   */
  private static boolean isBurst(List<Double> moments, int k) {
    return k + 2 < moments.size() && moments.get(k + 2).equals(moments.get(k));
  }

  /**
   * Adds what a circle does between two moments. With gravity that may be more than one flight: the
   * end of a slide makes no row. So it is halved until its parts are flights, or shorter than a
   * tick of circles in contact.
   */
  private void add(List<Flight> flights, int i, double from, double to, boolean begins)
      throws FindingException {
    Flight flight = flight(i, from, to, begins);
    double middle = from + (to - from) / 2;
    if (++parts > MOST_PARTS) {
      return;
    }
    if (mayTouch && middle > from && middle < to && !(isOne(flight) && isContinuous(flight))) {
      double tick = falls ? Math.sqrt(TICK * flight.radius() / world.gravity().length()) : 0;
      if (falls && to - from <= PART_OF_TICK * tick) {
        checkContact(flight, tick);
        return;
      }
      add(flights, i, from, middle, begins);
      add(flights, i, middle, to, begins && !deep.isDeep(i));
      return;
    }
    if (falls || !mayTouch) {
      checkContinuous(flight);
    } else if (!isContinuous(flight)) {
      return; // a part of a tick: without gravity nothing tells how short it is
    }
    if (flight.isFinite()) {
      flights.add(flight);
    }
  }

  private Flight flight(int i, double from, double to, boolean begins) {
    double last = Math.nextDown(to);
    double dt = last - from;
    boolean bends = falls && dt > 0;
    double vx = timeline.vx(i, from);
    double vy = timeline.vy(i, from);
    return new Flight(
        i,
        ((Circle) timeline.shape(Kind.CIRCLE, i, from)).radius(),
        from,
        to,
        timeline.x(i, from),
        timeline.y(i, from),
        timeline.x(i, to),
        timeline.y(i, to),
        vx,
        vy,
        bends ? (timeline.vx(i, last) - vx) / dt : 0,
        bends ? (timeline.vy(i, last) - vy) / dt : 0,
        Math.max(speed(i, from), Math.max(speed(i, last), speed(i, to))),
        begins);
  }

  private double speed(int i, double t) {
    return Math.hypot(timeline.vx(i, t), timeline.vy(i, t));
  }

  /**
   * Whether a flight is where one acceleration throughout leads it: in its middle, and towards its
   * start, where a circle may be in contact for a tick before it slides.
   */
  private boolean isOne(Flight f) {
    double dt = f.to() - f.from();
    for (int k = 1; k <= HALVINGS; k++) {
      if (!isOne(f, f.from() + Math.scalb(dt, -k))) {
        return false;
      }
    }
    return true;
  }

  private boolean isOne(Flight f, double middle) {
    Flight rest = f.within(middle, f.to());
    double slack = rounding.of(f);
    double speedSlack = rounding.ofVelocity(f, world.gravity().length());
    return Math.abs(rest.px() - timeline.x(f.circle(), middle)) <= slack
        && Math.abs(rest.py() - timeline.y(f.circle(), middle)) <= slack
        && Math.abs(rest.vx() - timeline.vx(f.circle(), middle)) <= speedSlack
        && Math.abs(rest.vy() - timeline.vy(f.circle(), middle)) <= speedSlack;
  }

  /** The velocity of a circle in contact is its momentum: only its place may not jump. */
  private void checkContact(Flight f, double tick) throws FindingException {
    double dt = f.to() - f.from();
    double speed = SPEED * f.fastest() + KICKS * world.gravity().length() * tick;
    double most = speed * dt + ROOM * f.radius() + rounding.of(f);
    double way = Math.hypot(f.qx() - f.px(), f.qy() - f.py());
    if (!(way <= most) && !(way <= most + ASIDE * fastestMover(f.from(), f.to()) * dt)) {
      throw new FindingException("the flight is not continuous, not even in contact: " + f);
    }
  }

  /** The speed of the fastest line, peg or infinite mass between two times. */
  private double fastestMover(double from, double to) {
    double fastest = 0;
    for (int id : world.ids(Kind.CIRCLE)) {
      if (world.traits(Kind.CIRCLE, id).mass() == Double.POSITIVE_INFINITY) {
        fastest = Math.max(fastest, speed(id, from));
      }
    }
    for (Kind kind : List.of(Kind.LINE, Kind.PEG)) {
      for (int id = 0; id < world.idLimit(kind); id++) {
        if (timeline.contains(kind, id, from) && timeline.contains(kind, id, to)) {
          Vec2[] first = ends(timeline.shape(kind, id, from));
          Vec2[] last = ends(timeline.shape(kind, id, to));
          for (int k = 0; k < first.length; k++) {
            double way = Math.hypot(last[k].x() - first[k].x(), last[k].y() - first[k].y());
            fastest = Math.max(fastest, way / (to - from));
          }
        }
      }
    }
    return fastest;
  }

  private static Vec2[] ends(Obstacle shape) {
    if (shape instanceof Outline outline) {
      return outline.points().toArray(new Vec2[0]);
    }
    return shape instanceof Line line
        ? new Vec2[] {new Vec2(line.ax(), line.ay()), new Vec2(line.bx(), line.by())}
        : new Vec2[] {((Circle) shape).center()};
  }

  private void checkContinuous(Flight f) throws FindingException {
    if (!isContinuous(f)) {
      throw new FindingException(
          "the flight is not continuous: " + f + ", bound " + rounding.of(f));
    }
  }

  private boolean isContinuous(Flight f) {
    double slack = rounding.of(f);
    double dt = f.to() - f.from();
    double jumpX = Math.abs(Flight.place(f.px(), f.vx(), f.ax(), dt) - f.qx());
    double jumpY = Math.abs(Flight.place(f.py(), f.vy(), f.ay(), dt) - f.qy());
    boolean whole = !Double.isNaN(f.px() + f.py() + f.vx() + f.vy());
    return whole && (!f.isFinite() || (jumpX <= slack && jumpY <= slack));
  }
}
