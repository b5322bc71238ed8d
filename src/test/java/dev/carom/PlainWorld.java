// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.Exact;
import dev.carom.internal.response.ContactCluster;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.Filter;
import dev.carom.internal.state.Gravity;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SavedFlights;
import dev.carom.internal.sweep.ParabolaDiskSweep;
import dev.carom.internal.sweep.ParabolaReturn;
import dev.carom.internal.sweep.SegmentSweep;
import dev.carom.internal.sweep.WallSweep;
import dev.carom.internal.util.Kind;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * A world the plain way: no cells, no grid, no calendar, no laziness and no memory but that of
 * which sensors a flight met. Before each event every circle is asked about every obstacle and
 * every other circle, by the public detector, and the first answer happens. What an impact then
 * does is the library's own response. Edits change the flights as {@link World} tells.
 */
public final class PlainWorld {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private final boolean collide;
  private ObstacleTable obstacles;
  private CircleRegistry registry;
  private ObstacleResponse response;
  private PairResponse pairs;
  private ContactCluster cluster;
  private Gravity gravity;
  private PlainFall falls;
  private List<MovingCircle> bodies = new ArrayList<>();

  /** When each circle's flight last met each sensor, by the codes of obstacles. */
  private List<Map<Integer, Double>> met = new ArrayList<>();

  /** The pairs that met and changed nothing: how long after the later of their flights began. */
  private Map<Long, Double> metPairs = new HashMap<>();

  private final ImpactRows rows = new ImpactRows(16);
  private final ImpactLog log = new ImpactLog(rows);
  private double now;

  /** The last event that happened when the clock shows the same as now, by the tail of its time. */
  private double lastTail;

  private double last;

  // The first event found so far: when, of what rank, and what it is.
  private double time;
  private double tail;
  private long rank;
  private int low;
  private int high;
  private double wait;

  public PlainWorld(Scene scene) {
    collide = scene.collide();
    obstacles = ObstacleTable.of(scene.data);
    registry = new CircleRegistry(scene.data, 1);
    gravity = new Gravity(scene.data.gx, scene.data.gy);
    respond();
    for (int i = 0; i < scene.circleCount(); i++) {
      Circle c = scene.circle(i);
      Vec2 v = scene.velocity(i);
      MovingCircle m = new MovingCircle();
      m.start(i, c.x(), c.y(), c.radius(), v.x(), v.y(), scene.restitution(ObstacleKind.CIRCLE, i));
      m.filter = registry.filter(i);
      release(m);
      bodies.add(m);
      met.add(new HashMap<>());
    }
  }

  private void respond() {
    falls = new PlainFall(obstacles);
    response = new ObstacleResponse(obstacles, gravity, m -> codes());
    pairs = new PairResponse(registry, response.settling);
    cluster = new ContactCluster(registry, pairs, response, obstacles, new Vicinity());
  }

  /** Everything is near everything. */
  private final class Vicinity implements ContactCluster.Vicinity {

    @Override
    public int[] circlesNear(int i) {
      return !collide
          ? new int[0]
          : bodies.stream().mapToInt(m -> m.id).filter(registry::contains).toArray();
    }

    @Override
    public MovingCircle copyOf(int i) {
      return copy(bodies.get(i));
    }

    @Override
    public int[] obstaclesNear(MovingCircle m) {
      int first = obstacles.walls == null ? Codes.line(0) : 0;
      return IntStream.of(codes()).filter(code -> code >= first).toArray();
    }
  }

  private PlainWorld(PlainWorld other) {
    collide = other.collide;
    restore(other);
  }

  PlainWorld copy() {
    return new PlainWorld(this);
  }

  /** Goes to where another one is. */
  void restore(PlainWorld other) {
    obstacles = other.obstacles.copy();
    registry = copy(other.registry, other.bodies.size());
    gravity = new Gravity(other.gravity.x, other.gravity.y);
    respond();
    now = other.now;
    last = other.last;
    lastTail = other.lastTail;
    bodies = new ArrayList<>(other.bodies.stream().map(PlainWorld::copy).toList());
    met = new ArrayList<>();
    other.met.forEach(times -> met.add(new HashMap<>(times)));
    metPairs = new HashMap<>(other.metPairs);
  }

  /** Here each circle has its id for a slot, whatever was removed. */
  private static CircleRegistry copy(CircleRegistry registry, int end) {
    double[] masses = IntStream.range(0, end).mapToDouble(registry::mass).toArray();
    byte[] traits = new byte[end];
    for (int i = 0; i < end; i++) {
      traits[i] = (byte) registry.traits(i);
    }
    long[] filters = IntStream.range(0, end).mapToLong(registry::filter).toArray();
    CircleRegistry copy =
        new CircleRegistry(masses, traits, filters, IntStream.range(0, end).toArray(), end);
    IntStream.range(0, end).filter(i -> !registry.contains(i)).forEach(copy::remove);
    return copy;
  }

  private static MovingCircle copy(MovingCircle m) {
    SavedFlights one = new SavedFlights(new int[] {m.id});
    one.put(0, m, 0, 0);
    MovingCircle copy = new MovingCircle();
    one.get(0, copy);
    copy.id = m.id;
    copy.filter = m.filter;
    copy.flown = m.flown;
    copy.standsStill = m.standsStill;
    return copy;
  }

  // Steps.

  /** The first so many impacts until the given time, in the order of a world's log. */
  public ImpactLog advance(double end, int most) {
    rows.clear();
    if (collide) {
      while (log.size() < most && find(bodies) <= end) {
        happen();
      }
    } else {
      for (MovingCircle m : bodies) {
        while (log.size() < most && find(List.of(m)) <= end) {
          happen();
        }
      }
    }
    rows.sort();
    now = end;
    return log;
  }

  private void happen() {
    MovingCircle m = bodies.get(low);
    if (high >= 0) {
      happened();
      meet(m, bodies.get(high));
    } else {
      int code = m.next;
      double vx = m.vx;
      double vy = m.vy;
      int result = response.resolve(m, rows);
      if (result == ObstacleResponse.SENSED) {
        met.get(low).put(code, m.cleared);
      } else {
        happened();
        begin(m);
        if (m.vx != vx || m.vy != vy) {
          leaveJamsOfInfinite(m);
        }
        settle(result, m);
      }
    }
  }

  private void happened() {
    lastTail = last == time ? Math.max(lastTail, tail) : tail;
    last = time;
  }

  /** A flight begins: what it meets is new to it. */
  private void begin(MovingCircle m) {
    met.get(m.id).clear();
    metPairs.keySet().removeIf(pair -> pair >> 32 == m.id || pair.intValue() == m.id);
  }

  private void meet(MovingCircle a, MovingCircle b) {
    MovingCircle one = copy(a);
    MovingCircle two = copy(b);
    one.flown = a.flown;
    two.flown = b.flown;
    MovingCircle early = bringTogether(one, two);
    double before = early.flown;
    one.advance(wait);
    two.advance(wait);
    early.flown += before;
    early.standsStill &= early.flown == wait;
    one.crushed = cluster.isCrushed(one);
    two.crushed = cluster.isCrushed(two);
    int result = pairs.resolve(one, two, rows);
    if (result == ObstacleResponse.SENSED) {
      metPairs.put(pair(a, b), wait);
    } else {
      bodies.set(a.id, one);
      bodies.set(b.id, two);
      begin(one);
      begin(two);
      settle(result, one, two);
    }
  }

  /** Updates the jams of circles that begin new flights. */
  private void settle(int result, MovingCircle... hit) {
    Collection<MovingCircle> changed = List.of(hit);
    if (result == ObstacleResponse.STUCK && (collide || obstacles.areMoving())) {
      changed = cluster.resolve(rows, hit);
      for (MovingCircle m : changed) {
        bodies.set(m.id, m);
        begin(m);
      }
    }
    changed.forEach(this::revive);
  }

  /** An infinite mass that changed its way is there again for circles that it crushed. */
  private void leaveJamsOfInfinite(MovingCircle m) {
    if (registry.mass(m.id) == NEVER) {
      leaveJams(Codes.circle(m.id));
    }
  }

  private void leaveJams(int code) {
    bodies.stream()
        .filter(other -> other.jam != null && other.jam.concerns(code))
        .forEach(other -> other.forget(code, 0));
  }

  private void revive(MovingCircle m) {
    for (MovingCircle other : bodies) {
      int code = Codes.circle(other.id);
      boolean inert = m.jam != null && m.jam.makesInert(code);
      if (inert && pairs.part(m, other)) {
        m.jam = m.jam.without(code);
      }
    }
  }

  private static long pair(MovingCircle a, MovingCircle b) {
    return (long) a.id << 32 | b.id;
  }

  /** The earlier flight is taken to the start of the later one. */
  private static MovingCircle bringTogether(MovingCircle a, MovingCircle b) {
    double later = later(a, b);
    MovingCircle early = later > 0 ? a : b;
    MovingCircle late = later > 0 ? b : a;
    early.move(Math.abs(later));
    early.flown += Math.abs(later);
    early.t = late.t;
    early.tl = late.tl;
    return early;
  }

  private static double later(MovingCircle a, MovingCircle b) {
    return (b.t - a.t) + (b.tl - a.tl);
  }

  private double find(List<MovingCircle> some) {
    time = NEVER;
    tail = 0;
    rank = Long.MAX_VALUE;
    for (MovingCircle m : some) {
      if (registry.contains(m.id)) {
        lookAtObstacles(m);
        for (int j = m.id + 1; collide && j < bodies.size(); j++) {
          if (registry.contains(j)) {
            lookAtPair(m, bodies.get(j));
          }
        }
      }
    }
    return time;
  }

  private void keep(double head, double tail, long rank, int low, int high, double wait) {
    boolean first =
        head != time ? head < time : tail != this.tail ? tail < this.tail : rank < this.rank;
    if (first && head != NEVER) {
      time = head;
      this.tail = tail;
      this.rank = rank;
      this.low = low;
      this.high = high;
      this.wait = wait;
    }
  }

  private void lookAtObstacles(MovingCircle m) {
    double best = NEVER;
    int code = MovingCircle.NOTHING;
    for (int k : codes()) {
      boolean there = (m.jam == null || !m.jam.concerns(k)) && meets(m.id, obstacles.filter(k));
      double t = there ? next(m, k) : NEVER;
      boolean sensor = obstacles.isSensor(k);
      boolean before = t == best && t != NEVER && sensor && !obstacles.isSensor(code);
      if (t < best || before) {
        best = t;
        code = k;
      }
    }
    if (falls.endOfSlide(m) < best) {
      best = falls.endOfSlide(m);
      code = m.support;
    }
    m.cleared = best;
    m.next = code;
    if (code == MovingCircle.NOTHING) {
      return;
    }
    m.contact = 0;
    if (m.isFalling()) {
      m.contact = falls.contact(m, code, best);
    } else if (Codes.isLine(code)) {
      double[] l = obstacles.rowAt(code, m.t, m.tl);
      double ux = obstacles.ux(code);
      double uy = obstacles.uy(code);
      m.contact =
          SegmentSweep.contact(m.x, m.y, m.radius, m.vx, m.vy, l[0], l[1], l[2], l[3], ux, uy);
    }
    double head = m.after(best);
    keep(head, m.afterTail(best, head), (long) code << 31 | m.id, m.id, -1, best);
  }

  /** When a circle next meets an obstacle, in its flight and after all that it met in that. */
  private double next(MovingCircle m, int code) {
    if (m.isFalling()) {
      return falls.time(m, code, met.get(m.id).getOrDefault(code, 0.0));
    }
    if (code == m.last) {
      return NEVER;
    }
    double t = sweep(m, code);
    return obstacles.isSensor(code) && (t == 0 || met.get(m.id).containsKey(code)) ? NEVER : t;
  }

  private boolean meets(int circle, long filter) {
    return meet(registry.filter(circle), filter);
  }

  private static boolean meet(long a, long b) {
    return (Filter.category(a) & Filter.mask(b)) != 0 && (Filter.category(b) & Filter.mask(a)) != 0;
  }

  private int[] codes() {
    return IntStream.concat(
            IntStream.range(0, obstacles.lines.end),
            IntStream.range(Codes.peg(0), obstacles.ofKind(Kind.PEG).end))
        .filter(code -> Codes.isWall(code) || !obstacles.isGone(code))
        .toArray();
  }

  private double sweep(MovingCircle m, int code) {
    if (Codes.isWall(code)) {
      return sweepWall(m, code);
    }
    // Where a thing that moves was when the flight began.
    double[] n = obstacles.rowAt(code, m.t, m.tl);
    double ux = obstacles.ux(code);
    double uy = obstacles.uy(code);
    if (Codes.isLine(code)) {
      if (obstacles.isOneWay(code) && !isStopped(m, n[0], n[1], n[2], n[3], ux, uy)) {
        return NEVER;
      }
      return SweptCircle.movingLine(
          m.x, m.y, m.radius, m.vx, m.vy, n[0], n[1], n[2], n[3], ux, uy, NEVER);
    }
    return SweptCircle.pair(m.x, m.y, m.radius, m.vx, m.vy, n[0], n[1], n[2], ux, uy, NEVER);
  }

  /** Whether the centre is left of a line and goes to its right: a point's path from there on. */
  private static boolean isStopped(
      MovingCircle m, double ax, double ay, double bx, double by, double ux, double uy) {
    int side = Exact.cross(bx, by, ax, ay, m.x, m.y, ax, ay).sign();
    int drift = Exact.cross(bx, by, ax, ay, m.vx, m.vy, ux, uy).sign();
    return side > 0 && drift < 0;
  }

  /** A wall is met only on the way to it. */
  private double sweepWall(MovingCircle m, int code) {
    if (obstacles.walls == null) {
      return NEVER;
    }
    boolean vertical = Codes.isVertical(code);
    boolean up = code == Codes.RIGHT || code == Codes.TOP;
    double v = vertical ? m.vx : m.vy;
    if (up ? !(v > 0) : !(v < 0)) {
      return NEVER;
    }
    Bounds b = PublicRecords.bounds(obstacles.walls);
    double wall = vertical ? (up ? b.xmax() : b.xmin()) : (up ? b.ymax() : b.ymin());
    return WallSweep.time(vertical ? m.x : m.y, m.radius, v, wall, NEVER);
  }

  private void lookAtPair(MovingCircle a, MovingCircle b) {
    int ofA = Codes.circle(a.id);
    int ofB = Codes.circle(b.id);
    boolean justHit = a.last == ofB && b.last == ofA;
    boolean alike = a.gx == b.gx && a.gy == b.gy;
    if ((justHit && alike)
        || !meets(a.id, registry.filter(b.id))
        || pairs.isInert(a.id, a.jam, b.id, b.jam)) {
      return;
    }
    MovingCircle one = copy(a);
    MovingCircle two = copy(b);
    bringTogether(one, two);
    double tau = next(one, two, justHit && later(a, b) == 0);
    if (tau == NEVER) {
      return;
    }
    MovingCircle late = later(a, b) > 0 ? b : a;
    double s = late.t + tau;
    double l = sumTail(late.t, tau, s) + late.tl;
    double head = s + l;
    keep(head, sumTail(s, l, head), pairs.rank(a.id, b.id), a.id, b.id, tau);
  }

  /** How long it takes two circles to meet, if that was not reported before. */
  private double next(MovingCircle a, MovingCircle b, boolean justHit) {
    if (!pairs.isSilent(a.id, b.id)) {
      return justHit
          ? ParabolaReturn.toDisk(
              a.x, a.y, a.vx, a.vy, a.gx - b.gx, a.gy - b.gy, b.x, b.y, b.vx, b.vy, NEVER)
          : sweep(a, b, -1);
    }
    boolean sensor = pairs.isSensor(a.id, b.id);
    return sweep(a, b, metPairs.getOrDefault(pair(a, b), sensor ? 0.0 : -1.0));
  }

  /** How long it takes two circles to meet, later than a given time. */
  private static double sweep(MovingCircle a, MovingCircle b, double after) {
    double gx = a.gx - b.gx;
    double gy = a.gy - b.gy;
    if (gx == 0 && gy == 0) {
      double t =
          SweptCircle.pair(a.x, a.y, a.radius, a.vx, a.vy, b.x, b.y, b.radius, b.vx, b.vy, NEVER);
      return t > after ? t : NEVER;
    }
    return after < 0
        ? ParabolaDiskSweep.time(
            a.x, a.y, a.radius, a.vx, a.vy, gx, gy, b.x, b.y, b.radius, b.vx, b.vy, NEVER)
        : ParabolaDiskSweep.timeAfter(
            a.x, a.y, a.radius, a.vx, a.vy, gx, gy, b.x, b.y, b.radius, b.vx, b.vy, after, NEVER);
  }

  // Questions.

  /** When a circle that is not there would first hit something but a sensor. */
  double cast(Circle circle, Vec2 v, int category, int mask) {
    long filter = Filter.of(category, mask);
    MovingCircle m = CircleCast.body(circle, v, 1);
    double first = NEVER;
    obstacles.setEpoch(now);
    for (int code : codes()) {
      boolean there = !obstacles.isSensor(code) && meet(filter, obstacles.filter(code));
      first = Math.min(first, there ? sweep(m, code) : NEVER);
    }
    obstacles.setEpoch(0);
    for (MovingCircle other : bodies) {
      boolean there =
          collide
              && registry.contains(other.id)
              && !registry.isSensor(other.id)
              && meets(other.id, filter);
      MovingCircle then = copy(other);
      then.move(MovingCircle.since(other.t, other.tl, now));
      if (there && Math.abs(then.x) + Math.abs(then.y) < NEVER) {
        first = Math.min(first, sweep(m, then, -1));
      }
    }
    return first;
  }

  // Edits.

  void setVelocity(int id, double vx, double vy) {
    MovingCircle m = restarted(id);
    m.vx = vx;
    m.vy = vy;
    m.forget();
  }

  void setPosition(int id, double x, double y) {
    MovingCircle m = restarted(id);
    m.x = x;
    m.y = y;
    m.forget();
  }

  void setRadius(int id, double radius) {
    MovingCircle m = restarted(id);
    m.radius = radius;
    if (m.isFalling()) {
      m.last = MovingCircle.NOTHING;
    }
  }

  private MovingCircle restarted(int id) {
    MovingCircle m = begunAnew(id);
    release(m);
    return m;
  }

  private void release(MovingCircle m) {
    if (m.isSupported() && Codes.isCircle(m.last)) {
      m.last = MovingCircle.NOTHING;
    }
    boolean isHeavy = registry.mass(m.id) == NEVER;
    m.fall(isHeavy ? 0 : gravity.x, isHeavy ? 0 : gravity.y);
  }

  void setGravity(double gx, double gy) {
    for (MovingCircle m : bodies) {
      if (registry.contains(m.id)) {
        begunAnew(m.id).forget();
      }
    }
    gravity.x = gx;
    gravity.y = gy;
    bodies.stream().filter(m -> registry.contains(m.id)).forEach(this::release);
  }

  /** Lets circles fall that slide or rest on an obstacle which is about to change. */
  private void letFallFrom(int code) {
    for (MovingCircle m : bodies) {
      boolean rests = m.isSupported() && m.gx == 0 && m.gy == 0;
      boolean isCarried =
          m.support == code || m.support == ~code || (rests && response.settling.touches(m, code));
      if (registry.contains(m.id) && isCarried) {
        restarted(m.id).forget(code, 0);
      }
    }
  }

  /** A circle at the start of a new flight, which goes on as the one before. */
  private MovingCircle begunAnew(int id) {
    MovingCircle m = bodies.get(id);
    boolean confined = meets(id, obstacles.filter(Codes.LEFT));
    m.restart(now, tailOfEdit(m), confined ? obstacles.walls : null);
    begin(m);
    leaveJamsOfInfinite(m);
    return m;
  }

  /** An edit comes after all that happened: to the circle, if it is alone. */
  private double tailOfEdit(MovingCircle m) {
    double head = collide ? last : m.t;
    double tail = collide ? lastTail : m.tl;
    return head == now ? Math.max(0, tail) : 0;
  }

  void setMass(int id, double mass) {
    double never = Double.POSITIVE_INFINITY;
    boolean passes = (registry.mass(id) == never) != (mass == never);
    registry.setMass(id, mass);
    if (passes && (collide || gravity.acts())) {
      restarted(id).forget();
    }
  }

  void addCircle(double x, double y, double radius, double vx, double vy) {
    MovingCircle m = new MovingCircle();
    m.start(registry.add(), x, y, radius, vx, vy, 1);
    m.t = now;
    m.tl = tailOfEdit(m);
    release(m);
    bodies.add(m);
    met.add(new HashMap<>());
  }

  void addLine(double ax, double ay, double bx, double by) {
    appear(obstacles.add(Kind.LINE, ax, ay, bx, by));
  }

  void addPeg(double x, double y, double radius) {
    appear(obstacles.add(Kind.PEG, x, y, radius));
  }

  void moveLine(int id, double ax, double ay, double bx, double by) {
    letFallFrom(Codes.line(id));
    obstacles.move(Codes.line(id), new double[] {ax, ay, bx, by}, now);
    appear(Codes.line(id));
  }

  void movePeg(int id, double x, double y, double radius) {
    letFallFrom(Codes.peg(id));
    obstacles.move(Codes.peg(id), new double[] {x, y, radius}, now);
    appear(Codes.peg(id));
  }

  /** Lets a line or a peg move. */
  void setVelocity(ObstacleKind kind, int id, double vx, double vy) {
    int code = Codes.of(kind.ordinal(), id);
    letFallFrom(code);
    obstacles.setVelocity(code, vx, vy, now);
    appear(code);
  }

  void remove(ObstacleKind kind, int id) {
    switch (kind) {
      case LINE -> removeObstacle(Codes.line(id));
      case PEG -> removeObstacle(Codes.peg(id));
      default -> removeCircle(id);
    }
  }

  private void removeCircle(int id) {
    int code = Codes.circle(id);
    registry.remove(id);
    leaveJams(code);
  }

  private void removeObstacle(int code) {
    letFallFrom(code);
    obstacles.remove(code);
    bodies.forEach(m -> m.forget(code, 0));
  }

  void setRestitution(ObstacleKind kind, int id, double e) {
    switch (kind) {
      case LINE -> obstacles.setRestitution(Codes.line(id), e);
      case PEG -> obstacles.setRestitution(Codes.peg(id), e);
      case WALL -> obstacles.setRestitution(id, e);
      case CIRCLE -> bodies.get(id).restitution = e;
    }
  }

  void setResponse(ObstacleKind kind, int id, Response response) {
    switch (kind) {
      case LINE, PEG -> {
        int code = (kind == ObstacleKind.LINE ? Codes.line(0) : Codes.peg(0)) + id;
        setTraits(code, ContactFlags.with(obstacles.traits(code), response.ordinal()));
      }
      case WALL ->
          obstacles.setTraits(id, ContactFlags.with(obstacles.boundsTraits, response.ordinal()));
      case CIRCLE -> {
        registry.setTraits(id, ContactFlags.with(registry.traits(id), response.ordinal()));
        restarted(id);
      }
    }
  }

  void setOneWay(int id, boolean oneWay) {
    int code = Codes.line(id);
    setTraits(code, ContactFlags.withOneWay(obstacles.traits(code), oneWay));
  }

  private void setTraits(int code, int traits) {
    if (traits != obstacles.traits(code)) {
      letFallFrom(code);
      obstacles.setTraits(code, traits);
      appear(code);
    }
  }

  void setFilter(ObstacleKind kind, int id, int category, int mask) {
    long filter = Filter.of(category, mask);
    switch (kind) {
      case LINE, PEG -> {
        int code = (kind == ObstacleKind.LINE ? Codes.line(0) : Codes.peg(0)) + id;
        if (filter != obstacles.filter(code)) {
          letFallFrom(code);
          obstacles.setFilter(code, filter);
          appear(code);
        }
      }
      case WALL -> setFilterOfWalls(filter);
      case CIRCLE -> {
        if (filter != registry.filter(id)) {
          restarted(id).forget();
          registry.setFilter(id, filter);
          bodies.get(id).filter = filter;
        }
      }
    }
  }

  private void setFilterOfWalls(long filter) {
    for (MovingCircle m : bodies) {
      boolean was = meets(m.id, obstacles.filter(Codes.LEFT));
      if (registry.contains(m.id) && was != meets(m.id, filter)) {
        restarted(m.id).forget();
      }
    }
    obstacles.setFilter(Codes.LEFT, filter);
  }

  private boolean isAhead(MovingCircle m, int code) {
    return (m.isFalling() ? falls.time(m, code, 0) : sweep(m, code)) < NEVER;
  }

  /** Flights that would meet a thing that was not there begin anew. */
  private void appear(int code) {
    for (MovingCircle m : bodies) {
      if (registry.contains(m.id)) {
        m.forget(code, 0);
        if (meets(m.id, obstacles.filter(code)) && isAhead(m, code)) {
          begunAnew(m.id);
        }
      }
    }
  }
}
