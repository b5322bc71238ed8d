// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.engine.Engine;
import dev.carom.internal.query.CircleQueries;
import dev.carom.internal.query.Proximity;
import dev.carom.internal.query.Region;
import dev.carom.internal.query.TracedPath;
import dev.carom.internal.query.Tracer;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.util.Index;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.IntPredicate;

/** Answers questions about a world, without a change of it. */
final class WorldQueries {

  private final ObstacleTable obstacles;
  private final ObstacleIndex index;
  private final CircleTable circles;
  private final CircleRegistry registry;
  private final Proximity proximity;
  private final CircleQueries queries;
  private final boolean collide;
  private final Gravity gravity;

  WorldQueries(Engine engine, CircleRegistry registry, boolean collide, DoubleSupplier clock) {
    this.registry = registry;
    this.collide = collide;
    index = engine.staticScene.index;
    gravity = engine.gravity;
    obstacles = index.obstacles;
    circles = engine.circles;
    proximity = new Proximity(index, clock);
    queries = new CircleQueries(circles, registry, index.wanted);
  }

  /** Notes that circles may have moved, or were edited. */
  void forget() {
    queries.forget();
  }

  Optional<Impact> cast(Circle circle, Vec2 velocity, double maxTime, double now, long filter) {
    MovingCircle body = new SweptCircle(circle, velocity).body(1);
    body.filter = filter;
    Tracer tracer = tracer(1, now);
    obstacles.beginQuestion(now);
    try {
      first(body, tracer, maxTime, now);
      return body.next == MovingCircle.NOTHING
          ? Optional.empty()
          : Optional.of(impact(body, tracer, now));
    } finally {
      obstacles.endQuestion();
    }
  }

  void cast(Casts casts, double maxTime, double now, long filter) {
    MovingCircle body = new MovingCircle();
    Tracer tracer = tracer(casts.size(), now);
    try {
      for (int i = 0; i < casts.size(); i++) {
        obstacles.beginQuestion(now);
        casts.load(i, body);
        body.filter = filter;
        first(body, tracer, maxTime, now);
        answer(casts, i, body, tracer, now);
      }
    } finally {
      obstacles.endQuestion();
    }
  }

  private void answer(Casts casts, int i, MovingCircle first, Tracer tracer, double now) {
    int code = first.next;
    if (code == MovingCircle.NOTHING) {
      casts.miss(i);
    } else if (Codes.isCircle(code)) {
      casts.hit(i, first, registry.id(Codes.slot(code)), queries.hit(first, now));
    } else {
      casts.hit(i, first, Codes.index(code), tracer.hit(first));
    }
  }

  /** Makes a tracer of paths among the obstacles, for so many casts. */
  private Tracer tracer(int casts, double now) {
    index.expect(casts);
    if (collide) {
      queries.expect(casts, now);
    }
    return new Tracer(index);
  }

  private void first(MovingCircle body, Tracer tracer, double maxTime, double now) {
    tracer.first(body, maxTime);
    if (collide) {
      queries.first(body, tracer, maxTime, now);
    }
  }

  private Impact impact(MovingCircle first, Tracer tracer, double now) {
    int code = first.next;
    if (!Codes.isCircle(code)) {
      Kind kind = Kind.of(Codes.kind(code));
      boolean halts = obstacles.halts(code);
      int id = Codes.index(code);
      return Impact.of(first.cleared, kind, id, first.contact, tracer.hit(first), halts);
    }
    int slot = Codes.slot(code);
    int id = registry.id(slot);
    boolean halts = registry.halts(slot);
    Hit hit = queries.hit(first, now);
    return Impact.of(first.cleared, Kind.CIRCLE, id, first.contact, hit, halts);
  }

  Trajectory trace(
      Circle circle,
      Vec2 velocity,
      double restitution,
      double duration,
      int impacts,
      long filter,
      double now) {
    index.expect(1);
    MovingCircle body = new SweptCircle(circle, velocity).body(restitution);
    body.filter = filter;
    obstacles.beginQuestion(now);
    try {
      TracedPath path =
          new Tracer(index, gravity).trace(body, duration, impacts, Resolver.IMPACTS_PER_TRACE);
      return Trajectory.of(path);
    } finally {
      obstacles.endQuestion();
    }
  }

  /** Returns a circle or an obstacle as it is now. */
  Obstacle shape(int code, double now) {
    int slot = Codes.slot(code);
    return Codes.isCircle(code)
        ? new Circle(Vec2.within(circles.x(slot, now), circles.y(slot, now)), circles.radius(slot))
        : PublicRecords.of(obstacles, code, now);
  }

  Traits traits(int code) {
    if (!Codes.isCircle(code)) {
      return Traits.of(obstacles, code);
    }
    int slot = Codes.slot(code);
    return Traits.of(registry, slot, circles.restitution(slot));
  }

  Vec2 velocity(int code, double now) {
    if (Codes.isCircle(code)) {
      return new Vec2(circles.vx(Codes.slot(code), now), circles.vy(Codes.slot(code), now));
    }
    return obstacles.arrival(code) <= now
        ? Vec2.ZERO
        : new Vec2(obstacles.ux(code), obstacles.uy(code));
  }

  /** Tells whether a circle is carried, and moves as what carries it. */
  boolean isResting(int slot, double now) {
    if (circles.isMember(slot)) {
      return !circles.isAwake(slot);
    }
    if (!circles.isSupported(slot) || circles.gx(slot) != 0 || circles.gy(slot) != 0) {
      return false;
    }
    int support = circles.support(slot);
    double ux = obstacles.ux(support);
    double uy = obstacles.uy(support);
    return circles.vx(slot, now) == ux && circles.vy(slot, now) == uy;
  }

  int[] ids(Kind kind) {
    return kind == Kind.CIRCLE ? registry.ids() : ids(obstacles.codes(kind.ordinal()).toArray());
  }

  int nearest(Kind kind, double x, double y, double now, long filter) {
    if (kind != Kind.CIRCLE) {
      IntPredicate seen = obstacles.met(filter);
      int code = proximity.nearest(kind.ordinal(), kind.ordinal() + 1, x, y, seen);
      return code == Index.NONE ? -1 : Codes.index(code);
    }
    int slot = queries.nearest(x, y, now, slots(filter));
    return slot == Index.NONE ? -1 : registry.id(slot);
  }

  int[] overlapping(Kind kind, Region region, double now, long filter) {
    return kind == Kind.CIRCLE
        ? circleIds(queries.overlapping(region, now, slots(filter)))
        : ids(
            proximity.overlapping(
                kind.ordinal(), kind.ordinal() + 1, region, obstacles.met(filter)));
  }

  /** Returns a predicate for the slots of circles that meet a thing with a filter. */
  private IntPredicate slots(long filter) {
    return slot -> FilterBits.meet(filter, registry.filter(slot));
  }

  /** Replaces codes of obstacles by their ids. */
  private static int[] ids(int[] codes) {
    Arrays.setAll(codes, k -> Codes.index(codes[k]));
    return codes;
  }

  /** Replaces slots of circles by their ids. */
  private int[] circleIds(int[] slots) {
    Arrays.setAll(slots, k -> registry.id(slots[k]));
    return slots;
  }
}
