// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;

/**
 * Records everything that determines the future of a world: the flights of circles, and each change
 * of circles and obstacles. So the state of any recorded moment can be built again.
 */
public final class TimelineRecorder {

  /** The limits of sizes, and the properties of the walls. */
  private record Settings(
      double largest,
      double least,
      double restitution,
      int traits,
      long filter,
      double gx,
      double gy) {

    static Settings of(SizeLimits limits, ObstacleTable obstacles, Gravity gravity) {
      return new Settings(
          limits.largest(),
          limits.least(),
          obstacles.boundsRestitution,
          obstacles.boundsTraits,
          obstacles.filter(Codes.LEFT),
          gravity.x,
          gravity.y);
    }

    boolean holdsFor(SizeLimits limits, ObstacleTable obstacles, Gravity gravity) {
      return largest == limits.largest()
          && least == limits.least()
          && restitution == obstacles.boundsRestitution
          && traits == obstacles.boundsTraits
          && filter == obstacles.filter(Codes.LEFT)
          && gx == gravity.x
          && gy == gravity.y;
    }
  }

  private static final int FIRST_ROOM = 16;

  private final int most;
  private final boolean collide;
  private final CircleRegistry registry;
  private final ObstacleTable obstacles;
  private final SizeLimits limits;
  private final Gravity gravity;

  /** The state of the world at the end of the recording. */
  private Supplier<WorldState> present;

  private FlightHistories tracks;
  private ObstacleHistory obstacleHistory;
  private Changes<Settings> settings;
  private double begin;
  private double end;

  /** The time from which all settings are known. */
  private double settingsStart;

  /** The properties of the circle that was added last: others often have the same. */
  private CircleProperties usual;

  /**
   * The tail of the last event at some times, if it is above 0. Tails are kept here if the circle
   * of that event may be removed, and its flights with it. See {@link SavedFlights#tailOfEdit}.
   */
  private final SortedMap<Double, Double> tails = new TreeMap<>();

  // Flights of a step that may still be rolled back: the ids of their circles, and their rows.
  private int[] pendingIds = new int[FIRST_ROOM];
  private final FlightRows pending = new FlightRows(FIRST_ROOM);
  private int pendings;

  /**
   * Creates a recorder that has yet to {@linkplain #begin begin}.
   *
   * @param most the number of flights to keep of each circle, and of changes of each thing
   * @param collide whether circles collide
   * @param registry the circles of the world, as they are at any time
   * @param obstacles the obstacles, likewise
   * @param limits the limits of sizes, likewise
   * @param gravity the gravity, likewise
   * @param present gives the state of the world
   */
  public TimelineRecorder(
      int most,
      boolean collide,
      CircleRegistry registry,
      ObstacleTable obstacles,
      SizeLimits limits,
      Gravity gravity,
      Supplier<WorldState> present) {
    this.most = most;
    this.collide = collide;
    this.registry = registry;
    this.obstacles = obstacles;
    this.limits = limits;
    this.gravity = gravity;
    this.present = present;
  }

  /** The earliest time from which the recording is complete. */
  public double start() {
    double circles = Math.max(begin, tracks.start());
    return Math.max(circles, Math.max(obstacleHistory.start(), settingsStart));
  }

  /** The time up to which the recording is complete. */
  public double end() {
    return end;
  }

  /** The history of a circle that existed at a given time; null if none is known. */
  public FlightHistory track(int id, double t) {
    FlightHistory track = tracks.get(id);
    boolean known = track != null && t >= track.start() && t < track.end() && t <= end;
    return known ? track : null;
  }

  /** The row of a line or peg at a given time; null if it did not exist then. */
  public double[] obstacle(int code, double t) {
    return obstacleHistory.at(code, t);
  }

  /** The walls, as {@link ObstacleTable#walls}. */
  public double[] walls() {
    return obstacles.walls;
  }

  // Recording.

  /** Discards the recording, and begins a new one now. */
  public void begin(double now) {
    tracks = new FlightHistories(most, registry.idLimit());
    obstacleHistory = new ObstacleHistory(obstacles, most);
    settings = new Changes<>();
    settings.add(Double.NEGATIVE_INFINITY, Settings.of(limits, obstacles, gravity));
    tails.clear();
    begin = now;
    end = now;
    settingsStart = now;
    pendings = 0;
  }

  /** Ends the recording: later changes of the world are not known to it. */
  public void stop() {
    WorldState last = present.get();
    present = () -> last;
  }

  /** Adds a flight of the current step, which {@link #undo} may still drop. */
  public void note(MovingCircle m) {
    if (pendings == pendingIds.length) {
      pendingIds = Arrays.copyOf(pendingIds, 2 * pendings);
      pending.resize(2 * pendings);
    }
    pendingIds[pendings] = registry.id(m.id);
    pending.put(pendings++, m, isConfined(m), registry);
  }

  private boolean isConfined(MovingCircle m) {
    return obstacles.wallsFor(m.filter) != null;
  }

  /** Drops the flights of the current step. */
  public void undo() {
    pendings = 0;
  }

  /** Adds a flight that cannot be undone, perhaps that of a new circle. */
  public void add(MovingCircle m) {
    int id = registry.id(m.id);
    FlightHistory track = tracks.get(id);
    if (track == null) {
      track = tracks.create(id, properties(m.id, m.restitution));
    }
    track.add(m, isConfined(m), registry);
    tracks.noteDrop(track);
  }

  private CircleProperties properties(int slot, double restitution) {
    CircleProperties its = CircleProperties.of(registry, slot, restitution);
    usual = its.equals(usual) ? usual : its;
    return usual;
  }

  /** Commits the flights of the current step, which ended at a given time. */
  public void advance(double now) {
    for (int i = 0; i < pendings; i++) {
      FlightHistory track = tracks.get(pendingIds[i]);
      track.add(pending, i);
      tracks.noteDrop(track);
    }
    pendings = 0;
    noteSettings();
    end = now;
  }

  /** Notes the settings that edits have changed since the last step. */
  private void noteSettings() {
    if (!settings.last().holdsFor(limits, obstacles, gravity)) {
      settings.add(end, Settings.of(limits, obstacles, gravity));
      if (settings.keep(most)) {
        settingsStart = Math.max(settingsStart, settings.start());
      }
    }
  }

  /** Records that properties of a circle were set. */
  public void noteProperties(int slot, double restitution, double now) {
    FlightHistory track = tracks.get(registry.id(slot));
    track.noteProperties(now, properties(slot, restitution));
    tracks.noteDrop(track);
  }

  /** Records what a circle remembers of its contacts, which changed within a flight. */
  public void noteContacts(MovingCircle m, double now) {
    FlightHistory track = tracks.get(registry.id(m.id));
    track.noteContacts(now, registry.codeWithId(m.last), m.stuck, registry.jamWithIds(m.jam));
    tracks.noteDrop(track);
  }

  /** Records a contact of two circles, at slots, that a sensor reported, for the first of them. */
  public void noteSensed(int slot, double head, double tail, int partner) {
    FlightHistory track = tracks.get(registry.id(slot));
    track.noteSensed(head, tail, partner < 0 ? partner : registry.id(partner));
    tracks.noteDrop(track);
  }

  /** Records that a line or a peg was added, changed or removed. */
  public void noteObstacle(int code, double now) {
    obstacleHistory.note(code, obstacles, now);
  }

  /** Records that a circle was removed. */
  public void remove(int id, double now) {
    if (collide) {
      noteTail(now, tracks.get(id).tail(now));
    }
    tracks.remove(id, now);
  }

  /** Records the tail of an event, whose circle need not exist any more. */
  public void noteTail(double now, double tail) {
    if (tail > 0) {
      tails.headMap(start()).clear();
      tails.merge(now, tail, Math::max);
    }
  }

  // The past.

  /** Everything that determined the future of the world at a time of the recording. */
  public WorldState state(double t) {
    return t == end ? present.get() : past(t);
  }

  private WorldState past(double t) {
    Settings then = settings.at(t);
    ObstacleTable itsObstacles = obstacleHistory.at(t, then.restitution, then.traits, then.filter);
    int[] ids = tracks.idsAt(t);
    return new WorldState(
        t,
        collide,
        itsObstacles,
        registry(ids, t),
        new SizeLimits(then.largest, then.least),
        flights(ids, t, itsObstacles.haveSensors()),
        then.gx,
        then.gy);
  }

  private CircleRegistry registry(int[] ids, double t) {
    double[] masses = new double[ids.length];
    byte[] traits = new byte[ids.length];
    long[] filters = new long[ids.length];
    for (int k = 0; k < ids.length; k++) {
      CircleProperties its = tracks.get(ids[k]).properties(t);
      masses[k] = its.mass();
      traits[k] = (byte) its.traits();
      filters[k] = its.filter();
    }
    return new CircleRegistry(
        masses, traits, Filter.unlessDefault(filters, ids.length), ids, tracks.idLimitAt(t));
  }

  private SavedFlights flights(int[] ids, double t, boolean sensors) {
    SavedFlights states = new SavedFlights(ids);
    MovingCircle m = new MovingCircle();
    for (int k = 0; k < ids.length; k++) {
      FlightHistory track = tracks.get(ids[k]);
      track.load(t, m);
      forgetRemoved(m, t);
      // All contacts with sensors by then were reported, see StaticScene.
      states.put(k, m, sensors ? m.latestBy(t) : 0, sensors ? Integer.MAX_VALUE : 0);
      if (collide) {
        track.saveSensed(t, ids, k, states);
        states.tailOfEdit = Math.max(states.tailOfEdit, track.tail(t));
      }
    }
    states.tailOfEdit = Math.max(states.tailOfEdit, tails.getOrDefault(t, 0.0));
    return states;
  }

  private void forgetRemoved(MovingCircle m, double t) {
    if (Codes.isCircle(m.last) && track(Codes.slot(m.last), t) == null) {
      m.last = MovingCircle.NOTHING;
    }
  }
}
