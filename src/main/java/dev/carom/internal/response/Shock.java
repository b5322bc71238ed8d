// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.Part;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Contact without gravity, where there is no clock: all that touches a circle that is stuck, and
 * all that touches that, acts at once and without bounce. Of all velocities with which no contact
 * approaches, the new ones are the nearest to those before, in the mass norm: the inelastic shock
 * of J. J. Moreau (Unilateral contact and dry friction in finite freedom dynamics, 1988). So energy
 * never grows, and momentum is kept unless an obstacle takes it up.
 *
 * <p>What then approaches by no more than rounding is ignored, until an impact changes that. Two
 * cases have no such velocities, or some that take too long to find:
 *
 * <ul>
 *   <li>Moving obstacles or infinite masses leave a circle no way out. The one that they press most
 *       is <i>crushed</i>: it stops, and they pass over it.
 *   <li>Masses are so different that sweeps do not end. Then all circles go on as one, with the
 *       velocity of their common momentum; or they stop, if one of them touches an obstacle.
 * </ul>
 */
public final class Shock {

  /** Finds other circles in an engine. */
  public interface Others {

    /** Adds the circles that a circle can meet and that may be nearer to it than a distance. */
    void circlesNear(MovingCircle m, double reach, IntList into);

    /** A circle in flight, a copy. */
    MovingCircle copyOf(int slot);
  }

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final CircleRegistry registry;
  private final ObstacleTable obstacles;
  private final LoneContact.Nearby nearby;
  private final Others others;

  /** Circles in contact, at the time of the impact; those of infinite mass only stand there. */
  private final List<MovingCircle> bodies = new ArrayList<>();

  private final Set<Integer> slots = new HashSet<>();
  private final IntList near = new IntList();

  /** The pairs in contact, and whether each acted. */
  private final IntList contacts = new IntList();

  private boolean[] acted = new boolean[0];
  private double touch;
  private final Parts parts;
  private Members members = new Members(0);
  private ContactGraph graph;
  private NearPairs pairs;
  private final Sweeps sweeps = new Sweeps();
  private final HalfPlanes planes = new HalfPlanes();

  /** Velocities before and after, in units of 2^exponent. */
  private double[] before;

  private double[] after;
  private int exponent;

  /**
   * @param registry null for a circle of no world
   * @param others null if circles ignore each other
   */
  public Shock(
      CircleRegistry registry, ObstacleTable obstacles, LoneContact.Nearby nearby, Others others) {
    this.registry = registry;
    this.obstacles = obstacles;
    this.nearby = nearby;
    this.others = others;
    parts = new Parts(obstacles, registry, null);
  }

  /**
   * Gives new velocities to the given circles, to all that touch them, and so on. Each contact that
   * acts gets a row in the log.
   *
   * @param hit one circle that has just hit an obstacle, or two that have just hit each other, at
   *     the start of their new flights
   * @return the given circles and all that changed, at the start of their new flights
   */
  public Collection<MovingCircle> resolve(ImpactRows log, MovingCircle... hit) {
    Set<MovingCircle> changed = new LinkedHashSet<>(List.of(hit));
    gather(hit);
    list(hit[0]);
    boolean solved = Arrays.stream(hit).noneMatch(ImpactRule::isHopeless) && solve();
    while (!solved && crush(changed)) {
      solved = solve();
    }
    if (!solved) {
      joinAll(hit.length == 1);
    }
    for (int c = 0; c < contacts.size(); c++) {
      if (isHit(contacts.get(c), hit)) {
        log.addImpulse(impulse(contacts.get(c)));
      }
    }
    for (int c = 0; c < contacts.size(); c++) {
      if (acted[c] && !isHit(contacts.get(c), hit)) {
        report(contacts.get(c), log);
      }
    }
    change(changed);
    return changed;
  }

  /** Lets a circle meet again what crushed it, once all that did has left it. */
  public void forgetCrushersOf(MovingCircle m) {
    if (m.isCrushed() && !isCrushed(m)) {
      m.forgetCrushers();
    }
  }

  /** Whether something that crushed a circle is still upon it. */
  public boolean isCrushed(MovingCircle m) {
    boolean is = false;
    parts.update(m.tl);
    for (int entry : m.jam == null ? new int[0] : m.jam.entries()) {
      is |= IgnoreList.crushes(entry) && gap(m, IgnoreList.code(entry)) <= touchOf(m);
    }
    return is;
  }

  private double gap(MovingCircle m, int code) {
    if (!Codes.isCircle(code)) {
      return parts.distanceToCode(code, m.x, m.y, m.t) - m.radius;
    }
    MovingCircle other = broughtTo(m, others.copyOf(Codes.slot(code)));
    return Parts.length(m.x - other.x, m.y - other.y) - m.radius - other.radius;
  }

  /** Things touch if they are no further apart. */
  static double touchOf(MovingCircle m) {
    return ContactLaw.TOUCH * ImpactRule.size(m);
  }

  /** Advances a circle to the time of another one. */
  private MovingCircle broughtTo(MovingCircle time, MovingCircle m) {
    double dt = (time.t - m.t) + (time.tl - m.tl);
    m.advance(dt, 0, time.t, time.tl, dt == 0, obstacles);
    m.newFlight();
    return m;
  }

  // What touches.

  private void gather(MovingCircle... hit) {
    bodies.clear();
    slots.clear();
    touch = 0;
    for (MovingCircle m : hit) {
      forgetCrushersOf(m);
      double width = hit.length == 1 ? 0 : ContactLaw.PLACE * m.radius;
      touch = Math.max(touch, Math.max(width, touchOf(m)));
      add(m);
    }
    for (int k = 0; k < bodies.size() && others != null; k++) { // the list grows
      if (moves(bodies.get(k))) {
        addNear(bodies.get(k));
      }
    }
  }

  private void add(MovingCircle m) {
    slots.add(m.id);
    bodies.add(m);
  }

  private void addNear(MovingCircle m) {
    near.clear();
    others.circlesNear(m, touch, near);
    near.sort(0);
    for (int c = 0; c < near.size(); c++) {
      int slot = near.get(c);
      if (!slots.contains(slot) && !registry.isSensor(slot)) {
        MovingCircle other = broughtTo(m, others.copyOf(slot));
        if (gap(m, Codes.circle(slot)) <= touch) {
          forgetCrushersOf(other);
          add(other);
        }
      }
    }
  }

  /** Whether contact moves a circle: its mass is finite, and nothing passes over it. */
  private boolean moves(MovingCircle m) {
    return registry.mass(m.id) < INFINITE && !m.isCrushed();
  }

  /** Lists the contacts, with the graph and the geometry of contact under gravity. */
  private void list(MovingCircle time) {
    int n = bodies.size();
    if (graph == null || members.count < n) {
      members = new Members(2 * n);
      graph = new ContactGraph(members, parts, new Near(), 0, 0);
      before = new double[2 * members.count + 2];
      after = new double[2 * members.count + 2];
    }
    graph.clear();
    for (int k = 0; k < n; k++) {
      MovingCircle m = bodies.get(k);
      members.mode[k] = Members.AWAKE;
      members.radius[k] = m.radius;
      double inverse = n == 1 ? 1 : 1 / registry.mass(m.id); // all are alike among obstacles
      members.inverseMass[k] = m.isCrushed() ? 0 : inverse;
      members.filter[k] = m.filter;
      members.x[k] = m.x;
      members.y[k] = m.y;
      graph.enter(k);
    }
    parts.update(time.tl);
    graph.slack = touch;
    graph.list(before, time.t, 0);
    graph.measure(before, 0);
    pairs = graph.pairs;
    contacts.clear();
    for (int k = 0; k < pairs.size; k++) {
      if (pairs.felt[k] && pairs.gap[k] <= touch && !isPassedOver(k)) {
        contacts.add(k);
      }
    }
    acted = new boolean[contacts.size()];
    scale();
  }

  private final class Near implements ContactSurroundings {

    @Override
    public void membersNear(int k, double x, double y, double reach, IntList into) {
      for (int other = 0; other < bodies.size(); other++) {
        if (other != k && registry.meet(bodies.get(k).id, bodies.get(other).id)) {
          into.add(other);
        }
      }
    }

    @Override
    public void obstaclesNear(int k, double x, double y, double reach, double now, IntList into) {
      nearby.obstaclesNear(bodies.get(k), reach, now, into);
    }
  }

  /** Whether one party of a pair crushed the other one. Points do not touch, either. */
  private boolean isPassedOver(int k) {
    MovingCircle a = bodies.get(pairs.owner[k]);
    if (pairs.part[k] >= 0) {
      return a.jam != null && a.jam.isCrushedBy(parts.code(pairs.part[k], a.filter));
    }
    MovingCircle b = bodies.get(pairs.other[k]);
    return pairs.round[k] == 0
        || (a.jam != null && a.jam.isCrushedBy(Codes.circle(b.id)))
        || (b.jam != null && b.jam.isCrushedBy(Codes.circle(a.id)));
  }

  /** Takes the velocities, so that the largest component is in 1..2: nothing can overflow. */
  private void scale() {
    double largest = 0;
    for (MovingCircle m : bodies) {
      largest = Math.max(largest, Math.max(Math.abs(m.vx), Math.abs(m.vy)));
    }
    for (int c = 0; c < contacts.size(); c++) {
      int part = pairs.part[contacts.get(c)];
      if (part >= 0) {
        MovingCircle m = bodies.get(pairs.owner[contacts.get(c)]);
        double ux = parts.velocityX(part, m.y);
        double uy = parts.velocityY(part, m.x);
        largest = Math.max(largest, Math.max(Math.abs(ux), Math.abs(uy)));
      }
    }
    exponent = largest == 0 ? 0 : Math.getExponent(largest);
    for (int k = 0; k < bodies.size(); k++) {
      before[2 * k] = Math.scalb(bodies.get(k).vx, -exponent);
      before[2 * k + 1] = Math.scalb(bodies.get(k).vy, -exponent);
    }
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      pairs.impulse[k] = 0;
      pairs.drift[k] = Math.scalb(pairs.drift[k], -exponent);
    }
  }

  // The solution.

  private double weight(int k) {
    return k < bodies.size() ? members.inverseMass[k] : 0;
  }

  private double weightOf(int pair) {
    return weight(pairs.owner[pair]) + weight(pairs.other[pair]);
  }

  /** Finds the velocities; false if some contact still approaches. */
  private boolean solve() {
    System.arraycopy(before, 0, after, 0, before.length);
    int[] free = IntStream.range(0, bodies.size()).filter(k -> weight(k) > 0).toArray();
    if (free.length == 0 || isSolved()) {
      clearImpulses();
      return true;
    }
    if (free.length == 1) {
      return solveAlone(free[0]);
    }
    sweep();
    return isSolved();
  }

  /** Whether no contact approaches by more than rounding. */
  private boolean isSolved() {
    boolean solved = true;
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      solved &= weightOf(k) == 0 || pairs.opening(after, k) >= -ContactLaw.ROUNDED;
    }
    return solved;
  }

  private void sweep() {
    sweeps.clear(contacts.size());
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      int i = pairs.owner[k];
      int j = pairs.other[k];
      if (weightOf(k) > 0) {
        int second = j < bodies.size() ? graph.rank[j] : graph.awake;
        double x = pairs.nx[k];
        double y = pairs.ny[k];
        sweeps.add(graph.rank[i], second, x, y, pairs.drift[k], weight(i), weight(j), 0);
      }
    }
    long visits = sweeps.visits;
    sweeps.load(graph.order, graph.awake, before);
    sweeps.solve(ContactLaw.ROUNDED / 4, ContactLaw.MOST_SWEEPS);
    sweeps.store(graph.order, after);
    ExactBudget.addRelaxations((int) (sweeps.visits - visits));
    int s = 0;
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      if (weightOf(k) > 0) {
        pairs.impulse[k] = sweeps.impulse(s++);
        acted[c] |= pairs.impulse[k] * weightOf(k) > ContactLaw.ROUNDED;
      } else {
        pairs.impulse[k] = 0; // of a crushed circle
      }
    }
  }

  private void clearImpulses() {
    for (int c = 0; c < contacts.size(); c++) {
      pairs.impulse[contacts.get(c)] = 0;
    }
  }

  /** The impulse of a contact: a circle alone among obstacles was solved as of mass 1. */
  private double impulse(int k) {
    double unit = bodies.size() > 1 || registry == null ? 1 : registry.mass(bodies.get(0).id);
    return Math.scalb(pairs.impulse[k] * unit, exponent);
  }

  /** One circle among things that it does not move: the velocity nearest to its own. */
  private boolean solveAlone(int i) {
    planes.clear();
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      if (weightOf(k) > 0) {
        double sign = pairs.owner[k] == i ? 1 : -1;
        double x = sign * pairs.nx[k];
        double y = sign * pairs.ny[k];
        int j = sign > 0 ? pairs.other[k] : pairs.owner[k];
        planes.add(x, y, pairs.drift[k] + before[2 * j] * x + before[2 * j + 1] * y);
        acted[c] |= pairs.opening(before, k) < -ContactLaw.ROUNDED;
      }
    }
    boolean is = planes.nearest(before[2 * i], before[2 * i + 1], ContactLaw.ROUNDED);
    after[2 * i] = planes.x;
    after[2 * i + 1] = planes.y;
    if (is) {
      creditAlone(i);
    }
    return is;
  }

  private void creditAlone(int i) {
    int plane = 0;
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      boolean acts = weightOf(k) > 0;
      pairs.impulse[k] =
          acts ? planes.multiplier(plane++, before[2 * i], before[2 * i + 1]) / weight(i) : 0;
    }
  }

  /** Stops the circle that something that moves presses most, and lets all such pass over it. */
  private boolean crush(Set<MovingCircle> changed) {
    int most = Index.NONE;
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      if (isPress(k) && (most == Index.NONE || pairs.impulse[k] > pairs.impulse[most])) {
        most = k;
      }
    }
    if (most == Index.NONE) {
      return false;
    }
    int i = pressed(most);
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      if (isPress(k) && pressed(k) == i) {
        acted[c] = true;
        MovingCircle m = bodies.get(i);
        m.jam = IgnoreList.crushedBy(m.jam, codeOf(k, i));
      }
    }
    members.inverseMass[i] = 0;
    before[2 * i] = 0;
    before[2 * i + 1] = 0;
    changed.add(bodies.get(i));
    return true;
  }

  /** Whether a pair presses a circle against something infinite that moves. */
  private boolean isPress(int k) {
    int part = pairs.part[k];
    return weightOf(k) > 0
        && (part >= 0
            ? parts.moves(part)
            : registry.mass(bodies.get(pairs.owner[k]).id) == INFINITE
                || registry.mass(bodies.get(pairs.other[k]).id) == INFINITE);
  }

  private int pressed(int k) {
    return weight(pairs.owner[k]) > 0 ? pairs.owner[k] : pairs.other[k];
  }

  /** The code of the party of a pair that is not circle i. */
  private int codeOf(int k, int i) {
    if (pairs.part[k] >= 0) {
      return parts.code(pairs.part[k], bodies.get(i).filter);
    }
    return Codes.circle(bodies.get(pairs.owner[k] == i ? pairs.other[k] : pairs.owner[k]).id);
  }

  /** Gives all the velocity of their common momentum, or stops them if one is held. */
  private void joinAll(boolean hitsObstacle) {
    boolean held = hitsObstacle;
    clearImpulses();
    for (int c = 0; c < contacts.size(); c++) {
      int k = contacts.get(c);
      held |= weightOf(k) > 0 && (weight(pairs.owner[k]) == 0 || weight(pairs.other[k]) == 0);
      acted[c] |= weightOf(k) > 0;
    }
    double mass = 0;
    double vx = 0;
    double vy = 0;
    for (int k = 0; k < bodies.size(); k++) {
      if (weight(k) > 0) {
        double own = 1 / weight(k);
        mass += own;
        // The mean of the velocities so far, weighted by mass.
        vx = (1 - own / mass) * vx + own / mass * before[2 * k];
        vy = (1 - own / mass) * vy + own / mass * before[2 * k + 1];
      }
    }
    for (int k = 0; k < bodies.size(); k++) {
      if (weight(k) > 0) {
        after[2 * k] = held ? 0 : vx;
        after[2 * k + 1] = held ? 0 : vy;
      }
    }
  }

  // The result.

  /** Whether a pair is the impact under resolution, which has its row in the log already. */
  private boolean isHit(int k, MovingCircle... hit) {
    MovingCircle a = bodies.get(pairs.owner[k]);
    return hit.length == 1
        ? a == hit[0] && codeOf(k, pairs.owner[k]) == hit[0].last
        : Math.max(pairs.owner[k], pairs.other[k]) == 1;
  }

  /** Writes a row of a contact; of two circles the lower one first. */
  private void report(int k, ImpactRows log) {
    int part = pairs.part[k];
    int i = pairs.owner[k];
    int j = pairs.other[k];
    boolean turns = part < 0 && bodies.get(j).id < bodies.get(i).id;
    int first = turns ? j : i;
    MovingCircle m = bodies.get(first);
    int code = codeOf(k, first);
    boolean isConcentric = pairs.nx[k] == 0 && pairs.ny[k] == 0; // along +x, as a separation
    double nx = isConcentric ? 1 : turns ? -pairs.nx[k] : pairs.nx[k];
    double ny = turns ? -pairs.ny[k] : pairs.ny[k];
    int feature = part < 0 ? Part.CIRCLE : parts.feature(part, m.filter);
    double speed = Math.scalb(pairs.opening(before, k), exponent);
    double d = m.radius + (part < 0 ? 0 : pairs.gap[k]);
    log.addJammed(m, code, feature, d, nx, ny, speed);
    log.addImpulse(impulse(k));
  }

  private void change(Set<MovingCircle> changed) {
    for (int c = 0; c < contacts.size(); c++) {
      stopApproach(contacts.get(c));
    }
    for (int k = 0; k < bodies.size(); k++) {
      boolean isNoise = Math.abs(after[2 * k]) + Math.abs(after[2 * k + 1]) < ContactLaw.ROUNDED;
      MovingCircle m = bodies.get(k);
      double vx = isNoise ? 0 : Math.scalb(after[2 * k], exponent) + 0.0; // 0 for -0
      double vy = isNoise ? 0 : Math.scalb(after[2 * k + 1], exponent) + 0.0;
      boolean mayChange = weight(k) > 0 || changed.contains(m);
      if (mayChange && (m.vx != vx || m.vy != vy)) {
        m.vx = vx;
        m.vy = vy;
        m.last = MovingCircle.NOTHING;
        m.ignoreCirclesOnly();
        changed.add(m);
      }
    }
    for (int c = 0; c < contacts.size(); c++) {
      ignore(contacts.get(c), changed);
    }
  }

  /** Stops the rest of an approach to an obstacle: that will be ignored, and the rest add up. */
  private void stopApproach(int k) {
    int i = 2 * pairs.owner[k];
    double opening = pairs.opening(after, k);
    if (pairs.part[k] >= 0 && weightOf(k) > 0 && opening < 0) {
      after[i] -= opening * pairs.nx[k];
      after[i + 1] -= opening * pairs.ny[k];
    }
  }

  /** Two that part or approach by rounding ignore each other. */
  private void ignore(int k, Set<MovingCircle> changed) {
    int part = pairs.part[k];
    MovingCircle a = bodies.get(pairs.owner[k]);
    MovingCircle b = part < 0 ? bodies.get(pairs.other[k]) : null;
    double ux = b == null ? parts.velocityX(part, a.y) : b.vx;
    double uy = b == null ? parts.velocityY(part, a.x) : b.vy;
    double opening = (a.vx - ux) * pairs.nx[k] + (a.vy - uy) * pairs.ny[k];
    double speeds = Math.abs(a.vx) + Math.abs(a.vy) + Math.abs(ux) + Math.abs(uy);
    boolean moves = (a.vx != ux || a.vy != uy) && weightOf(k) > 0;
    boolean turns = part >= 0 && parts.turns(part); // it comes nearer again
    if (!moves || turns || !ImpactRule.isFaint(opening, speeds)) {
      return;
    }
    for (int code : b == null ? parts.codes(part) : new int[] {Codes.circle(b.id)}) {
      a.jam = IgnoreList.with(a.jam, code);
    }
    changed.add(a);
    if (b != null) {
      b.jam = IgnoreList.with(b.jam, Codes.circle(a.id));
      changed.add(b);
    }
  }
}
