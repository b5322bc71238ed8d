// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactRow;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.Part;
import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Contact under gravity, on its own clock. Circles that gravity presses together would make
 * infinitely many impacts. So they become <i>members</i>, which fly straight within a tick, and
 * have two velocities:
 *
 * <ul>
 *   <li>the <i>momentum</i> v is what physics says. It changes at ticks only: {@code v += g tau}
 *       and the impulses of contacts, see {@link Momenta}. It belongs to the middle of a tick;
 *   <li>the <i>flight</i> u is the way until the next tick: the momentum, made safe, see {@link
 *       Flights}.
 * </ul>
 *
 * <p>A tick, in this order: circles that nothing holds leave; some freeze or wake, see {@link
 * Rest}; new momenta; new flights. A tick may have any length up to tau, so whatever changes in
 * mid-tick ends it.
 */
public final class ContactCore {

  private final Members members;
  private final Parts parts;
  private final ContactHost host;
  private final ContactGraph graph;
  private final Momenta momenta;
  private final Flights flights;
  private final Newcomers newcomers;
  private final Rest rest;
  private final Squeeze squeeze;
  private final ContactClock clock;
  private final IntList near = new IntList();
  private final IntList turning = new IntList();
  private final int[] bearing;
  private final int[] only;
  private final Groups crowds;
  private final boolean[] isHeld;
  private final double gx;
  private final double gy;
  private final double g;

  /** The time to which all momenta belong, and that of the next ones. */
  private double momentTime;

  private double moment;
  private int present;
  private int jammed;
  private int cuts;

  /** The inverse mass of the lightest circle, as far as it counts. */
  private double mostWeight;

  /**
   * Rows of circles that are restored, by slots; and whether pairs have yet to find their parts.
   */
  private final double[][] rows;

  /** Awake ones among these. */
  private final IntList ranked = new IntList();

  private boolean isRestored;

  /**
   * @param room one more than the largest slot of a circle
   */
  public ContactCore(
      ObstacleTable obstacles,
      CircleRegistry registry,
      CircleTable circles,
      ContactHost host,
      int room,
      double gx,
      double gy) {
    this.host = host;
    this.gx = gx;
    this.gy = gy;
    g = Math.sqrt(gx * gx + gy * gy);
    members = new Members(room);
    Arrays.fill(members.pull, g);
    parts = new Parts(obstacles, registry, circles);
    clock = new ContactClock(g);
    graph = new ContactGraph(members, parts, host, gx, gy);
    momenta = new Momenta(members, graph, parts);
    flights = new Flights(members, graph, momenta, gx, gy);
    newcomers = new Newcomers(members, parts, host, gx, gy);
    rest = new Rest(members, graph, parts, host);
    squeeze = new Squeeze(members, graph, momenta, parts, gx, gy);
    bearing = new int[room];
    rows = new double[room][];
    only = new int[room];
    crowds = new Groups(room);
    isHeld = new boolean[room];
  }

  // Questions.

  /** The time of the next tick; infinite if there is none. */
  public double nextTick() {
    return graph.awake > 0 || jammed > 0 ? clock.end : Double.POSITIVE_INFINITY;
  }

  /** The number of members. */
  public int present() {
    return present;
  }

  public boolean isMember(int i) {
    return i < members.count && members.mode[i] != Members.OUT;
  }

  public boolean isAwake(int i) {
    return i < members.count && members.isAwake(i);
  }

  /** Whether contact keeps a member from what moves: it is awake, or something passes over it. */
  public boolean isKeptApart(int i) {
    return isMember(i) && (members.isAwake(i) || members.jammed[i]);
  }

  /** Whether two circles are no business of events: members, of which at most one rests. */
  public boolean areMembers(int i, int j) {
    return isMember(i)
        && isMember(j)
        && (members.isAwake(i)
            || members.isAwake(j)
            || (members.ux[i] == members.ux[j] && members.uy[i] == members.uy[j]));
  }

  /** The momentum of a member, by its mass, at a time. */
  public double velocityX(int i, double time) {
    return members.vx[i] + members.rise[i] * gx * (time - momentTime);
  }

  public double velocityY(int i, double time) {
    return members.vy[i] + members.rise[i] * gy * (time - momentTime);
  }

  /** Puts a circle where a member began its flight. */
  public void place(int i, MovingCircle m) {
    m.x = members.x[i];
    m.y = members.y[i];
    m.t = members.since[i];
    m.tl = 0;
  }

  /** Puts a circle on the flight of a member. */
  public void put(int i, MovingCircle m) {
    place(i, m);
    m.join(members.jammed[i] ? MovingCircle.JAMMED : members.mode[i]);
    m.vx = members.ux[i];
    m.vy = members.uy[i];
    m.px = velocityX(i, m.t);
    m.py = velocityY(i, m.t);
    m.ax = members.rise[i] * gx;
    m.ay = members.rise[i] * gy;
    m.newFlight();
  }

  /** Lets a circle fall freely on from where it was a member; see {@link ContactHost#frees}. */
  public void free(int i, double vx, double vy, int side, MovingCircle m) {
    place(i, m);
    m.vx = vx;
    m.vy = vy;
    m.fall(gx, gy);
    m.landing = side;
    m.settled = true;
    m.last = MovingCircle.NOTHING;
    m.newFlight();
  }

  /** How much work was done so far, in visits of contacts. */
  public long work() {
    return momenta.sweeps.visits;
  }

  // Joining.

  /** Sets what a circle is, before it joins. */
  public void describe(int i, double radius, double mass, double restitution, long filter) {
    members.radius[i] = radius;
    members.inverseMass[i] = 1 / mass;
    members.restitution[i] = restitution;
    members.filter[i] = filter;
  }

  /**
   * Makes a circle a member, where its flight begins.
   *
   * @param partner the member that it met, or NONE
   */
  public void join(int i, int partner, MovingCircle m) {
    double now = m.t;
    look(now);
    members.x[i] = m.x;
    members.y[i] = m.y;
    members.since[i] = now;
    members.vx[i] = m.vx;
    members.vy[i] = m.vy;
    start(i, now);
    present++;
    members.mode[i] = Members.AWAKE;
    double rise = 1;
    if (m.gx != gx || m.gy != gy) {
      members.fly(i, m.vx, m.vy);
      members.follow(i, gx, gy, clock.kick());
      rise = members.rise[i];
    }
    members.vx[i] = m.vx + rise * gx * (momentTime - now);
    members.vy[i] = m.vy + rise * gy * (momentTime - now);
    members.ax[i] = m.gx;
    members.ay[i] = m.gy;
    members.rise[i] = rise;
    members.turned[i] = m.gx == gx && m.gy == gy ? 0 : Members.SHOWN;
    members.fresh[i] = true;
    newcomers.momentTime = momentTime;
    if (partner >= 0) {
      members.fresh[partner] = true;
    }
    double half = (clock.end - now) / 2;
    if (!newcomers.fly(i, m.vx + m.gx * half, m.vy + m.gy * half, now, clock)) {
      clock.cut(now);
    }
    rest.watch(i, now);
    graph.enter(i);
    host.flies(i);
  }

  /** Starts the clock, or makes it finer, for a circle. */
  private void start(int i, double now) {
    members.pull[i] = pull(i, now);
    double tick = ContactClock.ownTick(members.radius[i], members.pull[i]);
    if (graph.awake == 0 && jammed == 0) {
      clock.pull = members.pull[i];
      // Where the pull underflows it leaves at once: else what turns would pass over it.
      clock.start(tick < Double.POSITIVE_INFINITY ? tick : Math.ulp(now), now);
      momentTime = now;
      newcomers.longest = 0;
      cuts = 0;
    } else {
      clock.pull = Math.max(clock.pull, members.pull[i]);
      clock.refine(tick, now);
    }
  }

  /**
   * How strongly a circle is pulled, see {@link ContactClock}: by gravity, or by what turns near
   * it. If nothing does, a tick is as long as if the fastest thing flew round a curve of its
   * radius.
   */
  private double pull(int i, double now) {
    double vx = members.vx[i];
    double vy = members.vy[i];
    double r = members.radius[i];
    double most = g;
    turning.clear();
    if (parts.areTurning()) {
      parts.near(members, i, host, ContactLaw.MARGIN * r, now, turning);
    }
    double x = members.xAt(i, now);
    double y = members.yAt(i, now);
    for (int c = 0; c < turning.size(); c++) {
      int p = turning.get(c);
      if (parts.turns(p) && parts.touches(p, r, members.filter[i], x, y, 0, 0)) {
        double bend = parts.bend(p, r, x, y, vx, vy, parts.normalX, parts.normalY);
        most = Math.max(most, bend);
      }
    }
    double fastest = Math.max(vx * vx + vy * vy, parts.fastest() * parts.fastest());
    return most > 0 ? most : fastest / r;
  }

  /** The same for all that are awake, from the list of pairs. */
  private void findPulls() {
    if (!parts.areTurning() && clock.pull == g) {
      return;
    }
    Arrays.fill(members.pull, g);
    NearPairs p = graph.pairs;
    clock.pull = g;
    for (int k = 0; k < p.size; k++) {
      int part = p.part[k];
      if (part >= 0 && p.felt[k] && parts.turns(part)) {
        int i = p.owner[k];
        double r = members.radius[i];
        double vx = members.vx[i];
        double vy = members.vy[i];
        double x = members.x[i];
        double y = members.y[i];
        double bend = parts.bend(part, r, x, y, vx, vy, p.nx[k], p.ny[k]);
        members.pull[i] = Math.max(members.pull[i], bend);
        clock.pull = Math.max(clock.pull, bend);
      }
    }
  }

  /** Brings the parts to a time. */
  private void look(double now) {
    if (parts.isStale()) {
      parts.update();
      graph.forget();
    }
    parts.moveTo(now);
    if (isRestored) {
      isRestored = false;
      graph.findParts(now);
    }
  }

  // A tick.

  /** Ends the present tick, and begins the next one. */
  public void tick(double now) {
    look(now);
    loadAll(now);
    if (!graph.isValid) {
      settle(now);
    }
    graph.measure(momenta.v, clock.tau);
    findPulls();
    boolean isWhole = now >= clock.due; // after a cut, momenta are not yet those of what is there
    boolean changed = isWhole && leave(now);
    changed |= rest.wake(now, gx, gy, clock.tau);
    changed |= isWhole && rest.freeze(now, clock);
    changed |= unjam(now);
    if (changed || !graph.covers(momenta.v, now, clock.tau)) {
      settle(now);
    }
    begin(now);
  }

  private void begin(double now) {
    if (graph.awake == 0) {
      clock.start(clock.tau, now);
      return;
    }
    findPulls();
    double tick = shortestTick();
    if (now >= clock.due) {
      cuts = Math.max(0, cuts - 1);
    }
    clock.start(tick, now);
    double h = Math.min(clock.due - now, Math.scalb(clock.tau, -2 * cuts));
    while (!attempt(now, h)) {
      h = cut(now, h);
    }
    squeeze.end();
    finish();
  }

  /** The shortest tick of all that are awake; the last one where nothing pulls any of them. */
  private double shortestTick() {
    double tick = Double.POSITIVE_INFINITY;
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[k];
      tick = Math.min(tick, ContactClock.ownTick(members.radius[i], members.pull[i]));
    }
    return tick < Double.POSITIVE_INFINITY ? tick : clock.tau;
  }

  /** Finds momenta and flights for a tick of length h; false if there are no safe flights. */
  private boolean attempt(double now, double h) {
    clock.end = now + h;
    squeeze.begin();
    kickAll(now, h);
    if (parts.areMoving()) {
      squeeze.widen(flights.drive);
    }
    momenta.solve(h, clock, gx, gy);
    return fly(now, h);
  }

  /**
   * Goes on where no flights are safe: wakes what is in the way, cuts the tick, at last lets
   * something pass over a circle. Returns the length of the tick to try next.
   */
  private double cut(double now, double h) {
    loadAll(now);
    int j = squeeze.blocked(flights.u, h);
    if (j >= 0) {
      rest.wakeAll(j, now);
      loadAll(now);
      return h;
    }
    cuts++;
    if (cuts <= ContactLaw.TRIES) {
      return h / 4;
    }
    jam(now);
    return clock.due - now;
  }

  private void jam(double now) {
    NearPairs p = graph.pairs;
    int k = Math.max(0, squeeze.pressed(flights.u, clock.due - now));
    int i = p.owner[k];
    int part = p.part[k];
    long filter = members.filter[i];
    int code = part < 0 ? Codes.circle(p.other[k]) : parts.code(part, filter);
    int feature = part < 0 ? Part.CIRCLE : parts.feature(part, filter);
    host.jammed(i, code, feature, p.nx[k], p.ny[k]);
    cuts = 0;
    members.mode[i] = Members.FROZEN;
    members.jammed[i] = true;
    jammed++;
    members.frameX[i] = 0;
    members.frameY[i] = 0;
    members.fly(i, 0, 0);
    members.rest(i);
    host.flies(i);
    settle(now);
  }

  /** Frees jammed circles that nothing overlaps any more. */
  private boolean unjam(double now) {
    boolean any = false;
    for (int i = 0; i < members.count && jammed > 0; i++) {
      if (members.jammed[i] && !isOverlapped(i, now)) {
        members.jammed[i] = false;
        jammed--;
        rouse(i, now);
        any = true;
      }
    }
    return any;
  }

  /** Whether a part overlaps a circle, or is about to. */
  private boolean isOverlapped(int i, double now) {
    double soon = 2 * parts.fastest() * clock.tau;
    near.clear();
    parts.near(members, i, host, soon, now, near);
    boolean is = false;
    for (int c = 0; c < near.size() && !is; c++) {
      int p = near.get(c);
      double r = members.radius[i];
      is =
          parts.distanceTo(p, members.x[i], members.y[i]) < r
              || (parts.moves(p)
                  && parts.touches(p, r, members.filter[i], members.x[i], members.y[i], 0, 0)
                  && parts.speed(p, members.x[i], members.y[i]) > 0);
    }
    return is;
  }

  private void loadAll(double now) {
    findMostWeight();
    for (int k = 0; k < graph.awake; k++) {
      load(graph.order[k], now);
    }
  }

  private void findMostWeight() {
    double least = Double.POSITIVE_INFINITY;
    for (int k = 0; k < graph.awake; k++) {
      least = Math.min(least, members.inverseMass[graph.order[k]]);
    }
    mostWeight = ContactLaw.MASS_RATIO * least;
  }

  private void load(int i, double now) {
    members.takeTurn(i, gx, gy, momentTime, now);
    members.moveTo(i, now);
    momenta.v[2 * i] = members.vx[i];
    momenta.v[2 * i + 1] = members.vy[i];
    momenta.weight[i] = Math.min(members.inverseMass[i], mostWeight);
  }

  /** After circles came or went: their velocities, and a new list. */
  private void settle(double now) {
    do {
      findMostWeight();
      for (int k = 0; k < graph.awake; k++) {
        int i = graph.order[k];
        momenta.weight[i] = 0;
        Arrays.fill(momenta.v, 2 * i, 2 * i + 2, 0);
        Arrays.fill(flights.u, 2 * i, 2 * i + 2, 0);
        if (members.isAwake(i)) {
          load(i, now);
        }
      }
      graph.list(momenta.v, now, clock.tau);
      graph.measure(momenta.v, clock.tau);
    } while (graph.lost.size() > 0 && rest.wake(now, gx, gy, clock.tau));
  }

  /**
   * Frees circles that nothing holds: without contacts, or with one flat side only. A contact holds
   * if it bore in the last solve, and circles stay for the tick in which they joined. Without
   * contacts they stay in a crowd that something holds: there they would soon join again.
   */
  private boolean leave(double now) {
    countBearings();
    findCrowds();
    boolean any = false;
    double passed = now - momentTime;
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[k];
      boolean isInCrowd = bearing[i] == 0 && isHeld[crowds.of(k)];
      boolean stays = members.fresh[i] || bearing[i] > 1 || isInCrowd;
      members.fresh[i] = false;
      if (stays) {
        continue;
      }
      if (bearing[i] == 0) {
        leave(i);
        host.frees(i, members.vx[i] + gx * passed, members.vy[i] + gy * passed, Index.NONE);
        any = true;
      } else {
        any |= leaveFlat(i, only[i], passed);
      }
    }
    return any;
  }

  private void leave(int i) {
    members.mode[i] = Members.OUT;
    present--;
  }

  private void countBearings() {
    NearPairs p = graph.pairs;
    for (int k = 0; k < graph.awake; k++) {
      bearing[graph.order[k]] = 0;
    }
    double touch = clock.pull * clock.tau * clock.tau;
    for (int k = 0; k < p.size; k++) {
      // What turns may press in ticks that are short beside the widest standoff: without this, a
      // ball would leave a wedge that closes.
      double wide = parts.areTurning() ? ContactLaw.MARGIN * members.radius[p.owner[k]] : 0;
      boolean bears = p.felt[k] && p.impulse[k] > 0 && p.gap[k] <= Math.max(touch, wide);
      if (bears && p.opening(momenta.v, k) <= clock.slow()) {
        bearing[p.owner[k]]++;
        only[p.owner[k]] = k;
        if (p.part[k] < 0) {
          bearing[p.other[k]]++;
          only[p.other[k]] = k;
        }
      }
    }
  }

  /**
   * Finds crowds: circles that could reach each other in a tick, if a steady push turned them; and
   * which of these are held.
   */
  private void findCrowds() {
    NearPairs p = graph.pairs;
    crowds.clear(graph.awake);
    for (int k = 0; k < graph.awake; k++) {
      isHeld[k] = bearing[graph.order[k]] > 0;
    }
    double push = ContactLaw.STEADY * clock.pull * clock.tau;
    for (int k = 0; k < p.size; k++) {
      if (p.part[k] < 0 && p.gap[k] < (p.speed(momenta.v, k) + push) * clock.tau) {
        int i = graph.rank[p.owner[k]];
        if (members.isAwake(p.other[k])) {
          crowds.join(graph.rank[p.other[k]], i);
        } else {
          isHeld[i] = true;
        }
      }
    }
    for (int k = 0; k < graph.awake; k++) {
      isHeld[crowds.of(k)] |= isHeld[k];
    }
  }

  /** Frees a circle that only the flat side of pair k holds, unless it falls on it or hangs. */
  private boolean leaveFlat(int i, int k, double passed) {
    NearPairs p = graph.pairs;
    int part = p.part[k];
    if (part < 0 || parts.kind[part] > Parts.WALL || parts.turns(part)) {
      return false;
    }
    double nx = p.nx[k];
    double ny = p.ny[k];
    double opening = p.opening(momenta.v, k);
    double kick = clock.kick();
    if (opening < -kick || gx * nx + gy * ny >= 0) {
      return false;
    }
    double tx = parts.dx[part];
    double ty = parts.dy[part];
    double pull = gx * tx + gy * ty;
    double carried = parts.driftAlong(part, tx, ty);
    double along = members.vx[i] * tx + members.vy[i] * ty + pull * passed;
    if (pull == 0 && Math.abs(along - carried) <= ContactLaw.RESIDUAL * kick) {
      along = carried; // no solve tells such a speed from 0
    }
    double up = Math.max(0, opening) + p.drift[k];
    leave(i);
    int side = opening <= kick ? parts.code(part, members.filter[i]) : Index.NONE;
    host.frees(i, along * tx + up * nx, along * ty + up * ny, side);
    return true;
  }

  /** Gives all their kicks; a list for the tick; wakes what is hit. */
  private void kickAll(double now, double h) {
    moment = now + h / 2;
    if (!parts.areMoving()) {
      Arrays.fill(flights.drive, 0);
    }
    for (int k = 0; k < graph.awake; k++) {
      kick(graph.order[k], moment - momentTime);
    }
    do {
      if (!graph.covers(momenta.v, now, h)) {
        graph.list(momenta.v, now, h);
      }
      graph.measure(momenta.v, h);
    } while (wakeHit(now, h));
  }

  private void kick(int i, double time) {
    momenta.v[2 * i] += gx * time;
    momenta.v[2 * i + 1] += gy * time;
  }

  /** Wakes frozen circles that are hit in this tick. */
  private boolean wakeHit(double now, double h) {
    NearPairs p = graph.pairs;
    boolean any = false;
    for (int k = 0; k < p.size; k++) {
      int j = p.other[k];
      if (p.part[k] < 0 && members.canWake(j)) {
        double q = p.opening(momenta.v, k);
        if (q < -clock.slow(members.pull(p, k)) && p.gap[k] - p.standoff[k] + q * h < 0) {
          rest.wake(j, now);
          load(j, now);
          kick(j, h);
          any = true;
        }
      }
    }
    return any;
  }

  /** Makes the flights; false if they are not safe. */
  private boolean fly(double now, double h) {
    double[] u = flights.u;
    flights.start(h);
    if (!graph.covers(u, now, h)) {
      graph.list(u, now, h);
    }
    graph.measureFlights(u, h);
    boolean driven = parts.areMoving();
    if (driven) {
      squeeze.widen(flights.drive);
      squeeze.bulge(u, h);
    }
    flights.part(h);
    flights.pass(h, clock.slow());
    boolean goesOn = driven;
    for (int round = 0; goesOn && round < ContactLaw.TRIES && squeeze.anyMeets(u, h); round++) {
      goesOn = squeeze.solve(u, h, clock.pull * h, cuts);
      graph.measureFlights(u, h);
    }
    boolean safe = flights.secure(h, ContactLaw.TRIES);
    for (int round = 0; safe && !graph.covers(u, now, h); round++) {
      if (round == ContactLaw.TRIES) {
        return false; // speeds beyond the range of doubles leave every list
      }
      graph.list(u, now, h);
      graph.measureFlights(u, h);
      safe = flights.secure(h, 0);
    }
    return safe;
  }

  /** Hands the flights out. */
  private void finish() {
    double span = moment - momentTime;
    momentTime = moment;
    newcomers.longest = 0;
    for (int k = 0; k < graph.awake; k++) {
      int i = graph.order[k];
      hand(i, span);
      newcomers.longest = Math.max(newcomers.longest, members.speed(i));
    }
    for (int k = 0; k < graph.awake; k++) {
      host.flies(graph.order[k]);
    }
  }

  /** What is hit falls freely before and after it; what comes to a stop does not go on so. */
  private void hand(int i, double span) {
    double vx = momenta.v[2 * i];
    double vy = momenta.v[2 * i + 1];
    if (!momenta.bears[i]) {
      members.ax[i] = gx;
      members.ay[i] = gy;
    } else if (span > 0) {
      double ax = (vx - members.vx[i]) / span;
      double ay = (vy - members.vy[i]) / span;
      double most = ContactLaw.STEADY * members.pull[i];
      boolean steady = ax * ax + ay * ay <= most * most;
      members.ax[i] = steady ? ax : 0;
      members.ay[i] = steady ? ay : 0;
    }
    members.vx[i] = vx;
    members.vy[i] = vy;
    members.fly(i, flights.u[2 * i], flights.u[2 * i + 1]);
    if (!momenta.bears[i] && members.ux[i] == vx && members.uy[i] == vy) {
      members.rise[i] = 1;
    } else {
      members.follow(i, gx, gy, clock.kick());
    }
  }

  // Edits.

  /** A frozen circle meets something of another frame: it wakes with what it touches. */
  public void meet(int i, double now) {
    if (members.canWake(i)) {
      look(now);
      start(i, now);
      rest.wakeAll(i, now);
      clock.cut(now);
    }
  }

  private void rouse(int i, double now) {
    start(i, now);
    rest.wake(i, now);
    host.flies(i);
  }

  /** Takes a member out. Frozen ones that it touched wake, and the tick ends now. */
  public void remove(int i, double now) {
    look(now);
    near.clear();
    double hold = ContactLaw.HOLD * ContactLaw.STANDOFF;
    double x = members.xAt(i, now);
    double y = members.yAt(i, now);
    host.membersNear(i, x, y, 2 * hold * members.radius[i], near);
    near.sort(0);
    jammed -= members.jammed[i] ? 1 : 0;
    members.jammed[i] = false;
    leave(i);
    graph.remove(i);
    for (int c = 0; c < near.size(); c++) {
      int j = near.get(c);
      double reach = hold * (members.radius[i] + members.radius[j]);
      if (members.canWake(j) && members.gap(i, j, now) < reach) {
        rouse(j, now);
      }
    }
    clock.cut(now);
  }

  /** Notes that properties of members changed. */
  public void changed() {
    graph.forget();
  }

  /** Notes that any obstacle may have changed. */
  void changedParts() {
    parts.changed();
  }

  /** Whether an obstacle is within the margin of a circle. */
  boolean isNear(int code, double x, double y, double radius, double now) {
    look(now);
    double gap = parts.distanceToCode(code, x, y, now) - radius;
    return gap <= ContactLaw.MARGIN * radius;
  }

  /**
   * Notes that an obstacle, or a circle of infinite mass, comes, goes or changes its motion. Frozen
   * circles near it wake. The tick ends now if it may be in the way.
   */
  public void changed(int code, double now) {
    parts.changed();
    if (present == 0) {
      return;
    }
    look(now);
    for (int i = 0; i < members.count; i++) {
      if (members.mode[i] != Members.OUT) {
        double gap =
            parts.distanceToCode(code, members.xAt(i, now), members.yAt(i, now), now)
                - members.radius[i];
        double touch = ContactLaw.HOLD * ContactLaw.STANDOFF * members.radius[i];
        if (members.isAwake(i)) {
          double left = Math.max(0, clock.end - now);
          if (gap <= touch + (members.speed(i) + parts.fastest()) * left) {
            clock.cut(now);
          }
        } else if (gap <= touch) {
          meet(i, now);
        }
      }
    }
    parts.changed();
  }

  // State.

  /** Forgets all members: others are restored. */
  public void clear() {
    for (int i = 0; i < members.count && present > 0; i++) {
      if (members.mode[i] != Members.OUT) {
        leave(i);
        members.jammed[i] = false;
        graph.remove(i);
      }
    }
    jammed = 0;
    graph.lost.clear();
  }

  /** The gap within which a thing carries a circle of a radius, of two circles the smaller one. */
  public static double reach(double radius) {
    return ContactLaw.HOLD * ContactLaw.STANDOFF * radius;
  }

  /** Saves what is known of a member. */
  public double[] save(int i, CircleRegistry registry) {
    NearPairs p = graph.pairs;
    boolean awake = members.isAwake(i);
    int rank = awake ? graph.rank[i] : Index.NONE;
    int from = awake ? p.start[rank] : 0;
    int to = awake ? p.start[rank + 1] : 0;
    double[] row = new double[ContactRow.SIZE + (to - from) * ContactRow.PAIR];
    columns(i, rank, new ContactRow(row, false));
    for (int k = from; k < to; k++) {
      int at = ContactRow.SIZE + (k - from) * ContactRow.PAIR;
      boolean isPart = p.part[k] >= 0;
      row[at + ContactRow.OTHER] = isPart ? Index.NONE : registry.id(p.other[k]);
      row[at + ContactRow.KEY] = isPart ? keyWithId(p.key[k], registry) : Index.NONE;
      row[at + ContactRow.IMPULSE] = p.impulse[k];
      row[at + ContactRow.FLAGS] = (p.bore[k] ? 1 : 0) + (p.through[k] ? 2 : 0);
    }
    return row;
  }

  private static long keyWithId(long key, CircleRegistry registry) {
    int code = Parts.codeOf(key);
    return Codes.isCircle(code) ? (long) Codes.circle(registry.id(Codes.slot(code))) << 2 : key;
  }

  private static long keyWithSlot(long key, CircleRegistry registry) {
    int code = Parts.codeOf(key);
    return Codes.isCircle(code) ? (long) Codes.circle(registry.slot(Codes.slot(code))) << 2 : key;
  }

  /**
   * The columns of a member in their order, saved or restored. The clock belongs to all that are
   * awake or jammed, the list of near pairs to those awake.
   */
  private void columns(int i, int rank, ContactRow f) {
    boolean awake = members.isAwake(i);
    boolean ticks = awake || members.jammed[i];
    members.vx[i] = f.number(members.vx[i]);
    members.vy[i] = f.number(members.vy[i]);
    members.ax[i] = f.number(members.ax[i]);
    members.ay[i] = f.number(members.ay[i]);
    momentTime = f.number(ticks, momentTime);
    clock.tau = f.number(ticks, clock.tau);
    clock.end = f.number(ticks, clock.end);
    clock.due = f.number(ticks, clock.due);
    int turn = (int) f.number((members.fresh[i] ? 1 : 0) + 2 * members.turned[i]);
    members.fresh[i] = (turn & 1) != 0;
    members.turned[i] = (byte) (turn >> 1);
    members.calmX[i] = f.number(members.calmX[i]);
    members.calmY[i] = f.number(members.calmY[i]);
    members.calmSince[i] = f.number(members.calmSince[i]);
    members.frameX[i] = f.number(members.frameX[i]);
    members.frameY[i] = f.number(members.frameY[i]);
    members.load[i] = f.number(members.load[i]);
    boolean lost = f.number(timesLost(i)) != 0;
    f.number(rank);
    boolean isKnown = !parts.isStale();
    boolean listed = awake && (f.reads() || (isKnown && graph.margin[i] > 0));
    graph.listX[i] = f.number(listed, graph.listX[i]);
    graph.listY[i] = f.number(listed, graph.listY[i]);
    graph.margin[i] = f.number(listed, graph.margin[i]);
    graph.listTime[i] = f.number(listed, graph.listTime[i]);
    double fastest = f.number(listed, graph.fastest);
    graph.fastest = graph.margin[i] > 0 ? fastest : graph.fastest; // a newcomer is not listed yet
    boolean isGood = f.number(awake, isKnown && graph.isValid ? 1 : 0) != 0;
    newcomers.longest = f.number(ticks, newcomers.longest);
    members.rise[i] = f.number(members.rise[i]);
    cuts = (int) f.number(ticks, cuts);
    clock.pull = f.number(ticks, clock.pull);
    if (f.reads() && awake) {
      graph.isValid = isGood;
    }
    if (f.reads() && lost) {
      graph.lost.add(i);
    }
  }

  private int timesLost(int i) {
    int times = 0;
    for (int k = 0; k < graph.lost.size(); k++) {
      times += graph.lost.get(k) == i ? 1 : 0;
    }
    return times;
  }

  /** Restores a member, which was described. {@link #restored} must follow. */
  public void restore(int i, MovingCircle m) {
    double[] row = m.contactRow;
    rows[i] = row;
    members.jammed[i] = m.mode == MovingCircle.JAMMED;
    members.mode[i] = m.mode == MovingCircle.AWAKE ? Members.AWAKE : Members.FROZEN;
    present++;
    jammed += members.jammed[i] ? 1 : 0;
    members.x[i] = m.x;
    members.y[i] = m.y;
    members.since[i] = m.t;
    members.fly(i, m.vx, m.vy);
    members.pull[i] = g;
    columns(i, Index.NONE, new ContactRow(row, true));
    if (members.isAwake(i)) {
      ranked.add(i);
    }
  }

  /** Completes the members that were restored: their order and their pairs. */
  public void restored(CircleRegistry registry, double now) {
    if (present == 0) {
      return;
    }
    if (ranked.size() > 1) {
      sortByRank();
    }
    for (int k = 0; k < ranked.size(); k++) {
      restorePairs(ranked.get(k), rows[ranked.get(k)], registry);
    }
    ranked.clear();
    if (parts.isStale()) {
      parts.update();
    }
    isRestored = true;
  }

  private void sortByRank() {
    int[] sorted =
        IntStream.of(ranked.toArray())
            .boxed()
            .sorted(Comparator.comparingDouble(i -> rows[i][ContactRow.RANK]))
            .mapToInt(Integer::intValue)
            .toArray();
    for (int k = 0; k < sorted.length; k++) {
      ranked.set(k, sorted[k]);
    }
  }

  private void restorePairs(int i, double[] row, CircleRegistry registry) {
    int size = ContactRow.pairs(row);
    NearPairs p = graph.pairs;
    int from = graph.restore(i, size);
    for (int k = 0; k < size; k++) {
      int at = ContactRow.SIZE + k * ContactRow.PAIR;
      boolean isPart = row[at + ContactRow.OTHER] < 0;
      long key = (long) row[at + ContactRow.KEY];
      p.owner[from + k] = i;
      p.other[from + k] = isPart ? members.count : registry.slot((int) row[at + ContactRow.OTHER]);
      p.part[from + k] = isPart ? 0 : Index.NONE;
      p.key[from + k] = isPart ? keyWithSlot(key, registry) : Index.NONE;
      p.impulse[from + k] = row[at + ContactRow.IMPULSE];
      p.bore[from + k] = ((int) row[at + ContactRow.FLAGS] & 1) != 0;
      p.through[from + k] = ((int) row[at + ContactRow.FLAGS] & 2) != 0;
    }
  }
}
