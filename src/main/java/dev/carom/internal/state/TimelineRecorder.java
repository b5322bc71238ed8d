// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * Records everything that determines the future of a world: the flights of circles, and each change
 * of circles and obstacles. So the state of any recorded moment can be built again.
 *
 * <p>But what {@link ContactRow contact} knows changes at each tick, and takes four times a flight.
 * It is kept now and then: at a <i>stand</i>. A moment between is found by playing on from there.
 */
public final class TimelineRecorder {

  /** The limits of sizes, and the properties of the walls. */
  private record Settings(
      SizeLimits limits, double restitution, int traits, long filter, double gx, double gy) {

    static Settings of(SizeLimits limits, ObstacleTable obstacles, Gravity gravity) {
      return new Settings(
          limits.copy(),
          obstacles.boundsRestitution,
          obstacles.boundsTraits,
          obstacles.filter(Codes.LEFT),
          gravity.x,
          gravity.y);
    }

    boolean areThoseOf(SizeLimits others, ObstacleTable obstacles, Gravity gravity) {
      return limits.equals(others)
          && Double.compare(restitution, obstacles.boundsRestitution) == 0
          && traits == obstacles.boundsTraits
          && filter == obstacles.filter(Codes.LEFT)
          && gx == gravity.x
          && gy == gravity.y;
    }
  }

  private static final int FIRST_ROOM = 16;

  /** A stand comes after so many flights of each member: then it adds a fortieth to them. */
  private static final int FLIGHTS = 128;

  private final double duration;
  private final boolean collide;
  private final CircleRegistry registry;
  private final SizeLimits limits;
  private final Gravity gravity;

  /** Those of the world; once the recording has ended, a copy. */
  private ObstacleTable obstacles;

  /** The state of the world at the end of the recording. */
  private Supplier<WorldState> present;

  private FlightHistories tracks;
  private ObstacleHistory obstacleHistory;
  private Changes<Settings> settings;

  /** The stands: whether nothing that contact knows changes from there until the next one. */
  private Changes<Boolean> stands;

  /** The flights of members since the last stand, and how many flights ask for the next one. */
  private long flights;

  private long mostFlights;

  /** Whether a stand is due before the next step. */
  private boolean isStandDue;

  /** Whether the last step ended where it began. */
  private boolean isRepeated;

  private double begin;
  private double end;

  /** The properties that were recorded last: others often have the same. */
  private CircleProperties usual;

  /**
   * The tail of the last event at some times, if it is above 0. Tails are kept here if the circle
   * of that event may be removed, and its flights with it. See {@link WorldState#tailOfEdit}.
   */
  private final SortedMap<Double, Double> tails = new TreeMap<>();

  /** The flights of a step that may still be rolled back. */
  private final UndoLog pending = new UndoLog(FIRST_ROOM);

  /** A circle to load, no longer than one call. */
  private final MovingCircle loaded = new MovingCircle();

  /**
   * Creates a recorder that has yet to {@linkplain #begin begin}.
   *
   * @param duration how long what has ended is kept, at least
   * @param collide whether circles collide
   * @param registry the circles of the world, as they are at any time
   * @param obstacles the obstacles, likewise
   * @param limits the limits of sizes, likewise
   * @param gravity the gravity, likewise
   * @param present gives the state of the world
   */
  public TimelineRecorder(
      double duration,
      boolean collide,
      CircleRegistry registry,
      ObstacleTable obstacles,
      SizeLimits limits,
      Gravity gravity,
      Supplier<WorldState> present) {
    this.duration = duration;
    this.collide = collide;
    this.registry = registry;
    this.obstacles = obstacles;
    this.limits = limits;
    this.gravity = gravity;
    this.present = present;
  }

  /** The earliest time from which the recording is complete. */
  public double start() {
    return Math.max(begin, end - duration);
  }

  /** The time up to which the recording is complete. */
  public double end() {
    return end;
  }

  /** The history of a circle that existed at a given time; null if none is known. */
  public FlightHistory track(int id, double t) {
    FlightHistory track = t >= start() && t <= end ? tracks.get(id) : null;
    return track != null && t >= track.start() && t < track.end() ? track : null;
  }

  /**
   * The rows of an obstacle, which is no wall, at a given time: of an outline, those of its sides;
   * none if it did not exist then.
   */
  public double[][] obstacle(int kind, int id, double t) {
    ObstacleRows rows = obstacles.ofKind(kind);
    boolean isId = id >= 0 && id < rows.idLimit();
    return IntStream.range(isId ? rows.code(id) : 0, isId ? rows.code(id + 1) : 0)
        .mapToObj(code -> obstacleHistory.at(code, t))
        .filter(row -> row != null)
        .toArray(double[][]::new);
  }

  /** Whether an obstacle of rows is a solid polygon. */
  public boolean isSolid(int kind, int id, double t) {
    return obstacleHistory.outside(obstacles.code(kind, id), t) != 0;
  }

  /** The walls, as {@link ObstacleTable#walls}. */
  public double[] walls() {
    return obstacles.walls;
  }

  // Recording.

  /** Discards the recording, and begins a new one now. */
  public void begin(double now) {
    tracks = new FlightHistories(registry.idLimit());
    obstacleHistory = new ObstacleHistory(obstacles);
    settings = new Changes<>();
    settings.set(now, Settings.of(limits, obstacles, gravity), now);
    stands = new Changes<>();
    stands.set(now, true, now);
    isStandDue = true;
    tails.clear();
    begin = now;
    end = now;
    pending.clear();
  }

  /** Ends the recording: later changes of the world are not known to it. */
  public void stop() {
    WorldState last = present.get();
    present = () -> last;
    obstacles = obstacles.copy();
    tracks.trim();
  }

  /** Adds a flight of the current step, which {@link #undo} may still drop. */
  public void note(MovingCircle m) {
    pending.save(m);
  }

  /** Drops the flights of the current step. */
  public void undo() {
    pending.clear();
  }

  /**
   * Adds a circle, which may be a new one, as it is from a time on: at the start of a flight, or
   * after a change within it. This cannot be undone.
   */
  public void add(MovingCircle m, double time) {
    FlightHistory track = tracks.of(registry.id(m.id));
    CircleProperties its = track.properties();
    usual = CircleProperties.of(m, registry, obstacles, its == null ? usual : its);
    int last = m.last;
    int partner = m.sensedPartner;
    IgnoreList jam = m.jam;
    registry.toIds(m);
    track.add(m, time, usual, horizon());
    m.last = last;
    m.sensedPartner = partner;
    m.jam = jam;
    if (m.isMember()) {
      addMember(m, time);
    }
  }

  private void addMember(MovingCircle m, double time) {
    flights++;
    if (stands.last()) {
      stands.set(end, false, start());
      mostFlights = FLIGHTS;
    }
    if (time == stands.since() && m.contactRow != null) {
      keepContact(m, time);
    }
  }

  // Stands.

  /**
   * Notes that the world is edited. That asks for a stand where nothing can be played through the
   * edit: at the time of a stand, while all rest, and amid the events of a time.
   */
  public void noteEdit(boolean isUnfinished) {
    isStandDue |= isUnfinished || isRepeated || stands.last() || stands.since() == end;
  }

  /** Whether a stand is due before the next step. */
  public boolean isStandDue() {
    return isStandDue;
  }

  /** Notes that the stand was made. */
  public void clearDue() {
    isStandDue = false;
  }

  /** Whether all members rested at the last stand, and do so since. */
  public boolean isAtRest() {
    return stands.last();
  }

  /** Whether so much happened since the last stand that the next one is due. */
  public boolean isLong() {
    return flights >= mostFlights;
  }

  /** Whether the latest stand is one of the present time, which a further event changes. */
  public boolean isStand(double now) {
    return stands.since() == now;
  }

  /** Keeps what contact knows of a member; {@link #stand} follows. */
  public void keepContact(MovingCircle m, double now) {
    tracks.get(registry.id(m.id)).keepContact(now, m.contactRow, horizon());
  }

  /**
   * Completes a stand, for which all members were kept.
   *
   * @param flying how many of them fly, and do not rest
   */
  public void stand(double now, int flying) {
    boolean rests = flying == 0;
    if (!rests || !stands.last()) {
      stands.set(now, rests, start());
    }
    flights = 0;
    mostFlights = (long) FLIGHTS * flying;
  }

  /** The latest time up to t of which everything is recorded. */
  public double lastStand(double t) {
    return t == end || stands.at(t) ? t : stands.time(stands.find(t));
  }

  /** The time up to which everything that ended may be dropped. */
  public double horizon() {
    double start = start();
    return stands.at(start) ? start : stands.time(stands.find(start));
  }

  /** Commits the flights of the current step, which ended at a given time. */
  public void advance(double now) {
    for (int i = 0; i < pending.size(); i++) {
      pending.load(i, loaded);
      add(loaded, loaded.t);
    }
    pending.clear();
    if (!settings.last().areThoseOf(limits, obstacles, gravity)) { // edits have changed them
      settings.set(end, Settings.of(limits, obstacles, gravity), horizon());
    }
    isRepeated = end == now;
    end = now;
    tracks.forget(horizon());
    obstacleHistory.forget(horizon());
  }

  /** Records that a line or a peg was added, changed or removed. */
  public void noteObstacle(int code, double now) {
    obstacleHistory.note(code, obstacles, now, horizon());
  }

  /** Records that a circle was removed. */
  public void remove(int id, double now) {
    if (collide) {
      tracks.get(id).load(now, loaded);
      noteTail(now, tail(loaded, now));
    }
    tracks.remove(id, now);
  }

  /** Records the tail of an event, whose circle need not exist any more. */
  public void noteTail(double now, double tail) {
    if (tail > 0) {
      tails.headMap(horizon()).clear();
      tails.merge(now, tail, Math::max);
    }
  }

  /** The tail of a circle's last event if that was at a time; at least 0. */
  private static double tail(MovingCircle m, double t) {
    double ofFlight = m.t == t ? m.tl : 0;
    double ofSensor =
        m.sensedPartner != MovingCircle.NOT_SENSED && m.sensedHead == t ? m.sensedTail : 0;
    return Math.max(0, Math.max(ofFlight, ofSensor));
  }

  // The past.

  /** Everything that determined the future of the world, at the {@link #lastStand} of a time. */
  public WorldState state(double t) {
    return t == end ? present.get() : past(t);
  }

  private WorldState past(double t) {
    Settings then = settings.at(t);
    ObstacleTable itsObstacles =
        obstacleHistory.at(obstacles, t, then.restitution, then.traits, then.filter);
    int[] ids = tracks.idsAt(t);
    CircleRegistry circles = new CircleRegistry(ids, tracks.idLimitAt(t));
    FlightTable flights = new FlightTable(ids.length);
    double tail = tails.getOrDefault(t, 0.0);
    for (int k = 0; k < ids.length; k++) {
      CircleProperties its = load(ids[k], t, circles, itsObstacles.haveSensors());
      circles.setMass(k, its.mass());
      circles.setTraits(k, its.traits());
      circles.setFilter(k, its.filter());
      flights.put(k, loaded);
      tail = Math.max(tail, collide ? tail(loaded, t) : 0);
    }
    return new WorldState(
        t, collide, itsObstacles, circles, then.limits.copy(), flights, tail, then.gx, then.gy);
  }

  /** Loads a circle as it was at a time, among those that existed then; returns its properties. */
  private CircleProperties load(int id, double t, CircleRegistry circles, boolean sensors) {
    CircleProperties its = tracks.get(id).load(t, loaded);
    if (Codes.isCircle(loaded.last) && circles.slot(Codes.slot(loaded.last)) < 0) {
      loaded.last = MovingCircle.NOTHING;
    }
    if (loaded.sensedPartner >= 0) {
      loaded.sensedPartner = circles.lastIdUpTo(loaded.sensedPartner);
    }
    if (sensors) { // all contacts with sensors by then were reported, see StaticScene
      loaded.forgetPrediction(loaded.latestBy(t), Integer.MAX_VALUE);
    }
    return its;
  }
}
