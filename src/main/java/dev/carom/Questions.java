// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/** What can be asked of a world without moving anything. */
final class Questions {

  private final Surroundings surroundings;
  private final Circles circles;
  private final Roster roster;
  private final Proximity proximity;
  private final boolean collide;

  Questions(Engine engine, Roster roster, boolean collide) {
    this.roster = roster;
    this.collide = collide;
    surroundings = engine.surroundings;
    circles = engine.circles;
    proximity = new Proximity(surroundings.obstacles);
  }

  Optional<Impact> cast(Circle circle, Vec2 velocity, double T, double now) {
    Tracer tracer = surroundings.tracer(circle.radius());
    Optional<Candidate> obstacle = tracer.first(circle, velocity, T);
    Optional<Candidate> first = collide ? first(obstacle, circle, velocity, T, now) : obstacle;
    return first.flatMap(candidate -> candidate.until(T));
  }

  /** The first contact of all, circles included: of exactly simultaneous ones they come last. */
  private Optional<Candidate> first(
      Optional<Candidate> obstacle, Circle circle, Vec2 velocity, double T, double now) {
    Candidate first = obstacle.orElse(null);
    PresentCodes present = roster.present();
    for (int i = 0; i < present.size(); i++) {
      int slot = present.get(i);
      if (isThere(slot, now) && !roster.isSensor(slot)) {
        Vec2 v = new Vec2(circles.vx(slot), circles.vy(slot));
        double limit = first == null ? T : first.time();
        Candidate other = Casts.candidate(circle, velocity, circle(slot, now), v, limit);
        if (other != null && (first == null || other.isBefore(first))) {
          first = other.of(ObstacleKind.CIRCLE, roster.id(slot));
        }
      }
    }
    return Optional.ofNullable(first);
  }

  Trajectory trace(Circle circle, Vec2 velocity, double restitution, double duration, int bounces) {
    return surroundings
        .tracer(circle.radius())
        .trace(
            Mover.of(circle, velocity, restitution), duration, bounces, Resolver.IMPACTS_PER_TRACE);
  }

  double restitution(int code) {
    return code >= Obstacles.CIRCLES
        ? circles.restitution(code - Obstacles.CIRCLES)
        : surroundings.obstacles.givenRestitution(code);
  }

  Response response(int code) {
    return Response.of(Traits.response(traits(code)));
  }

  boolean isOneWay(int code) {
    return Traits.isOneWay(traits(code));
  }

  private int traits(int code) {
    if (code >= Obstacles.CIRCLES) {
      return roster.traits(code - Obstacles.CIRCLES);
    }
    Obstacles obstacles = surroundings.obstacles;
    return code < Obstacles.WALLS ? obstacles.boundsTraits : obstacles.traits(code);
  }

  int[] ids(ObstacleKind kind) {
    return kind == ObstacleKind.CIRCLE ? roster.ids() : ids(proximity.codes(kind));
  }

  int nearest(ObstacleKind kind, double x, double y, double now) {
    if (kind != ObstacleKind.CIRCLE) {
      int code = proximity.nearest(proximity.codes(kind), x, y);
      return code == Proximity.NONE ? -1 : surroundings.obstacles.index(code);
    }
    double least = Double.POSITIVE_INFINITY;
    int nearest = -1;
    for (int slot : slots(now).toArray()) {
      double distance =
          Proximity.distance(
              circles.x(slot, now), circles.y(slot, now), circles.radius(slot), x, y);
      if (nearest < 0 || distance < least) {
        least = distance;
        nearest = roster.id(slot);
      }
    }
    return nearest;
  }

  int[] overlapping(ObstacleKind kind, Circle disk, double now) {
    return kind == ObstacleKind.CIRCLE
        ? ids(now, slot -> overlaps(slot, disk, now))
        : ids(
            proximity
                .codes(kind)
                .filter(code -> proximity.overlaps(code, disk.x(), disk.y(), disk.radius())));
  }

  private boolean overlaps(int slot, Circle disk, double now) {
    return Proximity.overlap(
        circles.x(slot, now),
        circles.y(slot, now),
        circles.radius(slot),
        disk.x(),
        disk.y(),
        disk.radius());
  }

  int[] overlapping(ObstacleKind kind, Bounds bounds, double now) {
    double[] box = Records.walls(bounds);
    return kind == ObstacleKind.CIRCLE
        ? ids(now, slot -> overlaps(slot, box, now))
        : ids(proximity.codes(kind).filter(code -> proximity.overlaps(code, box)));
  }

  private boolean overlaps(int slot, double[] box, double now) {
    return Proximity.overlap(circles.x(slot, now), circles.y(slot, now), circles.radius(slot), box);
  }

  private int[] ids(IntStream codes) {
    return codes.map(surroundings.obstacles::index).toArray();
  }

  private int[] ids(double now, IntPredicate isMeant) {
    return slots(now).filter(isMeant).map(roster::id).toArray();
  }

  private IntStream slots(double now) {
    return roster.present().stream(slot -> !isThere(slot, now));
  }

  /** Whether a circle is there, and not beyond the range of doubles. */
  private boolean isThere(int slot, double now) {
    return roster.contains(slot)
        && Math.abs(circles.x(slot, now)) <= Double.MAX_VALUE
        && Math.abs(circles.y(slot, now)) <= Double.MAX_VALUE;
  }

  private Circle circle(int slot, double now) {
    return new Circle(circles.x(slot, now), circles.y(slot, now), circles.radius(slot));
  }
}
