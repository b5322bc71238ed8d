// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Resolves circles in contact, one of which is {@linkplain StuckRule stuck}: all their contacts act
 * at once and without bounce.
 *
 * <p>The {@linkplain InelasticShock inelastic shock} gives their new velocities: the limit of
 * repeated impacts of restitution 0. Energy never grows; momentum is kept unless an obstacle takes
 * it up. Contacts that then approach by no more than rounding become inert, until an impact makes
 * the two approach or part by more.
 *
 * <p>Two cases have no such solution, or one that takes too long to find:
 *
 * <ul>
 *   <li>Moving obstacles or infinite masses close on a circle, or press it against an obstacle. The
 *       circle is <i>crushed</i>: it stops, and they are inert for it, so that they pass over it.
 *   <li>Masses are so different that the relaxation does not end. Then all circles move on as one,
 *       with the velocity of their common momentum, or stop if one of them touches an obstacle.
 * </ul>
 */
public final class ContactCluster {

  /** Finds circles and obstacles that may touch a circle of an engine. */
  public interface Vicinity {

    /** A superset of the circles that touch circle i, in any order. */
    int[] circlesNear(int i);

    /** A circle in flight, a copy. */
    MovingCircle copyOf(int i);

    /** A superset of the codes of the obstacles that touch a circle at its place, in any order. */
    int[] obstaclesNear(MovingCircle m);
  }

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /** A touch of member a, with member b or an obstacle at rest. */
  private record Contact(int a, int b, Touch touch) {}

  private final CircleRegistry registry;
  private final PairResponse pairs;
  private final ObstacleResponse response;
  private final ObstacleTable obstacles;
  private final Vicinity vicinity;

  /**
   * Circles of finite mass that touch each other, and those of infinite mass that touch them. A
   * moving obstacle that touches them stands here as a circle of infinite mass, with the complement
   * of its code for an id.
   */
  private final List<MovingCircle> members = new ArrayList<>();

  private final List<Contact> contacts = new ArrayList<>();

  public ContactCluster(
      CircleRegistry registry,
      PairResponse pairs,
      ObstacleResponse response,
      ObstacleTable obstacles,
      Vicinity vicinity) {
    this.registry = registry;
    this.pairs = pairs;
    this.response = response;
    this.obstacles = obstacles;
    this.vicinity = vicinity;
    response.ask(this);
  }

  /**
   * Gives new velocities to the given circles, to all that touch them, to all that touch those, and
   * so on. Each contact that acted gets a row in the log.
   *
   * @param hit one circle that has just hit an obstacle, or two that have just hit each other, at
   *     the start of their new flights
   * @return the given circles and all that changed, at the start of their new flights
   */
  public Collection<MovingCircle> resolve(ImpactRows log, MovingCircle... hit) {
    Set<MovingCircle> changed = new LinkedHashSet<>(List.of(hit));
    if (isInfinite(hit[0]) && obstacles.moves(hit[0].last)) {
      crush(hit[0], hit[0].last);
      return changed;
    }
    gather(hit);
    if (members.size() == 1) {
      return changed; // nothing but the impact itself
    }
    InelasticShock shock = shock();
    boolean resolved = shock.resolve();
    if (!resolved && crush(changed, log, hit)) {
      shock = shock();
      resolved = shock.resolve();
    }
    for (int k = 0; k < contacts.size(); k++) {
      if ((!resolved || shock.acted(k)) && !isHit(contacts.get(k), hit)) {
        report(contacts.get(k), log);
      }
    }
    if (resolved) {
      change(shock, changed);
    } else {
      joinAll(changed);
    }
    return changed;
  }

  /** Lets a circle meet again what crushed it, once all that did has left it. */
  public void forgetCrushersOf(MovingCircle m) {
    if (!isCrushed(m)) {
      m.forgetCrushers();
    }
  }

  /** Whether a circle is crushed: an infinite mass that crushed it still overlaps it. */
  boolean isCrushed(MovingCircle m) {
    return m.jam != null && isCrushedByIgnored(m);
  }

  /** The circles that may touch a circle; none that ignores it. */
  private IntStream idsNear(MovingCircle m) {
    return IntStream.of(vicinity.circlesNear(m.id))
        .sorted()
        .distinct()
        .filter(id -> id != m.id && registry.meet(id, m.id) && !pairs.isSensor(id, m.id))
        .filter(id -> m.jam == null || !m.jam.isCrushedBy(Codes.circle(id)));
  }

  private boolean isCrushedByIgnored(MovingCircle m) {
    for (int entry : m.jam.entries()) {
      if (IgnoreList.crushes(entry) && Codes.isCircle(IgnoreList.code(entry))) {
        MovingCircle mass = vicinity.copyOf(Codes.slot(IgnoreList.code(entry)));
        if (Touch.of(m, broughtTo(m, mass)) != null) {
          return true;
        }
      }
    }
    return Touch.isCrushed(m, obstacles);
  }

  private static boolean isObstacle(MovingCircle m) {
    return m.id < 0;
  }

  private boolean isInfinite(MovingCircle m) {
    return isObstacle(m) || registry.mass(m.id) == INFINITE;
  }

  private double mass(MovingCircle m) {
    return isObstacle(m) ? INFINITE : pairs.mass(m);
  }

  /** Advances a circle to the time of another one. */
  private MovingCircle broughtTo(MovingCircle time, MovingCircle m) {
    double dt = (time.t - m.t) + (time.tl - m.tl);
    m.advance(dt, 0, time.t, time.tl, dt == 0, obstacles);
    m.newFlight();
    return m;
  }

  private void gather(MovingCircle... hit) {
    members.clear();
    contacts.clear();
    Map<Integer, Integer> numbers = new HashMap<>();
    for (MovingCircle m : hit) {
      forgetCrushersOf(m);
      numbers.put(m.id, members.size());
      members.add(m);
    }
    for (int k = 0; k < members.size(); k++) { // the list grows
      if (mass(members.get(k)) < INFINITE) {
        addObstacles(k, numbers);
        addCircles(k, numbers);
      }
    }
  }

  private void addObstacles(int k, Map<Integer, Integer> numbers) {
    MovingCircle m = members.get(k);
    for (int code : vicinity.obstaclesNear(m)) {
      boolean passesOver = m.jam != null && m.jam.isCrushedBy(code);
      Touch touch = isSolid(m, code) && !passesOver ? Touch.of(m, obstacles, code) : null;
      if (touch != null) {
        int b = obstacles.moves(code) ? number(code, m, numbers) : InelasticShock.OBSTACLE;
        contacts.add(new Contact(k, b, touch));
      }
    }
  }

  /** Whether a circle bounces off an obstacle: the filters let them meet, and it is no sensor. */
  private boolean isSolid(MovingCircle m, int code) {
    return !obstacles.isSensor(code) && Filter.meet(registry.filter(m.id), obstacles.filter(code));
  }

  /** The number of a moving obstacle among the members. */
  private int number(int code, MovingCircle m, Map<Integer, Integer> numbers) {
    return numbers.computeIfAbsent(
        ~code,
        id -> {
          MovingCircle moving = new MovingCircle();
          moving.start(id, m.x, m.y, 0, obstacles.ux(code), obstacles.uy(code), 1);
          members.add(moving);
          return members.size() - 1;
        });
  }

  private void addCircles(int k, Map<Integer, Integer> numbers) {
    MovingCircle m = members.get(k);
    for (int id : idsNear(m).toArray()) {
      addCircle(k, id, numbers);
    }
  }

  private void addCircle(int k, int id, Map<Integer, Integer> numbers) {
    MovingCircle m = members.get(k);
    Integer known = numbers.get(id);
    MovingCircle other = known != null ? members.get(known) : broughtTo(m, vicinity.copyOf(id));
    if (known == null) {
      forgetCrushersOf(other);
    } else if (known < k && mass(other) < INFINITE) {
      return; // its own search added this contact
    }
    Touch touch = Touch.of(m, other);
    if (touch != null) {
      if (known == null) {
        numbers.put(id, members.size());
        members.add(other);
      }
      contacts.add(new Contact(k, numbers.get(id), touch));
    }
  }

  private InelasticShock shock() {
    InelasticShock shock = new InelasticShock(members.size(), contacts.size());
    for (int i = 0; i < members.size(); i++) {
      MovingCircle m = members.get(i);
      shock.setCircle(i, m.vx, m.vy, mass(m));
    }
    for (Contact c : contacts) {
      shock.addContact(c.a, c.b, c.touch.nx(), c.touch.ny());
    }
    return shock;
  }

  /** Stops the circles that something infinite touches, and lets that pass over them. */
  private boolean crush(Set<MovingCircle> changed, ImpactRows log, MovingCircle... hit) {
    List<Contact> ofInfinite =
        contacts.stream()
            .filter(c -> c.b != InelasticShock.OBSTACLE && isInfinite(members.get(c.b)))
            .toList();
    for (Contact c : ofInfinite) {
      if (!isHit(c, hit)) {
        report(c, log);
      }
    }
    for (Contact c : ofInfinite) {
      MovingCircle m = members.get(c.a);
      crush(m, c.touch.code());
      changed.add(m);
    }
    return contacts.removeAll(ofInfinite);
  }

  /** Stops a circle, and lets what crushed it pass over it. */
  private static void crush(MovingCircle m, int code) {
    m.vx = 0;
    m.vy = 0;
    m.last = MovingCircle.NOTHING;
    m.jam = IgnoreList.crushedBy(m.jam, code);
  }

  /** Whether a contact is the impact under resolution, which has its row in the log already. */
  private boolean isHit(Contact c, MovingCircle... hit) {
    boolean isFirst = members.get(c.a) == hit[0];
    return isFirst && (hit.length == 1 ? c.touch.code() == hit[0].last : c.b == 1);
  }

  private void report(Contact c, ImpactRows log) {
    MovingCircle a = members.get(c.a);
    if (Codes.isCircle(c.touch.code())) {
      MovingCircle b = members.get(c.b);
      pairs.report(a.id < b.id ? a : b, a.id < b.id ? b : a, log);
    } else {
      response.report(a, c.touch, log);
    }
    log.setOutcome(ImpactRows.JAMMED);
  }

  private void change(InelasticShock shock, Set<MovingCircle> changed) {
    for (int i = 0; i < members.size(); i++) {
      MovingCircle m = members.get(i);
      if (mass(m) < INFINITE && (m.vx != shock.vx(i) || m.vy != shock.vy(i))) {
        m.vx = shock.vx(i);
        m.vy = shock.vy(i);
        StopRule.stopsBeyondRange(m);
        m.last = MovingCircle.NOTHING;
        changed.add(m);
      }
    }
    for (MovingCircle m : changed) {
      StuckRule.noteSpeed(m, shock.speed());
      m.ignoreCirclesOnly();
    }
    for (int k = 0; k < contacts.size(); k++) {
      if (shock.isFaint(k)) {
        makeInert(contacts.get(k), changed);
      }
    }
  }

  private void makeInert(Contact c, Set<MovingCircle> changed) {
    MovingCircle a = members.get(c.a);
    a.jam = IgnoreList.with(a.jam, c.touch.code());
    changed.add(a);
    if (Codes.isWall(c.touch.code())) {
      stopAtWall(a, c.touch);
    }
    if (Codes.isCircle(c.touch.code())) {
      MovingCircle b = members.get(c.b);
      b.jam = IgnoreList.with(b.jam, Codes.circle(a.id));
      changed.add(b);
    }
  }

  /** Stops the rest of an approach to a wall: the wall is inert now, and the rest would add up. */
  private static void stopAtWall(MovingCircle m, Touch wall) {
    if (m.vx * wall.nx() < 0) {
      m.vx = 0;
    }
    if (m.vy * wall.ny() < 0) {
      m.vy = 0;
    }
  }

  /** Gives all members the velocity of their common momentum, or stops them if one is held. */
  private void joinAll(Set<MovingCircle> changed) {
    boolean held = contacts.stream().anyMatch(c -> c.b == InelasticShock.OBSTACLE);
    double mass = 0;
    double vx = 0;
    double vy = 0;
    for (MovingCircle m : members) {
      double own = mass(m);
      held |= own == INFINITE;
      mass += own;
      // The mean of the velocities so far, weighted by mass.
      vx = (1 - own / mass) * vx + own / mass * m.vx;
      vy = (1 - own / mass) * vy + own / mass * m.vy;
    }
    for (MovingCircle m : members) {
      if (mass(m) < INFINITE) {
        m.vx = held ? 0 : vx;
        m.vy = held ? 0 : vy;
        m.ignoreCirclesOnly();
        m.last = MovingCircle.NOTHING;
        changed.add(m);
      }
    }
  }
}
