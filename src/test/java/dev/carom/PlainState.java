// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.response.LoneContact;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.response.Shock;
import dev.carom.internal.search.FallQuestions;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FilterBits;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.KindNumber;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * All that a {@link PlainWorld} knows: obstacles, circles with their flights, and what they met.
 */
abstract class PlainState {

  static final double NEVER = Double.POSITIVE_INFINITY;

  final boolean collide;
  ObstacleTable obstacles;
  CircleRegistry registry;
  ObstacleResponse response;
  PairResponse pairs;
  Shock shock;
  PlainContacts contacts;
  LoneContact lone;
  final ImpactRows rows = new ImpactRows(16);
  Gravity gravity;
  FallQuestions falls;
  List<MovingCircle> bodies = new ArrayList<>();

  /** When each circle's flight last met each sensor, by the codes of obstacles. */
  List<Map<Integer, Double>> met = new ArrayList<>();

  /** The pairs that met and changed nothing: how long after the later of their flights began. */
  Map<Long, Double> metPairs = new HashMap<>();

  double now;

  /** The last event that happened when the clock shows the same as now, by the tail of its time. */
  double lastTail;

  double last;

  PlainState(Scene scene) {
    collide = scene.collide();
    obstacles = ObstacleTable.of(scene.data);
    registry = new CircleRegistry(scene.data, 1);
    gravity = new Gravity(scene.data.gx, scene.data.gy);
    respond();
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 v = scene.velocity(Kind.CIRCLE, i);
      MovingCircle m = new MovingCircle();
      m.start(
          i, c.x(), c.y(), c.radius(), v.x(), v.y(), scene.traits(Kind.CIRCLE, i).restitution());
      m.filter = registry.filter(i);
      release(m);
      bodies.add(m);
      met.add(new HashMap<>());
    }
    contacts = new PlainContacts(this);
  }

  private void respond() {
    falls = new FallQuestions(obstacles);
    response = new ObstacleResponse(obstacles, registry, gravity, this::addObstacles);
    pairs = new PairResponse(registry, response);
    shock = new Shock(registry, obstacles, this::addObstacles, collide ? new All() : null);
    response.ask(shock);
    lone = new LoneContact(obstacles, registry, gravity, this::addObstacles);
  }

  private void addObstacles(MovingCircle m, double reach, double now, IntList into) {
    for (int code : codes()) {
      if (!Codes.isWall(code) || obstacles.walls != null) {
        into.add(code);
      }
    }
  }

  /** Everything is near everything. */
  private final class All implements Shock.Others {

    @Override
    public void circlesNear(MovingCircle m, double reach, IntList into) {
      for (MovingCircle other : bodies) {
        if (other.id != m.id && registry.contains(other.id) && registry.meet(m.id, other.id)) {
          into.add(other.id);
        }
      }
    }

    @Override
    public MovingCircle copyOf(int i) {
      return copy(bodies.get(i));
    }
  }

  PlainState(PlainState other) {
    collide = other.collide;
    restore(other);
  }

  /** Goes to where another one is. */
  void restore(PlainState other) {
    obstacles = other.obstacles.copy();
    registry = copy(other.registry, other.bodies.size());
    gravity = new Gravity(other.gravity.x, other.gravity.y);
    respond();
    now = other.now;
    last = other.last;
    lastTail = other.lastTail;
    bodies = new ArrayList<>(other.bodies.stream().map(PlainState::copy).toList());
    met = new ArrayList<>();
    other.met.forEach(times -> met.add(new HashMap<>(times)));
    metPairs = new HashMap<>(other.metPairs);
    contacts = other.contacts.copy(this);
  }

  /** Here each circle has its id for a slot, whatever was removed. */
  private static CircleRegistry copy(CircleRegistry registry, int end) {
    CircleRegistry copy = new CircleRegistry(IntStream.range(0, end).toArray(), end);
    for (int i = 0; i < end; i++) {
      copy.setMass(i, registry.mass(i));
      copy.setTraits(i, registry.traits(i));
      copy.setFilter(i, registry.filter(i));
    }
    IntStream.range(0, end).filter(i -> !registry.contains(i)).forEach(copy::remove);
    return copy;
  }

  static MovingCircle copy(MovingCircle m) {
    FlightTable one = new FlightTable(1);
    one.put(0, m);
    MovingCircle copy = new MovingCircle();
    one.get(0, copy);
    copy.newFlight();
    copy.id = m.id;
    copy.filter = m.filter;
    return copy;
  }

  void release(MovingCircle m) {
    if (m.isCarried() && Codes.isCircle(m.last)) {
      m.last = MovingCircle.NOTHING;
    }
    boolean isHeavy = registry.mass(m.id) == NEVER;
    m.fall(isHeavy ? 0 : gravity.x, isHeavy ? 0 : gravity.y);
  }

  /** A flight begins: what it meets is new to it. */
  void begin(MovingCircle m) {
    met.get(m.id).clear();
    metPairs.keySet().removeIf(pair -> pair >> 32 == m.id || pair.intValue() == m.id);
  }

  /** Notes the time of an event. */
  void note(MovingCircle m) {
    lastTail = last == m.t ? Math.max(lastTail, m.tl) : m.tl;
    last = m.t;
  }

  /** An infinite mass that changed its way is there again for circles that it crushed. */
  void leaveJamsOfInfinite(MovingCircle m) {
    if (registry.mass(m.id) == NEVER) {
      leaveJams(Codes.circle(m.id));
    }
  }

  void leaveJams(int code) {
    bodies.stream()
        .filter(other -> other.jam != null && other.jam.concerns(code))
        .forEach(other -> other.forget(code, 0));
  }

  static long pair(MovingCircle a, MovingCircle b) {
    return (long) a.id << 32 | b.id;
  }

  /** The earlier flight is taken to the start of the later one. */
  static MovingCircle bringTogether(MovingCircle a, MovingCircle b) {
    double later = later(a, b);
    MovingCircle early = later > 0 ? a : b;
    MovingCircle late = later > 0 ? b : a;
    early.move(Math.abs(later));
    early.t = late.t;
    early.tl = late.tl;
    return early;
  }

  static double later(MovingCircle a, MovingCircle b) {
    return (b.t - a.t) + (b.tl - a.tl);
  }

  boolean meets(int circle, long filter) {
    return meet(registry.filter(circle), filter);
  }

  static boolean meet(long a, long b) {
    return (FilterBits.category(a) & FilterBits.mask(b)) != 0
        && (FilterBits.category(b) & FilterBits.mask(a)) != 0;
  }

  int[] codes() {
    return IntStream.concat(
            IntStream.range(0, obstacles.lines.end),
            IntStream.range(Codes.peg(0), obstacles.ofKind(KindNumber.PEG).end))
        .filter(code -> Codes.isWall(code) || !obstacles.isGone(code))
        .toArray();
  }
}
