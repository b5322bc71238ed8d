// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.engine.Engine;
import dev.carom.internal.engine.StaticScene;
import dev.carom.internal.query.Candidate;
import dev.carom.internal.query.CircleQueries;
import dev.carom.internal.query.Proximity;
import dev.carom.internal.query.TracedPath;
import dev.carom.internal.query.Tracer;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.Index;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** Answers questions about a world. Nothing moves by them. */
final class WorldQueries {

  /** For questions without a filter: everything is seen. */
  static final IntPredicate ALL = code -> true;

  private final ObstacleTable obstacles;
  private final StaticScene staticScene;
  private final CircleTable circles;
  private final CircleRegistry registry;
  private final Proximity proximity;
  private final CircleQueries queries;
  private final boolean collide;

  WorldQueries(Engine engine, CircleRegistry registry, boolean collide, DoubleSupplier clock) {
    this.registry = registry;
    this.collide = collide;
    staticScene = engine.staticScene;
    obstacles = staticScene.obstacles;
    circles = engine.circles;
    proximity = new Proximity(obstacles, clock);
    queries = new CircleQueries(circles, registry);
  }

  Optional<Impact> cast(Circle circle, Vec2 velocity, double maxTime, double now, long filter) {
    MovingCircle mover = CircleCast.mover(circle, velocity, 1);
    mover.filter = filter;
    obstacles.setEpoch(now);
    try {
      Candidate obstacle = tracer(circle).first(mover, maxTime);
      Candidate first = collide ? queries.first(mover, obstacle, maxTime, now) : obstacle;
      return first == null ? Optional.empty() : Optional.of(impact(first, now));
    } finally {
      obstacles.setEpoch(0);
    }
  }

  private Impact impact(Candidate first, double now) {
    int code = first.code();
    if (!Codes.isCircle(code)) {
      Obstacle thing = PublicRecords.of(obstacles, code, 0);
      return CircleCast.impact(first, ObstacleKind.of(Codes.kind(code)), Codes.index(code), thing);
    }
    int slot = Codes.slot(code);
    Circle circle = new Circle(circles.x(slot, now), circles.y(slot, now), circles.radius(slot));
    return CircleCast.impact(first, ObstacleKind.CIRCLE, registry.id(slot), circle);
  }

  Trajectory trace(
      Circle circle,
      Vec2 velocity,
      double restitution,
      double duration,
      int bounces,
      long filter,
      double now) {
    MovingCircle mover = CircleCast.mover(circle, velocity, restitution);
    mover.filter = filter;
    obstacles.setEpoch(now);
    try {
      TracedPath path = tracer(circle).trace(mover, duration, bounces, Resolver.IMPACTS_PER_TRACE);
      return Trajectory.of(path, code -> PublicRecords.of(obstacles, code, 0));
    } finally {
      obstacles.setEpoch(0);
    }
  }

  private Tracer tracer(Circle circle) {
    return new Tracer(obstacles, staticScene.search, staticScene.gridAtLeast(circle.radius()));
  }

  double restitution(int code) {
    return Codes.isCircle(code)
        ? circles.restitution(Codes.slot(code))
        : obstacles.givenRestitution(code);
  }

  /** Returns the {@link Filter} of an obstacle or a circle. */
  long filter(int code) {
    return Codes.isCircle(code) ? registry.filter(Codes.slot(code)) : obstacles.filter(code);
  }

  /** Returns a predicate for the codes of what someone of a given filter meets. */
  IntPredicate met(int category, int mask) {
    long filter = Filter.of(category, mask);
    return code -> Filter.meet(filter, filter(code));
  }

  Vec2 velocity(int code) {
    return Codes.isCircle(code)
        ? new Vec2(circles.vx(Codes.slot(code)), circles.vy(Codes.slot(code)))
        : new Vec2(obstacles.ux(code), obstacles.uy(code));
  }

  Response response(int code) {
    return Response.of(ContactFlags.response(traits(code)));
  }

  boolean isOneWay(int code) {
    return ContactFlags.isOneWay(traits(code));
  }

  private int traits(int code) {
    if (Codes.isCircle(code)) {
      return registry.traits(Codes.slot(code));
    }
    return obstacles.traits(code);
  }

  int[] ids(ObstacleKind kind) {
    return kind == ObstacleKind.CIRCLE ? registry.ids() : ids(proximity.codes(kind.ordinal()));
  }

  int nearest(ObstacleKind kind, double x, double y, double now, IntPredicate seen) {
    if (kind != ObstacleKind.CIRCLE) {
      int code = proximity.nearest(codes(kind, seen), x, y);
      return code == Proximity.NONE ? -1 : Codes.index(code);
    }
    int slot = queries.nearest(x, y, now, circle -> seen.test(Codes.circle(circle)));
    return slot == Index.NONE ? -1 : registry.id(slot);
  }

  int[] overlapping(ObstacleKind kind, Circle disk, double now, IntPredicate seen) {
    double x = disk.x();
    double y = disk.y();
    double r = disk.radius();
    return kind == ObstacleKind.CIRCLE
        ? circleIds(queries.overlapping(x, y, r, now), seen)
        : ids(codes(kind, seen).filter(code -> proximity.overlaps(code, x, y, r)));
  }

  int[] overlapping(ObstacleKind kind, Bounds bounds, double now, IntPredicate seen) {
    double[] box = PublicRecords.walls(bounds);
    return kind == ObstacleKind.CIRCLE
        ? circleIds(queries.overlapping(box, now), seen)
        : ids(codes(kind, seen).filter(code -> proximity.overlaps(code, box)));
  }

  private IntStream codes(ObstacleKind kind, IntPredicate seen) {
    return proximity.codes(kind.ordinal()).filter(seen);
  }

  private int[] circleIds(IntStream slots, IntPredicate seen) {
    return slots.filter(slot -> seen.test(Codes.circle(slot))).map(registry::id).toArray();
  }

  private int[] ids(IntStream codes) {
    return codes.map(Codes::index).toArray();
  }
}
