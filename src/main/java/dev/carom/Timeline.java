// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.FlightHistory;
import dev.carom.internal.state.TimelineRecorder;
import dev.carom.internal.util.Check;

/**
 * A {@code Timeline} holds the recorded past of a world. It tells where each circle was, and how it
 * moved, at any time from {@link #start} to {@link #end}. From any of these moments a world can go
 * on again: see {@link #snapshot}.
 *
 * <pre>{@code
 * World world =
 *     new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 8, 0).build());
 * Timeline past = world.record(100); // the last 100 units of time
 * world.step(6);
 * System.out.println(past.x(0, 2.5) + ", " + past.x(0, 5.5)); // 70.0, 86.0
 * }</pre>
 *
 * <p>Answers are those that the world gave at that moment, to the bit. If the world was edited at
 * that moment, they are those after the edits, and after the impacts that the edits caused at once.
 * Each change of a line or a peg is recorded, too.
 *
 * <p>Its size follows the impacts, edits and contacts of the time that is kept, not the steps: see
 * {@link World#record World.record}.
 *
 * <p>A world records its steps and its edits. When a snapshot is restored into it, the recording
 * begins anew. Not safe for use by several threads.
 */
public final class Timeline {

  private final World world;
  final TimelineRecorder recorder; // tests count its flights

  private final RecordedEdits edits;

  Timeline(World world, TimelineRecorder recorder, RecordedEdits edits) {
    this.world = world;
    this.recorder = recorder;
    this.edits = edits;
  }

  /**
   * Returns the earliest time that is known.
   *
   * @return {@link #end} minus the duration of the recording, but not before the recording began
   */
  public double start() {
    return recorder.start();
  }

  /**
   * Returns the latest time that is known.
   *
   * @return the time of the world, or the time at which it stopped recording
   */
  public double end() {
    return recorder.end();
  }

  /**
   * Tells whether a thing existed at a given time, and that time is known.
   *
   * @param kind which kind of thing; of walls those exist that the bounds have
   * @param id any number
   * @param t any number
   * @return true if this timeline can be asked for the thing at that time
   */
  public boolean contains(Kind kind, int id, double t) {
    return switch (Check.notNull("kind", kind)) {
      case CIRCLE -> recorder.track(id, t) != null;
      case WALL -> isKnown(t) && world.contains(kind, id);
      case LINE, PEG -> isKnown(t) && rows(kind, id, t).length > 0;
    };
  }

  /**
   * Returns the x coordinate of a circle's centre at a given time.
   *
   * @param id the circle
   * @param t a time from {@link #start} to {@link #end}
   * @return the coordinate; infinite if the circle was beyond the range of doubles
   * @throws IllegalArgumentException if the time is not known, or the circle was not there then
   */
  public double x(int id, double t) {
    return track(id, t).x(t, recorder.walls());
  }

  /**
   * Returns the y coordinate of a circle's centre at a given time.
   *
   * @param id the circle
   * @param t a time from {@link #start} to {@link #end}
   * @return the coordinate; infinite if the circle was beyond the range of doubles
   * @throws IllegalArgumentException if the time is not known, or the circle was not there then
   */
  public double y(int id, double t) {
    return track(id, t).y(t, recorder.walls());
  }

  /**
   * Returns the x component of a circle's velocity at a given time; at an impact, the one after it.
   *
   * @param id the circle
   * @param t a time from {@link #start} to {@link #end}
   * @return the component
   * @throws IllegalArgumentException if the time is not known, or the circle was not there then
   */
  public double vx(int id, double t) {
    FlightHistory track = track(id, t);
    return track.rows.vx(track.find(t), t);
  }

  /**
   * Returns the y component of a circle's velocity at a given time; at an impact, the one after it.
   *
   * @param id the circle
   * @param t a time from {@link #start} to {@link #end}
   * @return the component
   * @throws IllegalArgumentException if the time is not known, or the circle was not there then
   */
  public double vy(int id, double t) {
    FlightHistory track = track(id, t);
    return track.rows.vy(track.find(t), t);
  }

  /**
   * Returns any thing as it was at a given time.
   *
   * @param kind its kind
   * @param id its id
   * @param t a time from {@link #start} to {@link #end}
   * @return a {@link Circle} for a circle or a peg, a {@link Line}, an {@link Outline}, or for a
   *     wall the {@link Bounds}; a coordinate beyond the range of doubles is the largest one
   * @throws IllegalArgumentException if the time is not known, or the thing was not there then
   */
  public Obstacle shape(Kind kind, int id, double t) {
    if (!contains(kind, id, t)) {
      throw unknown(kind, id, t);
    }
    return switch (kind) {
      case CIRCLE -> {
        FlightHistory track = track(id, t);
        Vec2 center = Vec2.within(track.x(t, recorder.walls()), track.y(t, recorder.walls()));
        yield new Circle(center, track.radius(t));
      }
      case LINE -> PublicRecords.lines(rows(kind, id, t), recorder.isSolid(kind.ordinal(), id, t));
      case PEG -> PublicRecords.peg(rows(kind, id, t)[0], 0);
      case WALL -> PublicRecords.bounds(recorder.walls());
    };
  }

  /**
   * Returns the world as it was at a given time: a snapshot that {@link World#restore
   * World.restore} goes on from, with or without edits.
   *
   * <p>It equals the snapshot that the world would have taken when it stood at that time. If the
   * world was edited there, it holds the edits, and the impacts that they caused at once. At the
   * {@linkplain #end end} of the recording such impacts may still be missing: the next step makes
   * them.
   *
   * <p>A call takes time in proportion to the circles, lines and pegs that are recorded. The length
   * of the recording does not matter. If circles in contact moved at that time, the call also plays
   * up to 128 of their ticks again, or the step up to that time if that is longer.
   *
   * <p>To go back more than once, take all snapshots first, or {@link #stop} the recording before
   * the restore: a world that records and is restored begins its recording anew.
   *
   * @param t a time from {@link #start} to {@link #end}
   * @return the snapshot
   * @throws IllegalArgumentException if the time is not known
   */
  public Snapshot snapshot(double t) {
    double goal = checked(t) + 0.0; // 0 for -0
    double stand = recorder.lastStand(goal);
    Snapshot past = new Snapshot(recorder.state(stand));
    if (stand == goal) {
      return past;
    }
    World again = new World(world.scene());
    again.restore(past);
    edits.play(again, goal);
    return again.snapshot();
  }

  /** Stops the recording, if it goes on. What is recorded stays, up to the present time. */
  public void stop() {
    world.stop(recorder);
  }

  /** The rows of a line or a peg at a known time; none if it was not there then. */
  private double[][] rows(Kind kind, int id, double t) {
    return recorder.obstacle(kind.ordinal(), id, t);
  }

  private IllegalArgumentException unknown(Kind kind, int id, double t) {
    checked(t);
    return Check.refused(kind.nameOf(id), "unknown at " + t, "one that was there then");
  }

  private boolean isKnown(double t) {
    return t >= start() && t <= end();
  }

  private double checked(double t) {
    if (!isKnown(t)) {
      throw Check.refused("t", t, "a time of the recording, from " + start() + " to " + end());
    }
    return t;
  }

  private FlightHistory track(int id, double t) {
    FlightHistory track = recorder.track(id, t);
    if (track == null) {
      throw unknown(Kind.CIRCLE, id, t);
    }
    return track;
  }
}
