// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.DoubleDouble.sumTail;

import java.util.stream.IntStream;

/**
 * Circles that collide, the plain way: no cells, no grid, no calendar and no memory. Before each
 * event every circle is asked about every obstacle and every other circle, by the public detector,
 * and the first answer happens. What an impact then does is the library's own response.
 */
final class BruteForce {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final Scene scene;
  private final Obstacles obstacles;
  private final int[] codes;
  private final Mover[] movers;
  private final ObstacleResponse response;
  private final PairResponse pairs;
  private final ImpactLog log = new ImpactLog(16);

  // The first event found so far: when, of what rank, and what it is.
  private double time;
  private double tail;
  private long rank;
  private int low;
  private int high;
  private double wait;

  BruteForce(Scene scene) {
    this.scene = scene;
    obstacles = Obstacles.of(scene);
    codes =
        IntStream.concat(
                IntStream.range(0, obstacles.endOfLines),
                IntStream.range(Obstacles.PEGS, obstacles.endOfPegs))
            .toArray();
    response = new ObstacleResponse(obstacles, 1_000 + 10 * scene.circleCount());
    pairs = new PairResponse(scene.masses, scene.circleTraits, response);
    movers = new Mover[scene.circleCount()];
    for (int i = 0; i < movers.length; i++) {
      Circle c = scene.circle(i);
      Vec2 v = scene.velocity(i);
      movers[i] = new Mover();
      movers[i].start(i, c.x(), c.y(), c.radius(), v.x(), v.y(), scene.circleRestitution(i));
    }
  }

  /** The first so many impacts until the given time, in the order of a world's log. */
  ImpactLog advance(double end, int most) {
    log.clear();
    while (log.size() < most && find() <= end) {
      if (high < 0) {
        response.resolve(movers[low], log);
      } else {
        meet(movers[low], movers[high]);
      }
    }
    log.sort();
    return log;
  }

  private void meet(Mover a, Mover b) {
    Mover early = bringTogether(a, b);
    a.fly(wait);
    b.fly(wait);
    early.standsStill &= early.flown == wait;
    pairs.resolve(a, b, log);
  }

  /** The earlier flight is taken to the start of the later one. */
  private static Mover bringTogether(Mover a, Mover b) {
    double later = later(a, b);
    Mover early = later > 0 ? a : b;
    Mover late = later > 0 ? b : a;
    early.x = Math.fma(early.vx, Math.abs(later), early.x);
    early.y = Math.fma(early.vy, Math.abs(later), early.y);
    early.flown += Math.abs(later);
    early.t = late.t;
    early.tl = late.tl;
    return early;
  }

  private static double later(Mover a, Mover b) {
    return (b.t - a.t) + (b.tl - a.tl);
  }

  private double find() {
    time = NEVER;
    tail = 0;
    rank = Long.MAX_VALUE;
    for (Mover m : movers) {
      lookAtObstacles(m);
      for (int j = m.id + 1; j < movers.length; j++) {
        lookAtPair(m, movers[j]);
      }
    }
    return time;
  }

  private void keep(double head, double tail, long rank, int low, int high, double wait) {
    boolean first =
        head != time ? head < time : tail != this.tail ? tail < this.tail : rank < this.rank;
    if (first && head != NEVER) {
      time = head;
      this.tail = tail;
      this.rank = rank;
      this.low = low;
      this.high = high;
      this.wait = wait;
    }
  }

  private void lookAtObstacles(Mover m) {
    double best = NEVER;
    int code = Mover.NOTHING;
    for (int k : codes) {
      boolean there = k != m.last && (m.jam == null || !m.jam.makesInert(k));
      double t = there ? sweep(m, k) : NEVER;
      if (t < best) {
        best = t;
        code = k;
      }
    }
    m.cleared = best;
    m.next = code;
    if (code == Mover.NOTHING) {
      return;
    }
    if (code >= Obstacles.WALLS && code < Obstacles.PEGS) {
      Line l = scene.line(code - Obstacles.WALLS);
      m.contact =
          SegmentSweep.contact(m.x, m.y, m.radius, m.vx, m.vy, l.ax(), l.ay(), l.bx(), l.by());
    }
    double head = m.after(best);
    keep(head, m.afterTail(best, head), (long) code << 31 | m.id, m.id, -1, best);
  }

  private double sweep(Mover m, int code) {
    if (code < Obstacles.WALLS) {
      return sweepWall(m, code);
    }
    if (code < Obstacles.PEGS) {
      Line l = scene.line(code - Obstacles.WALLS);
      return SweptCircle.line(
          m.x, m.y, m.radius, m.vx, m.vy, l.ax(), l.ay(), l.bx(), l.by(), NEVER);
    }
    Circle p = scene.peg(code - Obstacles.PEGS);
    return SweptCircle.peg(m.x, m.y, m.radius, m.vx, m.vy, p.x(), p.y(), p.radius(), NEVER);
  }

  /** A wall is met only on the way to it. */
  private double sweepWall(Mover m, int code) {
    if (scene.bounds == null) {
      return NEVER;
    }
    boolean vertical = code <= Obstacles.RIGHT;
    boolean up = code == Obstacles.RIGHT || code == Obstacles.TOP;
    double v = vertical ? m.vx : m.vy;
    if (up ? !(v > 0) : !(v < 0)) {
      return NEVER;
    }
    Bounds b = scene.bounds;
    double wall = vertical ? (up ? b.xmax() : b.xmin()) : (up ? b.ymax() : b.ymin());
    return SweptCircle.wall(vertical ? m.x : m.y, m.radius, v, wall, NEVER);
  }

  private void lookAtPair(Mover a, Mover b) {
    int ofA = Obstacles.CIRCLES + a.id;
    int ofB = Obstacles.CIRCLES + b.id;
    boolean justHit = a.last == ofB && b.last == ofA;
    boolean inert =
        a.jam != null && b.jam != null && a.jam.makesInert(ofB) && b.jam.makesInert(ofA);
    if (justHit || inert) {
      return;
    }
    double later = later(a, b);
    Mover early = later > 0 ? a : b;
    Mover late = later > 0 ? b : a;
    double x = Math.fma(early.vx, Math.abs(later), early.x);
    double y = Math.fma(early.vy, Math.abs(later), early.y);
    double tau =
        SweptCircle.pair(
            x,
            y,
            early.radius,
            early.vx,
            early.vy,
            late.x,
            late.y,
            late.radius,
            late.vx,
            late.vy,
            NEVER);
    if (tau == NEVER) {
      return;
    }
    double s = late.t + tau;
    double l = sumTail(late.t, tau, s) + late.tl;
    double head = s + l;
    keep(head, sumTail(s, l, head), (long) ofA << 31 | b.id, a.id, b.id, tau);
  }
}
