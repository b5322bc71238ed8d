// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.query.CircleQueries;
import dev.carom.internal.query.Proximity;
import dev.carom.internal.query.Region;
import dev.carom.internal.query.TracedPath;
import dev.carom.internal.query.Tracer;
import dev.carom.internal.response.ContactCore;
import dev.carom.internal.search.ObstacleIndex;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneDataBuilder;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.sweep.LineShape;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.KindNumber;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleSupplier;

/** Answers questions about obstacles, and about the circles of a world. */
final class Questions implements Resolver {

  /** The most impacts of one trace; exact arithmetic counts as in a world's budget. */
  static final int IMPACTS_PER_TRACE = 100_000;

  private final ObstacleIndex index;
  private final ObstacleTable obstacles;
  private final DoubleSupplier clock;
  private final Proximity proximity;

  // Null for a resolver without circles.
  private final CircleTable table;
  private final CircleRegistry registry;
  private final CircleQueries circles;

  /** The circles that a cast can hit; null if there are none, or if they ignore each other. */
  private final CircleQueries targets;

  /** The one that keeps what is used again: a view of it shares that. */
  private final Questions shared;

  private final long filter;

  /** Null if obstacles have changed, and always where several threads may ask. */
  private Tracer tracer;

  /** Asks about obstacles at rest or in motion, at time 0. */
  Questions(ObstacleTable obstacles) {
    this(new ObstacleIndex(obstacles), () -> 0, null, null, false);
  }

  Questions(
      ObstacleIndex index,
      DoubleSupplier clock,
      CircleTable table,
      CircleRegistry registry,
      boolean collide) {
    this.index = index;
    this.clock = clock;
    this.table = table;
    this.registry = registry;
    obstacles = index.obstacles;
    proximity = new Proximity(index, clock);
    circles = table == null ? null : new CircleQueries(table, registry, index.wanted);
    targets = collide ? circles : null;
    filter = FilterBits.DEFAULT;
    shared = this;
  }

  private Questions(Questions shared, long filter) {
    this.shared = shared;
    this.filter = filter;
    index = shared.index;
    clock = shared.clock;
    table = shared.table;
    registry = shared.registry;
    obstacles = shared.obstacles;
    proximity = shared.proximity;
    circles = shared.circles;
    targets = shared.targets;
  }

  static Questions of(List<? extends Obstacle> obstacles) {
    SceneDataBuilder builder = new SceneDataBuilder();
    for (int i = 0; i < obstacles.size(); i++) {
      Obstacle obstacle = Check.notNull("obstacles[" + i + "]", obstacles.get(i));
      if (obstacle instanceof Line line) {
        builder.obstacle(KindNumber.LINE, line.ax(), line.ay(), line.bx(), line.by());
      } else if (obstacle instanceof Outline outline) {
        builder.outline(outline.values());
      } else if (obstacle instanceof Circle peg) {
        builder.obstacle(KindNumber.PEG, peg.x(), peg.y(), peg.radius());
      } else {
        add(builder, (Bounds) obstacle);
      }
    }
    return new Questions(ObstacleTable.of(builder.build()));
  }

  private static void add(SceneDataBuilder builder, Bounds bounds) {
    try {
      builder.bounds(bounds.xmin(), bounds.ymin(), bounds.xmax(), bounds.ymax());
    } catch (IllegalStateException second) {
      throw new IllegalArgumentException(
          "obstacles hold a second " + bounds + ": expected one bounds");
    }
  }

  /** Notes that circles may have moved. */
  void forget() {
    circles.forget();
  }

  /** Notes that anything may have changed. */
  void changed() {
    circles.forget();
    tracer = null;
  }

  @Override
  public Resolver withFilter(Filter filter) {
    return new Questions(shared, Check.notNull("filter", filter).bits());
  }

  // Casts.

  @Override
  public Optional<Impact> cast(SweptCircle circle, double maxTime) {
    Check.notNull("circle", circle);
    Check.duration("maxTime", maxTime);
    Tracer asked = asked(1);
    MovingCircle body = circle.load(asked.body, 1);
    double now = clock.getAsDouble();
    obstacles.beginQuestion(now);
    try {
      first(body, asked, maxTime, now);
      return body.next == MovingCircle.NOTHING
          ? Optional.empty()
          : Optional.of(impact(body, hit(body, asked, now)));
    } finally {
      obstacles.endQuestion();
    }
  }

  @Override
  public void cast(Casts casts, double maxTime) {
    Check.notNull("casts", casts);
    Check.duration("maxTime", maxTime);
    Tracer asked = asked(casts.size());
    MovingCircle body = asked.body;
    double now = clock.getAsDouble();
    try {
      for (int i = 0; i < casts.size(); i++) {
        obstacles.beginQuestion(now);
        casts.load(i, body);
        first(body, asked, maxTime, now);
        if (body.next == MovingCircle.NOTHING) {
          casts.miss(i);
        } else {
          Hit hit = hit(body, asked, now);
          casts.hit(i, body, id(body.next), obstacles, hit);
        }
      }
    } finally {
      obstacles.endQuestion();
    }
  }

  private Impact impact(MovingCircle body, Hit hit) {
    int code = body.next;
    if (!Codes.isCircle(code)) {
      return Impact.of(body, id(code), obstacles, hit);
    }
    boolean halts = registry.halts(Codes.slot(code));
    return Impact.of(body.cleared, Kind.CIRCLE, id(code), body.contact, hit, halts);
  }

  /** Returns a tracer for so many casts. */
  private Tracer asked(int casts) {
    index.expect(casts);
    if (targets != null) {
      targets.expect(casts, clock.getAsDouble());
    }
    if (shared.tracer == null && registry != null) {
      shared.tracer = new Tracer(index); // a world belongs to one thread
    }
    return registry == null ? new Tracer(index) : shared.tracer;
  }

  private void first(MovingCircle body, Tracer asked, double maxTime, double now) {
    body.filter = filter;
    asked.first(body, maxTime);
    if (targets != null) {
      targets.first(body, asked, maxTime, now);
    }
  }

  private Hit hit(MovingCircle body, Tracer asked, double now) {
    return Codes.isCircle(body.next) ? targets.hit(body, now) : asked.hit(body);
  }

  private int id(int code) {
    return Codes.isCircle(code) ? registry.id(Codes.slot(code)) : obstacles.id(code);
  }

  // Paths.

  @Override
  public Trajectory trace(SweptCircle circle, double restitution, double duration, int impacts) {
    Check.notNull("circle", circle);
    Check.notNegative("restitution", restitution);
    MovingCircle body = circle.load(new MovingCircle(), restitution);
    body.filter = filter;
    Gravity gravity = new Gravity(circle.gx(), circle.gy());
    return trace(body, gravity, targets, duration, impacts);
  }

  /** Follows a circle of the world, with another velocity. */
  Trajectory trace(int slot, double vx, double vy, Gravity gravity, double duration, int impacts) {
    Check.finite("vx", vx);
    Check.finite("vy", vy);
    double now = clock.getAsDouble();
    MovingCircle body = new MovingCircle();
    double restitution = table.restitution(slot);
    body.start(
        slot, table.x(slot, now), table.y(slot, now), table.radius(slot), vx, vy, restitution);
    body.filter = registry.filter(slot);
    boolean falls = registry.mass(slot) < Double.POSITIVE_INFINITY;
    return trace(
        body,
        falls ? gravity : new Gravity(0, 0),
        registry.isSensor(slot) ? null : targets,
        duration,
        impacts);
  }

  private Trajectory trace(
      MovingCircle body, Gravity gravity, CircleQueries inTheWay, double duration, int impacts) {
    Check.notNegative("duration", duration);
    Check.notNegative("impacts", impacts);
    index.expect(1);
    obstacles.beginQuestion(clock.getAsDouble());
    try {
      CircleRegistry own = body.id == Impact.NO_ID ? null : registry;
      TracedPath path =
          new Tracer(index)
              .trace(body, gravity, own, inTheWay, duration, impacts, IMPACTS_PER_TRACE);
      return Trajectory.of(path, slot -> slot == Impact.NO_ID ? slot : registry.id(slot));
    } finally {
      obstacles.endQuestion();
    }
  }

  // Things near a point or a region.

  @Override
  public Optional<Nearest> nearest(double x, double y, Kind... kinds) {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.notNull("kinds", kinds);
    Nearest nearest = null;
    for (Kind kind : set(kinds)) {
      int code = nearest(kind, x, y);
      if (code != Index.NONE) {
        Nearest other = answer(kind, code, x, y);
        nearest = nearest == null || other.distance() < nearest.distance() ? other : nearest;
      }
    }
    return Optional.ofNullable(nearest);
  }

  private static Set<Kind> set(Kind... kinds) {
    for (int i = 0; i < kinds.length; i++) {
      Check.notNull("kinds[" + i + "]", kinds[i]);
    }
    return kinds.length == 0 ? EnumSet.allOf(Kind.class) : EnumSet.copyOf(Arrays.asList(kinds));
  }

  private int nearest(Kind kind, double x, double y) {
    int number = kind.ordinal();
    if (kind != Kind.CIRCLE) {
      return proximity.nearest(number, x, y, obstacles.met(filter));
    }
    int slot =
        circles == null ? Index.NONE : circles.nearest(x, y, clock.getAsDouble(), this::isMet);
    return slot == Index.NONE ? slot : Codes.circle(slot);
  }

  private Nearest answer(Kind kind, int code, double x, double y) {
    double now = clock.getAsDouble();
    if (kind == Kind.WALL) {
      boolean isVertical = Codes.isVertical(code);
      double place = obstacles.walls[code];
      double distance = Math.abs((isVertical ? x : y) - place);
      return new Nearest(kind, code, distance, isVertical ? place : x, isVertical ? y : place);
    }
    if (kind == Kind.LINE && obstacles.isInside(code, x, y, now)) {
      return new Nearest(kind, id(code), 0, x, y);
    }
    if (kind == Kind.LINE) {
      Vec2 at = PublicRecords.line(obstacles, code, now).closestPoint(new Vec2(x, y));
      return new Nearest(kind, id(code), proximity.distance(code, x, y), at.x(), at.y());
    }
    Circle disk = kind == Kind.PEG ? PublicRecords.peg(obstacles, code, now) : circle(code, now);
    double distance = Proximity.distance(disk.x(), disk.y(), disk.radius(), x, y);
    double part = distance == 0 ? 1 : disk.radius() / (disk.radius() + distance);
    double atX = Coordinates.between(part, disk.x(), x);
    double atY = Coordinates.between(part, disk.y(), y);
    return new Nearest(kind, id(code), distance, atX, atY);
  }

  private Circle circle(int code, double now) {
    int slot = Codes.slot(code);
    return new Circle(table.x(slot, now), table.y(slot, now), table.radius(slot));
  }

  @Override
  public int[] overlapping(Kind kind, Circle disk) {
    return overlapping(kind, PublicRecords.region(disk));
  }

  @Override
  public int[] overlapping(Kind kind, Bounds box) {
    return overlapping(kind, PublicRecords.region(box));
  }

  private int[] overlapping(Kind kind, Region region) {
    int[] codes = codesOverlapping(Check.notNull("kind", kind), region);
    if (kind != Kind.CIRCLE) {
      return obstacles.ids(codes);
    }
    Arrays.setAll(codes, k -> registry.id(Codes.slot(codes[k])));
    return codes;
  }

  /** The codes of what overlaps a region; of outlines, see {@link Proximity#overlapping}. */
  private int[] codesOverlapping(Kind kind, Region region) {
    if (kind != Kind.CIRCLE) {
      return proximity.overlapping(kind.ordinal(), region, obstacles.met(filter));
    }
    if (circles == null) {
      return new int[0];
    }
    int[] found = circles.overlapping(region, clock.getAsDouble(), this::isMet);
    Arrays.setAll(found, k -> Codes.circle(found[k]));
    return found;
  }

  // Contacts.

  /** Lists what is so near to a circle in contact that the law of contact counts it. */
  List<Contact> contacts(int slot) {
    List<Contact> contacts = new ArrayList<>();
    if (table.isMember(slot) || table.isSupported(slot)) {
      Circle circle = circle(Codes.circle(slot), clock.getAsDouble());
      double most = circle.radius() + ContactCore.reach(circle.radius());
      Circle wide = new Circle(circle.center(), most);
      Questions own = new Questions(shared, registry.filter(slot));
      for (Kind kind : Kind.values()) {
        for (int code : own.codesOverlapping(kind, PublicRecords.region(wide))) {
          boolean isCircle = kind == Kind.CIRCLE;
          if (isCircle ? touches(slot, Codes.slot(code)) : isSolid(code, circle)) {
            add(contacts, code, answer(kind, code, circle.x(), circle.y()), circle);
          }
        }
      }
    }
    return List.copyOf(contacts);
  }

  /** Tells whether a circle that is near another one is in contact with it. */
  private boolean touches(int slot, int other) {
    double now = clock.getAsDouble();
    double r = table.radius(slot);
    double itsR = table.radius(other);
    boolean counts = table.isMember(other) || registry.mass(other) == Double.POSITIVE_INFINITY;
    double gap =
        Proximity.distance(
            table.x(other, now), table.y(other, now), itsR, table.x(slot, now), table.y(slot, now));
    return targets != null
        && slot != other
        && counts
        && !registry.isSensor(other)
        && gap <= r + ContactCore.reach(Math.min(r, itsR));
  }

  /**
   * Tells whether an obstacle stops a circle: it is no sensor, no one-way line on its right, and no
   * polygon that it is in.
   */
  private boolean isSolid(int code, Circle circle) {
    double now = clock.getAsDouble();
    if (obstacles.isSensor(code) || obstacles.isInside(code, circle.x(), circle.y(), now)) {
      return false;
    }
    int outside = Codes.isWall(code) ? 0 : obstacles.isOneWay(code) ? 1 : obstacles.outside(code);
    if (outside == 0) {
      return true;
    }
    Line line = PublicRecords.line(obstacles, code, now);
    int side = LineShape.side(line.ax(), line.ay(), line.bx(), line.by(), circle.x(), circle.y());
    return side * outside > 0;
  }

  /** Adds a contact, but a vertex between two sides of an outline once. */
  private void add(List<Contact> contacts, int code, Nearest at, Circle circle) {
    double length = StrictMath.hypot(circle.x() - at.x(), circle.y() - at.y());
    double nx = length == 0 ? 0 : (circle.x() - at.x()) / length;
    double ny = length == 0 ? 1 : (circle.y() - at.y()) / length;
    int part = Codes.isLine(code) ? obstacles.side(code) : 0;
    boolean isListed =
        contacts.stream()
            .anyMatch(
                it ->
                    it.kind() == at.kind() && it.id() == at.id() && it.nx() == nx && it.ny() == ny);
    if (!isListed) {
      contacts.add(new Contact(at.kind(), at.id(), part, nx, ny));
    }
  }

  /** Tells whether a circle with the filter meets the one in a slot. */
  private boolean isMet(int slot) {
    return FilterBits.meet(filter, registry.filter(slot));
  }
}
