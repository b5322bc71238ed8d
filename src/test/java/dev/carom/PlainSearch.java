// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.ExactSigns;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Falls;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.sweep.WallSweep;
import java.util.List;

/** Finds the first event of a {@link PlainWorld}: every circle asks every obstacle and circle. */
abstract class PlainSearch extends PlainState {

  // The first event found so far: when, of what rank, and what it is.
  double time;
  double tail;
  private long rank;
  int low;
  int high;
  double wait;

  PlainSearch(Scene scene) {
    super(scene);
  }

  PlainSearch(PlainState other) {
    super(other);
  }

  double find(List<MovingCircle> some) {
    time = NEVER;
    tail = 0;
    rank = Long.MAX_VALUE;
    for (MovingCircle m : some) {
      if (registry.contains(m.id)) {
        lookAtObstacles(m);
        for (int j = m.id + 1; collide && j < bodies.size(); j++) {
          if (registry.contains(j)) {
            lookAtPair(m, bodies.get(j));
          }
        }
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

  private void lookAtObstacles(MovingCircle m) {
    double best = NEVER;
    int code = MovingCircle.NOTHING;
    for (int k : codes()) {
      boolean there =
          (m.jam == null || !m.jam.concerns(k))
              && meets(m.id, obstacles.filter(k))
              && !isHeldFrom(m, k);
      double t = there ? untilArrival(m, k, next(m, k)) : NEVER;
      boolean sensor = obstacles.isSensor(k);
      boolean before = t == best && t != NEVER && sensor && !obstacles.isSensor(code);
      if (t < best || before) {
        best = t;
        code = k;
      }
    }
    if (falls.endOfSlide(m) < best) {
      best = falls.endOfSlide(m);
      code = m.support;
    }
    m.cleared = best;
    m.next = code;
    if (code == MovingCircle.NOTHING) {
      return;
    }
    m.contact = 0;
    if (isByCurve(m, code)) {
      m.contact = falls.contact(m, code, best);
    } else if (Codes.isLine(code)) {
      double[] l = obstacles.rowAt(code, m.t, m.tl);
      double ux = obstacles.ux(code);
      double uy = obstacles.uy(code);
      m.contact =
          SegmentSweep.contact(m.x, m.y, m.radius, m.vx, m.vy, l[0], l[1], l[2], l[3], ux, uy);
    }
    double head = m.after(best);
    keep(head, m.afterTail(best, head), (long) code << 31 | m.id, m.id, -1, best);
  }

  /** Whether contact keeps a member from an obstacle. */
  final boolean isHeldFrom(MovingCircle m, int k) {
    boolean alike = obstacles.ux(k) == m.vx && obstacles.uy(k) == m.vy && !obstacles.turns(k);
    return m.isMember() && !obstacles.isSensor(k) && (m.mode != MovingCircle.FROZEN || alike);
  }

  /** When a circle next meets an obstacle, in its flight and after all that it met in that. */
  private double next(MovingCircle m, int code) {
    if (isByCurve(m, code)) {
      return falls.time(m, code, met.get(m.id).getOrDefault(code, 0.0));
    }
    if (code == m.last) {
      return NEVER;
    }
    double t = sweep(m, code);
    return obstacles.isSensor(code) && (t == 0 || met.get(m.id).containsKey(code)) ? NEVER : t;
  }

  private double sweep(MovingCircle m, int code) {
    if (Codes.isWall(code)) {
      return sweepWall(m, code);
    }
    // Where a thing that moves was when the flight began.
    double[] n = obstacles.rowAt(code, m.t, m.tl);
    double ux = obstacles.ux(code);
    double uy = obstacles.uy(code);
    if (Codes.isLine(code)) {
      if (obstacles.isOneWay(code) && !isStopped(m, n[0], n[1], n[2], n[3], ux, uy)) {
        return NEVER;
      }
      return new SweptCircle(m.x, m.y, m.radius, m.vx, m.vy)
          .timeToLine(n[0], n[1], n[2], n[3], ux, uy, NEVER);
    }
    return new SweptCircle(m.x, m.y, m.radius, m.vx, m.vy)
        .timeToCircle(new SweptCircle(n[0], n[1], n[2], ux, uy), NEVER);
  }

  /** Whether the centre is left of a line and goes to its right: a point's path from there on. */
  private static boolean isStopped(
      MovingCircle m, double ax, double ay, double bx, double by, double ux, double uy) {
    int side = ExactSigns.NUMBERS.cross(bx, by, ax, ay, m.x, m.y, ax, ay);
    int drift = ExactSigns.NUMBERS.cross(bx, by, ax, ay, m.vx, m.vy, ux, uy);
    return side > 0 && drift < 0;
  }

  /** A wall is met only on the way to it. */
  private double sweepWall(MovingCircle m, int code) {
    if (obstacles.walls == null) {
      return NEVER;
    }
    boolean vertical = Codes.isVertical(code);
    boolean up = code == Codes.RIGHT || code == Codes.TOP;
    double v = vertical ? m.vx : m.vy;
    if (up ? !(v > 0) : !(v < 0)) {
      return NEVER;
    }
    Bounds b = PublicRecords.bounds(obstacles.walls);
    double wall = vertical ? (up ? b.xmax() : b.xmin()) : (up ? b.ymax() : b.ymin());
    return WallSweep.time(vertical ? m.x : m.y, m.radius, v, wall, NEVER);
  }

  private void lookAtPair(MovingCircle a, MovingCircle b) {
    int ofA = Codes.circle(a.id);
    int ofB = Codes.circle(b.id);
    boolean justHit = a.last == ofB && b.last == ofA;
    boolean alike = a.gx == b.gx && a.gy == b.gy;
    if ((justHit && alike)
        || (!pairs.isSilent(a.id, b.id) && contacts.keepsApart(a, b))
        || !meets(a.id, registry.filter(b.id))
        || pairs.isInert(a.id, a.jam, b.id, b.jam)) {
      return;
    }
    MovingCircle one = copy(a);
    MovingCircle two = copy(b);
    bringTogether(one, two);
    double tau = next(one, two, justHit && later(a, b) == 0);
    if (tau == NEVER) {
      return;
    }
    MovingCircle late = later(a, b) > 0 ? b : a;
    double s = late.t + tau;
    double l = sumTail(late.t, tau, s) + late.tl;
    double head = s + l;
    keep(head, sumTail(s, l, head), pairs.rank(a.id, b.id), a.id, b.id, tau);
  }

  /** How long it takes two circles to meet, if that was not reported before. */
  private double next(MovingCircle a, MovingCircle b, boolean justHit) {
    if (!pairs.isSilent(a.id, b.id)) {
      return justHit
          ? Falls.returnToDisk(
              a.x, a.y, a.vx, a.vy, a.gx - b.gx, a.gy - b.gy, b.x, b.y, b.vx, b.vy, NEVER)
          : sweep(a, b, -1);
    }
    boolean sensor = pairs.isSensor(a.id, b.id);
    return sweep(a, b, metPairs.getOrDefault(pair(a, b), sensor ? 0.0 : -1.0));
  }

  /** How long it takes two circles to meet, later than a given time. */
  private static double sweep(MovingCircle a, MovingCircle b, double after) {
    double gx = a.gx - b.gx;
    double gy = a.gy - b.gy;
    if (gx == 0 && gy == 0) {
      double t =
          new SweptCircle(a.x, a.y, a.radius, a.vx, a.vy)
              .timeToCircle(new SweptCircle(b.x, b.y, b.radius, b.vx, b.vy), NEVER);
      return t > after ? t : NEVER;
    }
    return after < 0
        ? Falls.timeOfDisk(
            a.x, a.y, a.radius, a.vx, a.vy, gx, gy, b.x, b.y, b.radius, b.vx, b.vy, NEVER)
        : Falls.timeOfDiskAfter(
            a.x, a.y, a.radius, a.vx, a.vy, gx, gy, b.x, b.y, b.radius, b.vx, b.vy, after, NEVER);
  }

  /** When a circle that is not there would first hit something but a sensor. */
  double cast(Circle circle, Vec2 v, int category, int mask) {
    long filter = FilterBits.of(category, mask);
    MovingCircle m = new SweptCircle(circle, v).load(new MovingCircle(), 1);
    double first = NEVER;
    obstacles.beginQuestion(now);
    for (int code : codes()) {
      boolean there = !obstacles.isSensor(code) && meet(filter, obstacles.filter(code));
      first = Math.min(first, there ? sweep(m, code) : NEVER);
    }
    obstacles.endQuestion();
    for (MovingCircle other : bodies) {
      boolean there =
          collide
              && registry.contains(other.id)
              && !registry.isSensor(other.id)
              && meets(other.id, filter);
      MovingCircle then = copy(other);
      then.move(MovingCircle.since(other.t, other.tl, now));
      if (there && Math.abs(then.x) + Math.abs(then.y) < NEVER) {
        first = Math.min(first, sweep(m, then, -1));
      }
    }
    return first;
  }

  /** Whether a flight would meet an obstacle, if it never ended. */
  boolean isAhead(MovingCircle m, int code) {
    double t = isByCurve(m, code) ? falls.time(m, code, 0) : sweep(m, code);
    return untilArrival(m, code, t) < NEVER;
  }

  /** Whether a circle comes to an obstacle on a curve, as seen from that. */
  private boolean isByCurve(MovingCircle m, int code) {
    return m.isFalling() || obstacles.turns(code);
  }

  /** A time of impact; infinite if the obstacle has arrived before. */
  private double untilArrival(MovingCircle m, int code, double time) {
    double arrival = Codes.isWall(code) ? NEVER : obstacles.arrival(code) - m.t - m.tl;
    return arrival > 0 && time <= arrival ? time : NEVER;
  }
}
