// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.sweep.ParabolaWallSweep;
import dev.carom.internal.sweep.WallSweep;
import java.util.Optional;

/** Answers casts that are given as public records: asks the detector, and makes the impacts. */
final class CircleCast {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private CircleCast() {}

  /** A moving circle of no world. */
  static MovingCircle body(Circle circle, Vec2 v, double restitution) {
    MovingCircle m = new MovingCircle();
    m.start(0, circle.x(), circle.y(), circle.radius(), v.x(), v.y(), restitution);
    return m;
  }

  static Optional<Impact> line(Circle c, Vec2 v, Line l, Vec2 u, double maxTime) {
    return line(c, v, Vec2.ZERO, l, u, maxTime);
  }

  private static Optional<Impact> line(
      Circle c, Vec2 v, Vec2 g, Line l, Vec2 u, double maxTime) {
    Fall fall = fall(c, v, g).line(l.ax(), l.ay(), l.bx(), l.by(), u.x(), u.y());
    return first(fall, Kind.LINE, maxTime);
  }

  private static Optional<Impact> first(Fall fall, Kind kind, double maxTime) {
    boolean isStraight = fall.isStraight();
    int straight = isStraight ? FallSweep.straightContact(fall) : 0;
    double t =
        isStraight
            ? FallSweep.straightTime(fall, straight, maxTime)
            : FallSweep.time(fall, maxTime);
    if (t == NEVER) {
      return Optional.empty();
    }
    int contact = isStraight ? straight : FallSweep.contact(fall, t);
    Hit hit = new Hit().of(fall, contact, t);
    return Optional.of(impact(t, kind, Impact.NO_ID, contact, hit, false));
  }

  static Optional<Impact> bounds(Circle circle, Vec2 v, Bounds bounds, double maxTime) {
    double wallX = v.x() < 0 ? bounds.xmin() : bounds.xmax();
    double wallY = v.y() < 0 ? bounds.ymin() : bounds.ymax();
    double tx = WallSweep.time(circle.x(), circle.radius(), v.x(), wallX, maxTime);
    double ty = WallSweep.time(circle.y(), circle.radius(), v.y(), wallY, maxTime);
    if (tx == NEVER && ty == NEVER) {
      return Optional.empty();
    }
    boolean vertical = tx < ty || (tx == ty && !isEarlierInY(circle, v, wallX, wallY));
    int id =
        vertical
            ? (v.x() < 0 ? WallSweep.LEFT : WallSweep.RIGHT)
            : (v.y() < 0 ? WallSweep.BOTTOM : WallSweep.TOP);
    double wall = vertical ? wallX : wallY;
    double t = vertical ? tx : ty;
    Hit hit = new Hit().ofWall(fall(circle, v, Vec2.ZERO), id, wall, t);
    return Optional.of(impact(t, Kind.WALL, id, 0, hit, false));
  }

  /**
   * Tells of two walls with equal rounded times whether the horizontal one is exactly earlier.
   */
  private static boolean isEarlierInY(Circle circle, Vec2 v, double wallX, double wallY) {
    RealRoot tx = WallSweep.exactTime(circle.x(), circle.radius(), v.x(), wallX);
    RealRoot ty = WallSweep.exactTime(circle.y(), circle.radius(), v.y(), wallY);
    return ty.order(tx) < 0;
  }

  /** Disk 1 against disk 2, which is reported as one of the given kind. */
  static Optional<Impact> disk(
      Circle c1, Vec2 v1, Circle c2, Vec2 v2, Kind kind, double maxTime) {
    return accelerated(c1, v1, Vec2.ZERO, c2, v2, kind, maxTime);
  }

  /** With a constant acceleration g, against an obstacle of any kind. */
  static Optional<Impact> accelerated(
      Circle c, Vec2 v, Vec2 g, Obstacle obstacle, double maxTime) {
    if (obstacle instanceof Line line) {
      return line(c, v, g, line, Vec2.ZERO, maxTime);
    }
    if (obstacle instanceof Bounds bounds) {
      return acceleratedToBounds(c, v, g, bounds, maxTime);
    }
    return accelerated(c, v, g, (Circle) obstacle, Vec2.ZERO, Kind.PEG, maxTime);
  }

  private static Optional<Impact> acceleratedToBounds(
      Circle c, Vec2 v, Vec2 g, Bounds bounds, double maxTime) {
    int first = -1;
    double time = NEVER;
    for (int id = WallSweep.LEFT; id <= WallSweep.TOP; id++) {
      double t = wallTime(c, v, g, bounds, id, maxTime);
      if (t < time || (t == time && t < NEVER && isEarlier(c, v, g, bounds, id, first))) {
        first = id;
        time = t;
      }
    }
    if (first < 0) {
      return Optional.empty();
    }
    Hit hit = new Hit().ofWall(fall(c, v, g), first, wall(bounds, first), time);
    return Optional.of(impact(time, Kind.WALL, first, 0, hit, false));
  }

  private static double wallTime(
      Circle c, Vec2 v, Vec2 g, Bounds bounds, int id, double maxTime) {
    boolean vertical = id <= WallSweep.RIGHT;
    return ParabolaWallSweep.time(
        vertical ? c.x() : c.y(),
        c.radius(),
        vertical ? v.x() : v.y(),
        vertical ? g.x() : g.y(),
        wall(bounds, id),
        ParabolaWallSweep.inward(id),
        maxTime);
  }

  /** Tells of two walls with equal rounded times whether the first one is exactly earlier. */
  private static boolean isEarlier(Circle c, Vec2 v, Vec2 g, Bounds bounds, int id, int other) {
    return exactWallTime(c, v, g, bounds, id).compare(exactWallTime(c, v, g, bounds, other)) < 0;
  }

  private static RealRoot exactWallTime(Circle c, Vec2 v, Vec2 g, Bounds bounds, int id) {
    boolean vertical = id <= WallSweep.RIGHT;
    return ParabolaWallSweep.exact(
            vertical ? c.x() : c.y(),
            c.radius(),
            vertical ? v.x() : v.y(),
            vertical ? g.x() : g.y(),
            wall(bounds, id),
            ParabolaWallSweep.inward(id))
        .first(NEVER);
  }

  private static double wall(Bounds bounds, int id) {
    return switch (id) {
      case WallSweep.LEFT -> bounds.xmin();
      case WallSweep.RIGHT -> bounds.xmax();
      case WallSweep.BOTTOM -> bounds.ymin();
      default -> bounds.ymax();
    };
  }

  /** Disk 1 with a constant acceleration g against disk 2. */
  static Optional<Impact> accelerated(
      Circle c1, Vec2 v1, Vec2 g, Circle c2, Vec2 v2, Kind kind, double maxTime) {
    Fall fall = fall(c1, v1, g).disk(c2.x(), c2.y(), c2.radius(), v2.x(), v2.y());
    return first(fall, kind, maxTime);
  }

  private static Fall fall(Circle c, Vec2 v, Vec2 g) {
    return Fall.ofThread().flight(c.x(), c.y(), c.radius(), v.x(), v.y(), g.x(), g.y());
  }

  /** The impact that a cast found first, with a thing that halts circles, or not. */
  static Impact impact(MovingCircle first, Hit hit, Kind kind, int id, boolean halts) {
    return impact(first.cleared, kind, id, first.contact, hit, halts);
  }

  private static Impact impact(
      double t, Kind kind, int id, int contact, Hit hit, boolean halts) {
    return new Impact(
        t,
        Impact.NO_ID,
        kind,
        id,
        0,
        kind == Kind.WALL ? Feature.SIDE : Feature.of(Contact.part(contact)),
        hit.x(),
        hit.y(),
        hit.nx(),
        hit.ny(),
        hit.approachSpeed(),
        0,
        halts ? Outcome.HALTED : Outcome.BOUNCED);
  }
}
