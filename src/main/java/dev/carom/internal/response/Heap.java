// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Circles that lie on each other under gravity. By the rules of {@link Settling} they would hop for
 * ever. A circle that made {@link #TRIAL} slow contacts with other circles tries to rest, together
 * with all slow circles that it touches, that those touch, and so on.
 *
 * <p>They rest if their contacts can hold them: if pushes along the normals leave each with an
 * acceleration below {@link #STILL} of gravity. By the principle of least constraint of C. F. Gauss
 * (1829) the accelerations are the nearest to gravity, weighted by mass, with which no contact
 * approaches; {@link InelasticShock} finds them. Circles that accelerate are left out, and the rest
 * tries again without them.
 *
 * <p>A circle at rest is a peg for what comes slowly. A faster impact frees it. All circles at rest
 * in contact with it, directly or through others, are then free, too.
 */
public final class Heap {

  /** The number of slow contacts after which a circle tries to rest. */
  public static final int TRIAL = MovingCircle.SLOW_LIMIT;

  /**
   * After a trial the circles that do not rest wait for one more contact for so many circles in it.
   * With less delay a heap spends most of its time with trials; with more, a row without clearance
   * makes many impacts before it rests.
   */
  private static final int DELAY = 4;

  /** Larger heaps do not try to rest: a trial would take longer than their hops. */
  private static final int MOST = 200;

  /** The largest acceleration of a circle that is held, as a part of gravity. */
  private static final double STILL = 0x1p-7;

  /** The accelerations of the circles that are left out err by no more, as a part of gravity. */
  private static final double TOLERANCE = 0x1p-14;

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /** A touch of member a, with member b or something that stays where it is. */
  private record Contact(int a, int b, Touch touch, MovingCircle other) {}

  private final CircleRegistry registry;
  private final PairResponse pairs;
  private final ObstacleResponse response;
  private final ObstacleTable obstacles;
  private final Gravity gravity;
  private final ContactCluster.Vicinity vicinity;

  private final List<MovingCircle> members = new ArrayList<>();
  private final List<Contact> contacts = new ArrayList<>();

  /** The number of each member, by the circle. */
  private final Map<Integer, Integer> numbers = new HashMap<>();

  public Heap(
      CircleRegistry registry,
      PairResponse pairs,
      ObstacleResponse response,
      ObstacleTable obstacles,
      Gravity gravity,
      ContactCluster.Vicinity vicinity) {
    this.registry = registry;
    this.pairs = pairs;
    this.response = response;
    this.obstacles = obstacles;
    this.gravity = gravity;
    this.vicinity = vicinity;
  }

  /**
   * Lets circles rest that hold each other, and frees those that are no longer held. The contacts
   * that hold a circle which comes to rest get rows in the log.
   *
   * @param hit two circles that have just hit each other, at the start of their new flights
   * @return the circles that rest or fall from now on, and those that may try again later
   */
  public Collection<MovingCircle> rest(ImpactRows log, MovingCircle... hit) {
    gather(hit);
    if (members.size() > MOST) {
      return delayed();
    }
    boolean[] rests = new boolean[members.size()];
    Arrays.fill(rests, true);
    while (!isBalanced(rests)) {
      // At least one more is left out each time.
    }
    boolean[] comes = new boolean[rests.length];
    List<MovingCircle> changed = new ArrayList<>();
    for (int i = 0; i < rests.length; i++) {
      MovingCircle m = members.get(i);
      comes[i] = rests[i] && !m.isFrozen();
      if (rests[i] != m.isFrozen() || m.slowContacts > 0) {
        changed.add(m);
      }
    }
    for (int i = 0; i < rests.length; i++) {
      MovingCircle m = members.get(i);
      if (comes[i]) {
        Settling.pin(m);
      } else if (m.isFrozen() && !rests[i]) {
        response.settling.fall(m);
      }
      m.slowContacts = rests[i] ? 0 : delay();
      m.last = MovingCircle.NOTHING;
    }
    report(comes, log, hit);
    return changed;
  }

  /** The members that wait for their next trial; those at rest stay so. */
  private Collection<MovingCircle> delayed() {
    List<MovingCircle> waiting = new ArrayList<>();
    for (MovingCircle m : members) {
      if (m.slowContacts > 0) {
        m.slowContacts = delay();
        m.last = MovingCircle.NOTHING;
        waiting.add(m);
      }
    }
    return waiting;
  }

  private int delay() {
    return -members.size() / DELAY;
  }

  /**
   * Whether contacts with each other and with what stays hold all circles that are to rest. If not,
   * those that accelerate are left out.
   */
  private boolean isBalanced(boolean[] rests) {
    InelasticShock shock = new InelasticShock(members.size(), contacts.size());
    for (int i = 0; i < rests.length; i++) {
      shock.setCircle(i, gravity.x, gravity.y, registry.mass(members.get(i).id));
    }
    for (Contact c : contacts) {
      if (rests[c.a] && (c.b == InelasticShock.OBSTACLE || rests[c.b])) {
        shock.addContact(c.a, c.b, c.touch.nx(), c.touch.ny());
      }
    }
    boolean balanced = shock.balance(rests, STILL, TOLERANCE);
    for (int i = 0; i < rests.length; i++) {
      rests[i] &= balanced || shock.isSmall(i, STILL);
    }
    return balanced;
  }

  /** Writes a row for each contact of a circle that comes to rest; the hit has its row already. */
  private void report(boolean[] comes, ImpactRows log, MovingCircle... hit) {
    for (Contact c : contacts) {
      if (comesToRest(c, comes) && isHit(c, hit)) {
        log.setOutcome(ImpactRows.SETTLED);
      }
    }
    for (Contact c : contacts) {
      if (comesToRest(c, comes) && !isHit(c, hit)) {
        report(c, log);
        log.setOutcome(ImpactRows.SETTLED);
      }
    }
  }

  private static boolean comesToRest(Contact c, boolean... comes) {
    return comes[c.a] || (c.b != InelasticShock.OBSTACLE && comes[c.b]);
  }

  private boolean isHit(Contact c, MovingCircle... hit) {
    return c.other != null && isOneOf(members.get(c.a), hit) && isOneOf(c.other, hit);
  }

  private static boolean isOneOf(MovingCircle m, MovingCircle... hit) {
    return m == hit[0] || m == hit[1];
  }

  private void report(Contact c, ImpactRows log) {
    MovingCircle a = members.get(c.a);
    MovingCircle b = c.other;
    if (b == null) {
      response.report(a, c.touch, log);
    } else {
      pairs.report(a.id < b.id ? a : b, a.id < b.id ? b : a, log);
    }
  }

  /**
   * Frees all circles at rest that touch a circle which moves from now on, that those touch, and so
   * on.
   *
   * @return the circles that it frees, at the start of their new flights
   */
  public Collection<MovingCircle> free(MovingCircle first) {
    Map<Integer, MovingCircle> known = new LinkedHashMap<>();
    List<MovingCircle> all = new ArrayList<>();
    known.put(first.id, first);
    all.add(first);
    for (int k = 0; k < all.size(); k++) { // the list grows
      MovingCircle m = all.get(k);
      for (int id : circlesNear(m)) {
        MovingCircle other = known.containsKey(id) ? null : vicinity.copyOf(id);
        if (other != null && mayBeHeldBy(m, other) && Settling.touchInHeap(m, other) != null) {
          known.put(id, other);
          if (!other.isAt(first.t, first.tl)) { // else two could jam each other for ever
            other.leavePlace();
          }
          all.add(bringTo(first, other));
        }
      }
    }
    all.remove(0);
    for (MovingCircle m : all) {
      response.settling.fall(m);
      m.slowContacts = 0;
      m.last = MovingCircle.NOTHING;
    }
    return all;
  }

  /** Whether a circle is held, and nothing else crushed it but circle m. */
  private static boolean mayBeHeldBy(MovingCircle m, MovingCircle other) {
    boolean isFree = other.jam == null || other.jam.without(Codes.circle(m.id)) == null;
    return other.pinned && isFree;
  }

  private void gather(MovingCircle... hit) {
    members.clear();
    contacts.clear();
    numbers.clear();
    for (MovingCircle m : hit) {
      if (mayRest(m)) {
        add(m);
      }
    }
    for (int k = 0; k < members.size() && members.size() <= MOST; k++) { // the list grows
      addObstacles(k);
      addCircles(k);
    }
  }

  private int add(MovingCircle m) {
    numbers.put(m.id, members.size());
    members.add(m);
    return members.size() - 1;
  }

  private boolean mayRest(MovingCircle m) {
    return registry.mass(m.id) < INFINITE && response.settling.mayRest(m);
  }

  private void addObstacles(int k) {
    MovingCircle m = members.get(k);
    for (int code : vicinity.obstaclesNear(m)) {
      Touch touch = response.settling.touchInHeap(m, code);
      if (touch != null) {
        contacts.add(new Contact(k, InelasticShock.OBSTACLE, touch, null));
      }
    }
  }

  private void addCircles(int k) {
    MovingCircle m = members.get(k);
    for (int id : circlesNear(m)) {
      Integer known = numbers.get(id);
      if (known == null || known > k) { // else its own search added the contact
        MovingCircle other = known != null ? members.get(known) : bringTo(m, vicinity.copyOf(id));
        addCircle(k, other, known);
      }
    }
  }

  private void addCircle(int k, MovingCircle other, Integer known) {
    Touch touch = Settling.touchInHeap(members.get(k), other);
    if (touch == null) {
      return;
    }
    if (known != null || mayRest(other)) {
      contacts.add(new Contact(k, known != null ? known : add(other), touch, other));
    } else if (other.isGround()) {
      contacts.add(new Contact(k, InelasticShock.OBSTACLE, touch, other));
    }
  }

  /** The circles that may touch one, ascending. */
  private int[] circlesNear(MovingCircle m) {
    return IntStream.of(vicinity.circlesNear(m.id))
        .filter(id -> id != m.id && registry.meet(id, m.id) && !pairs.isSensor(id, m.id))
        .sorted()
        .distinct()
        .toArray();
  }

  /** Advances a circle to the time of another one. */
  private MovingCircle bringTo(MovingCircle time, MovingCircle m) {
    double dt = (time.t - m.t) + (time.tl - m.tl);
    m.advance(dt, 0, time.t, time.tl, dt == 0, obstacles);
    m.newFlight();
    return m;
  }
}
