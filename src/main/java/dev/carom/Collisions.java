// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;
import java.util.List;

/**
 * Circles that collide: event after event, in the order of time.
 *
 * <p>Each circle has one event in a calendar, the first of three: it meets something that stands
 * still (or the end of what is known of that), it meets another circle, or it leaves a cell. When a
 * circle's velocity changes, its count goes up, and what was foreseen for it is foreseen anew; that
 * another circle foresaw a meeting with it is noticed there by the count.
 *
 * <p>When two circles meet depends on their two flights alone: the search starts where the later
 * one starts, from the place of the other one then. So neither the cells through which they found
 * each other nor the steps of the caller change a bit of it.
 *
 * <p>Simultaneous events are taken by kind (wall, line, peg, pair), then by the numbers of what
 * meets.
 */
final class Collisions extends Engine {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Events in one call, and so many more for each circle. */
  static final int EVENTS_PER_CALL = 200_000;

  private static final int EVENTS_PER_CIRCLE = 1_000;

  // Kinds of events; those from CROSSING on tell over which edge.
  private static final int STATIC = 0;
  static final int PAIR = 1;
  private static final int EDIT = 2;
  static final int CROSSING = 3;

  private final Machinery machinery;
  private final Bounds bounds;
  private final PairResponse pairs;
  private final Piece piece;
  private Neighbors neighbors;
  private Meetings meetings;
  private EventQueue queue;
  private short[] kinds;

  /** The time of the last event, or of the end of the last step. */
  private double reached;

  /** The end of the step in hand. */
  private double end;

  /** What searches among neighbours found: for one circle, and for another. */
  private int[] found;

  private int[] foundOfOther;

  /** Whether an edit needs more room or other cells than there are. */
  private boolean outgrown;

  private final SensedPairs sensed = new SensedPairs();
  private final Mover other = new Mover();

  Collisions(Scene scene, Roster roster, Machinery machinery, ImpactLog log) {
    super(scene, roster, Circles.colliding(scene.circleCount()), machinery, log);
    this.machinery = machinery;
    bounds = scene.bounds;
    pairs = new PairResponse(roster, response);
    piece = new Piece(roster, pairs);
    int count = circles.count;
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      circles.keep(i, circles.mover);
    }
    begin();
  }

  /** Foresees everything anew, from the flights. */
  private void begin() {
    int room = circles.capacity();
    kinds = new short[room];
    found = new int[room + 9];
    foundOfOther = new int[room + 9];
    neighbors = new Neighbors(circles, roster, bounds, machinery.pairCells(), reached);
    boolean many = room >= Ahead.LEAST_CIRCLES;
    queue = new EventQueue(room, this::before, many ? new Ahead(circles, neighbors, kinds) : null);
    meetings = new Meetings(circles, neighbors.followers(), pairs, sensed);
    for (int i = 0; i < circles.count; i++) {
      if (roster.contains(i)) {
        lookAround(i);
        foresee(i);
      }
    }
  }

  @Override
  String model() {
    return surroundings.model(true).toString();
  }

  @Override
  double advance(double end) {
    unfinished = false;
    this.end = end;
    prepare();
    if (outgrown) {
      outgrown = false;
      begin();
    }
    long budget = EVENTS_PER_CALL + (long) EVENTS_PER_CIRCLE * roster.count();
    ExactWork work = ExactWork.ofThread();
    long before = work.impacts();
    for (long events = 0; ; events++) {
      int i = queue.first();
      if (i == EventQueue.NONE || queue.time(i) > end) {
        reached = end;
        return end;
      }
      if (events > 0 && events + (work.impacts() - before) >= budget) {
        unfinished = true;
        return reached;
      }
      // A crossing may be noticed late by rounding: time does not go back for it.
      reached = Math.max(reached, queue.time(i));
      queue.take(i);
      happen(i);
    }
  }

  private void happen(int i) {
    switch (kinds[i]) {
      case STATIC -> meetObstacle(i);
      case PAIR -> meet(i);
      case EDIT -> {
        lookAround(i);
        foresee(i);
      }
      default -> cross(i);
    }
  }

  private void cross(int i) {
    int size = neighbors.cross(i, kinds[i] - CROSSING, found);
    double crossing = neighbors.crossing(i);
    int way = neighbors.way();
    lookAround(i);
    if (meetings.look(i, found, size)) {
      schedule(i, crossing, way);
    } else {
      foresee(i);
    }
  }

  private void meetObstacle(int i) {
    circles.load(i);
    Mover m = circles.mover;
    if (m.next == Mover.NOTHING) {
      surroundings.extend(m, m.cleared);
      circles.keep(i, m);
      schedule(i);
      return;
    }
    if (response.resolve(m, log)) {
      if (response.seizes()) {
        circles.keep(i, m);
        seize(i);
        return;
      }
      changed(i, m);
      revive(i);
      foresee(i);
    } else {
      surroundings.extend(m, m.cleared);
      circles.keep(i, m);
      schedule(i);
    }
  }

  private void meet(int i) {
    if (!meetings.holds(i)) {
      foresee(i);
      return;
    }
    if (meetings.isOpen(i)) {
      meetings.refine(i);
      if (!isStillFirst(i)) {
        schedule(i);
        return;
      }
      reached = Math.max(reached, meetings.time(i));
    }
    int j = meetings.partner(i);
    queue.clear(j);
    int low = Math.min(i, j);
    int high = Math.max(i, j);
    double tau = meetings.tau(i);
    circles.load(low, circles.mover);
    circles.load(high, other);
    Mover early = together(circles.mover, other);
    circles.mover.fly(tau);
    other.fly(tau);
    early.standsStill &= early.flown == tau;
    if (pairs.resolve(circles.mover, other, log)) {
      if (response.seizes()) {
        circles.keep(low, circles.mover);
        circles.keep(high, other);
        seize(low, high);
        return;
      }
      changed(low, circles.mover);
      changed(high, other);
      revive(low);
      revive(high);
    } else {
      report(low, high, i);
    }
    foresee(low, high);
  }

  /** Whether the meeting of circle i, now that its time is known, comes before all other events. */
  private boolean isStillFirst(int i) {
    double time = meetings.time(i);
    return time <= end
        && queue.isBeforeAll(time)
        && time < neighbors.crossing(i)
        && time < due(i);
  }

  /** Notes that a sensor reported what circle i met: one of two. */
  private void report(int low, int high, int i) {
    double head = meetings.time(i);
    double tail = meetings.tail(i);
    sensed.report(low, head, tail, high);
    sensed.report(high, head, tail, low);
  }

  /** Brings the one whose flight started earlier to the start of the other's, and returns it. */
  private static Mover together(Mover a, Mover b) {
    double later = (b.t - a.t) + (b.tl - a.tl);
    Mover early = later > 0 ? a : b;
    Mover late = later > 0 ? b : a;
    early.x = Math.fma(early.vx, Math.abs(later), early.x);
    early.y = Math.fma(early.vy, Math.abs(later), early.y);
    early.flown = Math.abs(later);
    early.t = late.t;
    early.tl = late.tl;
    return early;
  }

  /** Puts a circle on its new flight. */
  private void changed(int i, Mover m) {
    circles.keep(i, m);
    neighbors.comeBack(i);
    count(i);
    if (timeline != null) {
      timeline.add(m);
    }
    lookAround(i);
  }

  /** Lets the circles that are jammed to those that have just jammed go on with them as one. */
  private void seize(int... hit) {
    Mover[] first = Arrays.stream(hit).mapToObj(this::copy).toArray(Mover[]::new);
    List<Mover> members = piece.seize(this::copy, log, first);
    for (Mover m : members) {
      queue.clear(m.id);
      changed(m.id, m);
    }
    members.forEach(m -> revive(m.id));
    members.forEach(m -> foresee(m.id));
  }

  private Mover copy(int i) {
    Mover m = new Mover();
    circles.load(i, m);
    return m;
  }

  /** Circles that were inert for a jammed one are there again if it now runs into them. */
  private void revive(int i) {
    Jam jam = circles.jam(i);
    if (jam == null) {
      return;
    }
    circles.load(i);
    for (int code : jam.codes()) {
      if (code >= Obstacles.CIRCLES) {
        circles.load(code - Obstacles.CIRCLES, other);
        if (pairs.part(circles.mover, other)) {
          jam = jam.without(code);
        }
      }
    }
    circles.jams[i] = jam;
  }

  /** Notes that a circle changed: what others foresaw with it does not hold, nor what it met. */
  private void count(int i) {
    circles.codes[Circles.collidingCodesAt(i) + Circles.COUNT]++;
    sensed.forget(i);
  }

  /**
   * Looks for the next obstacle ahead of a circle, unless that is done or none can be in its cell.
   */
  private void lookAround(int i) {
    boolean nothingNear = surroundings.obstacles.size() == 0 && neighbors.isInside(i);
    if (!nothingNear && !isLookedAhead(i)) {
      circles.load(i);
      surroundings.extend(circles.mover, 0);
      circles.keep(i, circles.mover);
    }
  }

  private boolean isLookedAhead(int i) {
    return cleared(i) > 0 || next(i) >= 0;
  }

  private double cleared(int i) {
    return circles.state[Circles.collidingAt(i) + Circles.CLEARED];
  }

  /** What is ahead of a circle; negative for nothing. */
  private int next(int i) {
    return circles.codes[Circles.collidingCodesAt(i) + Circles.NEXT];
  }

  /** Looks anew for the first circle that circle i meets. */
  private void foresee(int i) {
    meetings.clear(i);
    int size = neighbors.find(i, found);
    double crossing = neighbors.crossing(i);
    int way = neighbors.way();
    meetings.look(i, found, size);
    schedule(i, crossing, way);
  }

  /**
   * The same for two circles: first what can be computed without a branch, for both, then what
   * branches on it, which cannot be foretold. So the waits of one overlap with those of the other.
   */
  private void foresee(int i, int j) {
    meetings.clear(i);
    meetings.clear(j);
    int size = neighbors.find(i, found);
    int sizeOfJ = neighbors.find(j, foundOfOther);
    double crossingOfI = neighbors.crossing(i);
    int wayOfI = neighbors.way();
    double crossingOfJ = neighbors.crossing(j);
    int wayOfJ = neighbors.way();
    int leftOfI = meetings.sift(i, found, size);
    int leftOfJ = meetings.sift(j, foundOfOther, sizeOfJ);
    meetings.decide(i, found, leftOfI);
    schedule(i, crossingOfI, wayOfI);
    meetings.decide(j, foundOfOther, leftOfJ);
    schedule(j, crossingOfJ, wayOfJ);
  }

  /** When the obstacle ahead is met, or what is known of obstacles ends. */
  private double due(int i) {
    int a = Circles.collidingAt(i);
    double cleared = circles.state[a + Circles.CLEARED];
    return isLookedAhead(i) && cleared < NEVER
        ? Mover.sum(circles.state[a + Circles.T], circles.state[a + Circles.TL], cleared)
        : NEVER;
  }

  /** The tail of the time of the obstacle ahead. */
  private double dueTail(int i) {
    int a = Circles.collidingAt(i);
    double t = circles.state[a + Circles.T];
    double tl = circles.state[a + Circles.TL];
    double cleared = circles.state[a + Circles.CLEARED];
    return next(i) < 0
        ? Double.NEGATIVE_INFINITY
        : Mover.sumTail(t, tl, cleared, Mover.sum(t, tl, cleared));
  }

  /** Puts the first of a circle's events into the calendar. */
  private void schedule(int i) {
    double crossing = neighbors.crossing(i);
    schedule(i, crossing, neighbors.way());
  }

  /** The same with the crossing that is next, {@code way} over which edge. */
  private void schedule(int i, double crossing, int way) {
    double due = due(i);
    double meeting = meetings.time(i);
    double time = Math.min(crossing, meeting);
    // Without a branch, as it cannot be foretold: if none ever is, there is no event of any kind.
    int pair = (int) (Double.doubleToRawLongBits(meeting - crossing) >> 63);
    int cross = CROSSING + way;
    int kind = cross ^ ((cross ^ PAIR) & pair);
    // Within one stored time a fast circle could go on through the cells behind what it hits.
    if (meeting == crossing && meeting < NEVER && isBeforeCrossing(i)) {
      kind = PAIR;
    }
    boolean first = due < crossing || (due == crossing && cleared(i) < untilCrossing(i));
    if (due <= time && first && !(meeting <= due && isBeforeObstacle(i))) {
      kind = STATIC;
      time = due;
    }
    kinds[i] = (short) kind;
    queue.set(i, time);
  }

  /** How long after the start of its flight a circle's crossing is. */
  private double untilCrossing(int i) {
    neighbors.crossing(i);
    return neighbors.until();
  }

  /** Of a meeting and a crossing at one time: if the meeting is first, or is to be refined. */
  private boolean isBeforeCrossing(int i) {
    int a = Circles.collidingAt(i);
    int c = Circles.collidingAt(meetings.partner(i));
    double[] s = circles.state;
    double later = (s[c + Circles.T] - s[a + Circles.T]) + (s[c + Circles.TL] - s[a + Circles.TL]);
    return meetings.isOpen(i) || Math.max(0, later) + meetings.tau(i) < untilCrossing(i);
  }

  /** Of a meeting and an obstacle at one time: if the meeting is first, or is to be refined. */
  private boolean isBeforeObstacle(int i) {
    double tail = meetings.tail(i);
    double other = dueTail(i);
    return tail < other || (tail == other && pairs.isSensor(i, meetings.partner(i)));
  }

  /** The order of two events of the same time. */
  private boolean before(int i, int j) {
    double a = tail(i);
    double b = tail(j);
    return a != b ? a < b : rank(i) < rank(j);
  }

  private double tail(int i) {
    return switch (kinds[i]) {
      case STATIC -> dueTail(i);
      case PAIR -> meetings.tail(i);
      default -> Double.NEGATIVE_INFINITY;
    };
  }

  private long rank(int i) {
    return switch (kinds[i]) {
      case STATIC -> next(i) < 0 ? i : (long) next(i) << 31 | i;
      case PAIR -> {
        int j = meetings.partner(i);
        yield pairs.rank(Math.min(i, j), Math.max(i, j));
      }
      default -> i;
    };
  }

  // Edits.

  @Override
  void fly(Mover m) {
    int i = m.id;
    if (i == circles.count) {
      outgrown |= i == circles.capacity();
      circles.add();
    } else if (!outgrown) {
      queue.clear(i);
      neighbors.leave(i);
    }
    surroundings.setRadius(i, m.radius);
    circles.keep(i, m);
    count(i);
    if (timeline != null) {
      timeline.add(m);
    }
    outgrown = outgrown || !neighbors.enter(i, reached);
    lookAnew(i);
  }

  /** Lets a circle look ahead and around anew with the next step, when all edits are done. */
  private void lookAnew(int i) {
    if (!outgrown) {
      queue.clear(i);
      kinds[i] = EDIT;
      queue.set(i, reached);
    }
  }

  @Override
  void remove(int i) {
    if (!outgrown) {
      queue.clear(i);
      neighbors.leave(i);
    }
    count(i);
  }

  @Override
  void keep(int i, Mover m) {
    circles.keep(i, m);
    lookAnew(i);
  }

  // Time.

  @Override
  FlightStates save() {
    FlightStates states = super.save();
    for (int i = 0; i < circles.count; i++) {
      sensed.save(i, states);
    }
    return states;
  }

  @Override
  void restore(FlightStates flights, double now) {
    reached = now;
    outgrown = true;
    sensed.clear();
    super.restore(flights, now);
    for (int i = 0; i < flights.count(); i++) {
      sensed.restore(i, flights);
    }
  }
}
