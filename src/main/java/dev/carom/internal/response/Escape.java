// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * Lets a circle that falls, and is stuck between things of which one moves, leave each of them by
 * the {@linkplain Settling#LEAST_HOP least speed}. Circles of finite mass that it touches give way,
 * and those that they touch, and so on. If no velocities do that, the circle is squeezed.
 */
final class Escape {

  /** How far from a circle things may be to count, in radii: twice a place of its impacts. */
  private static final double REACH = 2 * StuckRule.FALLING_PLACE;

  /** So many circles give way at most. */
  private static final int MOST = 1000;

  /** No circle gets more than so many times the largest speed before. */
  private static final double MOST_GAIN = 8;

  /** Beside what presses on it, a circle takes no more than so many least speeds. */
  private static final double MOST_LEAST = 4;

  /**
   * Less of it lets nobody out: the hops would be 2^-10 as high, and things that press come nearer.
   */
  private static final double LEAST_SHARE = 0x1p-5;

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /** Stands for something that keeps its velocity in place of the second circle of a contact. */
  private static final int FIXED = -1;

  /**
   * A touch of member a, with member b or something FIXED.
   *
   * @param other the circle that it touches; null for an obstacle
   * @param ux,uy the velocity of what is fixed
   * @param least the least speed at which the two leave each other
   */
  private record Contact(
      int a, int b, Touch touch, MovingCircle other, double ux, double uy, double least) {

    boolean isWithMoving() {
      return b == FIXED && (ux != 0 || uy != 0);
    }
  }

  private final ObstacleTable obstacles;
  private final Settling settling;

  /** Knows the circles near one; null as long as no circles meet. */
  private ContactCluster circles;

  /** The codes of obstacles that a circle may touch, ascending. */
  private final Function<MovingCircle, int[]> near;

  /** The circles of finite mass that touch each other; first those that hit something. */
  private final List<MovingCircle> members = new ArrayList<>();

  /** The number of each member, by the circle. */
  private final Map<Integer, Integer> numbers = new HashMap<>();

  private final List<Contact> contacts = new ArrayList<>();

  /** The circles that gave way, at the start of their new flights. */
  private List<MovingCircle> yielded = List.of();

  Escape(ObstacleTable obstacles, Settling settling, Function<MovingCircle, int[]> near) {
    this.obstacles = obstacles;
    this.settling = settling;
    this.near = near;
  }

  /** Takes the cluster that knows the circles near one. */
  void ask(ContactCluster cluster) {
    circles = cluster;
  }

  /** The circles that gave way since the last call, other than those that hit something. */
  List<MovingCircle> takeYielded() {
    List<MovingCircle> taken = yielded;
    yielded = List.of();
    return taken;
  }

  /**
   * Gives a circle, and those that give way to it, the velocities nearest to their own with which
   * they leave all that they touch. Contacts that make others give way get rows in the log.
   *
   * @param hit the circle that is stuck, at the start of a new flight; then the circle that it hit,
   *     if it hit one
   * @return whether there is a way out. If not, nothing has changed. There is none if nothing that
   *     they touch moves, or if the velocities are too large, or differ from 0 by rounding only
   */
  boolean escapes(ImpactRows log, MovingCircle... hit) {
    gather(hit);
    return members.size() <= MOST
        && contacts.stream().anyMatch(Contact::isWithMoving)
        && escape(log, hit);
  }

  /** Gives the members their new velocities; false if there are none. */
  private boolean escape(ImpactRows log, MovingCircle... hit) {
    boolean[] acts = new boolean[contacts.size()];
    InelasticShock pressing = shock(acts);
    double faint = faintApproach();
    if (!pressing.resolve(faint) || squeezesOut(pressing)) {
      return false;
    }
    setActing(acts, pressing);
    InelasticShock leaving = shock(acts);
    double share = leaving.resolve(faint) ? share(pressing, leaving) : 0;
    if (share < LEAST_SHARE || !contacts.stream().allMatch(c -> share * c.least > rounding(c))) {
      return false;
    }
    setActing(acts, leaving);
    for (int k = 0; k < acts.length; k++) {
      if (acts[k]) {
        report(contacts.get(k), log, hit);
      }
    }
    leave(pressing, leaving, share, hit);
    return true;
  }

  /** Marks the contacts that gave an impulse in a shock. */
  private static void setActing(boolean[] acts, InelasticShock shock) {
    for (int k = 0; k < acts.length; k++) {
      acts[k] |= shock.acted(k);
    }
  }

  /** Gives all members a mean of their velocities after two shocks. */
  private void leave(
      InelasticShock pressing, InelasticShock leaving, double share, MovingCircle... hit) {
    yielded = new ArrayList<>();
    for (int i = 0; i < members.size(); i++) {
      double vx = between(pressing.vx(i), leaving.vx(i), share);
      double vy = between(pressing.vy(i), leaving.vy(i), share);
      leave(members.get(i), vx, vy, hit);
    }
  }

  /** Writes a contact that acted, unless the log has a row for the impact of its circle. */
  private void report(Contact c, ImpactRows log, MovingCircle... hit) {
    List<MovingCircle> known = List.of(hit);
    MovingCircle a = members.get(c.a);
    if (!known.contains(a) || (c.b != FIXED && !known.contains(c.other))) {
      circles.report(a, c.touch, c.other, log);
    }
  }

  /** Gives a member its new velocity. One that keeps its velocity goes on as before. */
  private void leave(MovingCircle m, double vx, double vy, MovingCircle... hit) {
    boolean changes = m.vx != vx || m.vy != vy;
    if (changes || m == hit[0]) {
      m.vx = vx;
      m.vy = vy;
      m.leavePlace();
      m.slowContacts = 0;
      settling.fall(m);
    }
    if (changes && !List.of(hit).contains(m)) {
      m.last = MovingCircle.NOTHING; // it may meet again what it hit before
      yielded.add(m);
    }
  }

  /** An approach that is small beside each of the least speeds. */
  private double faintApproach() {
    return contacts.stream().mapToDouble(Contact::least).min().orElse(0) / 64;
  }

  /** Whether a circle would leave sideways, much faster than anything that presses on it. */
  private boolean squeezesOut(InelasticShock pressing) {
    double most = MOST_GAIN * pressing.speed();
    return IntStream.range(0, members.size())
        .anyMatch(i -> Math.abs(pressing.vx(i)) > most || Math.abs(pressing.vy(i)) > most);
  }

  /**
   * How much of the least speeds the circles take: less than 1 if no circle could take all of it
   * without {@link #MOST_LEAST}. Any mean of both velocities leaves no contact approaching.
   */
  private double share(InelasticShock pressing, InelasticShock leaving) {
    double most = 0;
    for (int i = 0; i < members.size(); i++) {
      double x = leaving.vx(i) - pressing.vx(i);
      double y = leaving.vy(i) - pressing.vy(i);
      most =
          Math.max(most, StrictMath.hypot(x, y) / settling.leastSpeed(2 * members.get(i).radius));
    }
    return most <= MOST_LEAST ? 1 : MOST_LEAST / most;
  }

  private static double between(double from, double to, double share) {
    return share == 1 ? to : fma(share, to - from, from);
  }

  /** The shock after which circles leave some of what they touch by the least speed. */
  private InelasticShock shock(boolean... leaves) {
    InelasticShock shock = new InelasticShock(members.size() + contacts.size(), contacts.size());
    for (int i = 0; i < members.size(); i++) {
      MovingCircle m = members.get(i);
      shock.setCircle(i, m.vx, m.vy, circles == null ? 1 : circles.ownMass(m));
    }
    for (int k = 0; k < contacts.size(); k++) {
      Contact c = contacts.get(k);
      int b = c.b == FIXED ? members.size() + k : c.b;
      if (c.b == FIXED) {
        shock.setCircle(b, c.ux, c.uy, INFINITE);
      }
      shock.addContact(c.a, b, c.touch.nx(), c.touch.ny(), leaves[k] ? c.least : 0);
    }
    return shock;
  }

  /** The rounding of the velocities in a contact. */
  private double rounding(Contact c) {
    MovingCircle a = members.get(c.a);
    double ux = c.b == FIXED ? c.ux : members.get(c.b).vx;
    double uy = c.b == FIXED ? c.uy : members.get(c.b).vy;
    double speeds = Math.abs(a.vx) + Math.abs(a.vy) + Math.abs(ux) + Math.abs(uy);
    return Settling.ROUNDING * speeds;
  }

  private void gather(MovingCircle... hit) {
    members.clear();
    numbers.clear();
    contacts.clear();
    for (MovingCircle m : hit) {
      if (givesWay(m)) {
        add(m);
      }
    }
    for (int k = 0; k < members.size() && members.size() <= MOST; k++) { // the list grows
      addObstacles(k);
      addCircles(k, hit);
    }
  }

  private int add(MovingCircle m) {
    numbers.put(m.id, members.size());
    members.add(m);
    return members.size() - 1;
  }

  private boolean givesWay(MovingCircle m) {
    return !m.isCrushed() && (circles == null || !circles.isInfinite(m));
  }

  private void addObstacles(int k) {
    MovingCircle m = members.get(k);
    for (int code : near.apply(m)) {
      boolean isSolid = settling.isSolid(m, code);
      Touch touch = isSolid ? Touch.of(m, obstacles, code, REACH * m.radius) : null;
      if (touch != null) {
        double least =
            settling.leastSpeed(m.radius + (Codes.isWall(code) ? 0 : obstacles.radius(code)));
        double ux = obstacles.ux(code);
        contacts.add(new Contact(k, FIXED, touch, null, ux, obstacles.uy(code), least));
      }
    }
  }

  private void addCircles(int k, MovingCircle... hit) {
    if (circles != null) {
      for (MovingCircle copy : circles.circlesNear(members.get(k))) {
        addCircle(k, copy, hit);
      }
    }
  }

  private void addCircle(int k, MovingCircle copy, MovingCircle... hit) {
    MovingCircle m = members.get(k);
    Integer known = numbers.get(copy.id);
    if (known != null && known < k) {
      return; // its own search added this contact
    }
    MovingCircle other = known != null ? members.get(known) : currentOf(copy, hit);
    Touch touch = Touch.of(m, other, REACH * Math.max(m.radius, other.radius));
    if (touch != null) {
      double least = settling.leastSpeed(m.radius + other.radius);
      contacts.add(new Contact(k, number(other), touch, other, other.vx, other.vy, least));
    }
  }

  /** The number of a circle among the members, which it joins if it gives way; or FIXED. */
  private int number(MovingCircle other) {
    Integer known = numbers.get(other.id);
    if (known != null) {
      return known;
    }
    return givesWay(other) ? add(other) : FIXED;
  }

  /** One of those that hit each other, if a copy is of that one; else the copy. */
  private MovingCircle currentOf(MovingCircle copy, MovingCircle... hit) {
    for (MovingCircle m : hit) {
      if (m.id == copy.id) {
        return m;
      }
    }
    circles.forgetCrushersOf(copy);
    return copy;
  }
}
