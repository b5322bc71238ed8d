// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.DoubleDouble.sumTail;

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
final class Collisions implements Engine, Neighbors.Visitor {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Events in one call, and so many more for each circle. */
  static final int EVENTS_PER_CALL = 200_000;

  private static final int EVENTS_PER_CIRCLE = 1_000;

  private static final int STATIC = 0;
  private static final int PAIR = 1;
  private static final int CROSSING = 2;

  private final Circles circles;
  private final Grid[] grid;
  private final String model;
  private final Obstacles obstacles;
  private final BroadSearch search;
  private final ObstacleResponse response;
  private final PairResponse pairs;
  private final ImpactLog log;
  private final Neighbors neighbors;
  private final EventQueue queue;
  private final long budget;
  private boolean unfinished;

  /** The time of the last event. */
  private double reached;

  /** How often each circle's velocity changed, modulo 2^32. */
  private final int[] counts;

  // The first meeting foreseen of each circle: when, with whom, and the other's count then.
  private final double[] meetings;
  private final double[] meetingTails;
  private final int[] partners;
  private final int[] partnerCounts;
  private final byte[] kinds;

  private final Mover other = new Mover();

  Collisions(Scene scene, Machinery machinery, ImpactLog log) {
    this.log = log;
    obstacles = Obstacles.of(scene);
    int count = scene.circleCount();
    Grids grids = new Grids(scene, obstacles, machinery);
    model = grids.model().toString().replace("ignore each other", "collide");
    circles = new Circles(count);
    grid = new Grid[count];
    search = new BroadSearch(obstacles);
    int patience = 1_000 + 10 * count;
    response = new ObstacleResponse(obstacles, patience);
    pairs = new PairResponse(scene.masses, scene.circleTraits, response);
    budget = EVENTS_PER_CALL + (long) EVENTS_PER_CIRCLE * count;
    counts = new int[count];
    meetings = new double[count];
    meetingTails = new double[count];
    partners = new int[count];
    partnerCounts = new int[count];
    kinds = new byte[count];
    queue = new EventQueue(count);
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      grid[i] = grids.of(circles.mover.radius);
      search.extend(circles.mover, grid[i], 0);
      circles.store(i);
    }
    neighbors = new Neighbors(circles, scene.bounds, machinery.pairCells());
    for (int i = 0; i < count; i++) {
      neighbors.newFlight(i);
      foresee(i);
    }
  }

  @Override
  public Circles circles() {
    return circles;
  }

  @Override
  public String model() {
    return model;
  }

  @Override
  public boolean unfinished() {
    return unfinished;
  }

  @Override
  public double advance(double end) {
    unfinished = false;
    for (long events = 0; ; events++) {
      int i = queue.first();
      if (i == EventQueue.NONE || queue.time(i) > end) {
        return end;
      }
      if (events == budget) {
        unfinished = true;
        return reached;
      }
      // A crossing may be noticed late by rounding: time does not go back for it.
      reached = Math.max(reached, queue.time(i));
      happen(i);
    }
  }

  private void happen(int i) {
    switch (kinds[i]) {
      case CROSSING -> {
        neighbors.cross(i, this);
        schedule(i);
      }
      case PAIR -> meet(i);
      default -> meetObstacle(i);
    }
  }

  private void meetObstacle(int i) {
    circles.load(i);
    Mover m = circles.mover;
    if (m.next == Mover.NOTHING) {
      search.extend(m, grid[i], m.cleared);
      circles.store(i);
      schedule(i);
      return;
    }
    if (response.resolve(m, log)) {
      changed(i, m);
      foresee(i);
    } else {
      search.extend(m, grid[i], m.cleared);
      circles.store(i);
      schedule(i);
    }
  }

  private void meet(int i) {
    int j = partners[i];
    if (partnerCounts[i] != counts[j]) {
      foresee(i);
      return;
    }
    int low = Math.min(i, j);
    int high = Math.max(i, j);
    double tau = approach(low, high, NEVER);
    circles.load(low, circles.mover);
    circles.load(high, other);
    Mover early = together(circles.mover, other);
    circles.mover.fly(tau);
    other.fly(tau);
    early.standsStill &= early.flown == tau;
    pairs.resolve(circles.mover, other, log);
    changed(low, circles.mover);
    changed(high, other);
    foresee(low);
    foresee(high);
  }

  /** Puts a circle on its new flight. */
  private void changed(int i, Mover m) {
    search.extend(m, grid[i], 0);
    circles.store(i, m);
    counts[i]++;
    neighbors.newFlight(i);
  }

  /** Looks anew for the first circle that circle i meets. */
  private void foresee(int i) {
    meetings[i] = NEVER;
    meetingTails[i] = 0;
    partners[i] = EventQueue.NONE;
    neighbors.visitAll(i, this);
    schedule(i);
  }

  /** Keeps j as what circle i meets first, if that is so. */
  @Override
  public void visit(int i, int j) {
    double tau = i < j ? approach(i, j, meetings[i]) : approach(j, i, meetings[i]);
    if (tau == NEVER) {
      return;
    }
    // The later start and tau, as head and tail.
    double s = startHead + tau;
    double l = sumTail(startHead, tau, s) + startTail;
    double head = s + l;
    double tail = sumTail(s, l, head);
    boolean first =
        head != meetings[i]
            ? head < meetings[i]
            : tail != meetingTails[i] ? tail < meetingTails[i] : j < partners[i];
    if (first) {
      meetings[i] = head;
      meetingTails[i] = tail;
      partners[i] = j;
      partnerCounts[i] = counts[j];
    }
  }

  // The later start of the two flights that approach() looked at last.
  private double startHead;
  private double startTail;

  /**
   * When two circles meet, counted from the later start of their flights; {@code +infinity} for
   * never, and for certainly later than a given time.
   */
  private double approach(int i, int j, double before) {
    double[] s = circles.state;
    int a = i * Circles.STATE;
    int b = j * Circles.STATE;
    double vx1 = s[a + Circles.VX];
    double vy1 = s[a + Circles.VY];
    double vx2 = s[b + Circles.VX];
    double vy2 = s[b + Circles.VY];
    double x1 = s[a + Circles.X];
    double y1 = s[a + Circles.Y];
    double x2 = s[b + Circles.X];
    double y2 = s[b + Circles.Y];
    // By how much j starts later than i.
    double later =
        (s[b + Circles.T] - s[a + Circles.T]) + (s[b + Circles.TL] - s[a + Circles.TL]);
    if (later > 0) {
      x1 = Math.fma(vx1, later, x1);
      y1 = Math.fma(vy1, later, y1);
      startHead = s[b + Circles.T];
      startTail = s[b + Circles.TL];
    } else {
      x2 = Math.fma(vx2, -later, x2);
      y2 = Math.fma(vy2, -later, y2);
      startHead = s[a + Circles.T];
      startTail = s[a + Circles.TL];
    }
    double r1 = s[a + Circles.RADIUS];
    double r2 = s[b + Circles.RADIUS];
    int contact = DiskSweep.contact(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2);
    if (contact == DiskSweep.MISS || pairs.skips(circles, i, j)) {
      return NEVER;
    }
    // Rounded up far beyond what its own rounding took, so that nothing is later that is not.
    if (contact == DiskSweep.LATER && before < NEVER) {
      double window = Math.max(0, (before - startHead) * (1 + 0x1p-40) + before * 0x1p-50);
      if (DiskSweep.compareTime(x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, window) > 0) {
        return NEVER;
      }
    }
    return DiskSweep.time(contact, x1, y1, r1, vx1, vy1, x2, y2, r2, vx2, vy2, NEVER);
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

  /** Puts the first of a circle's events into the calendar. */
  private void schedule(int i) {
    double time = neighbors.crossing(i);
    double tail = Double.NEGATIVE_INFINITY;
    long rank = i;
    byte kind = CROSSING;
    double due = circles.due[i];
    if (due < time) {
      kind = STATIC;
      time = due;
      int next = circles.codes[i * Circles.CODES + Circles.NEXT];
      if (next != Mover.NOTHING) {
        tail = circles.dueTails[i];
        rank = (long) next << 31 | i;
      }
    }
    if (meetings[i] < time || (meetings[i] == time && kind == STATIC && meetingTails[i] < tail)) {
      kind = PAIR;
      time = meetings[i];
      tail = meetingTails[i];
      rank = (long) (Obstacles.CIRCLES + Math.min(i, partners[i])) << 31 | Math.max(i, partners[i]);
    }
    kinds[i] = kind;
    queue.set(i, time, tail, rank);
  }
}
