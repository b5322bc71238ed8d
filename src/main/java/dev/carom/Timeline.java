// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.FlightHistory;
import dev.carom.internal.state.FlightRecorder;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Kind;
import java.util.Optional;

/**
 * The recorded flights of a world's circles: where each was, and how it moved, at any moment from
 * the start of the recording to now, forwards and backwards, to the bit as the world gave it when
 * it stood there: after the edits of that moment, and the impacts that they brought about at once.
 * It takes 56 bytes a flight, so its size follows the impacts, not the steps; it is bounded, and so
 * is what is kept of circles that were removed: see {@link World#record World.record}. Where lines
 * and pegs were is recorded too, at their changes.
 *
 * <pre>{@code
 * World world =
 *     new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 8, 0).build());
 * Timeline past = world.record(100);
 * world.step(6);
 * System.out.println(past.x(0, 2.5) + ", " + past.x(0, 5.5)); // 70.0, 86.0
 * }</pre>
 *
 * <p>A world records what it does itself, and edits; when a snapshot is restored into it, the
 * recording begins anew. Not safe for use by several threads.
 */
public final class Timeline {

  private final FlightRecorder recorder;

  Timeline(FlightRecorder recorder) {
    this.recorder = recorder;
  }

  /**
   * From when on everything is known.
   *
   * @return the time at which the recording began; later, if its bound made it drop flights, or
   *     circles that were removed
   */
  public double start() {
    return recorder.start();
  }

  /**
   * Up to when everything is known.
   *
   * @return the time of the world, or that at which it stopped to record
   */
  public double end() {
    return recorder.end();
  }

  /**
   * Whether a circle was there at a given time, and is recorded.
   *
   * @param id the circle, any number
   * @param t a time, any number
   * @return whether it can be asked for
   */
  public boolean contains(int id, double t) {
    return recorder.track(id, t) != null;
  }

  /**
   * The x coordinate of a circle's centre at a given time.
   *
   * @param id the circle
   * @param t a time within the recording
   * @return the coordinate; infinite if the circle was beyond the range of doubles
   * @throws IllegalArgumentException if the circle was not there then, or is not recorded
   */
  public double x(int id, double t) {
    FlightHistory track = track(id, t);
    return track.x(track.find(t), t, recorder.walls());
  }

  /**
   * The y coordinate of a circle's centre at a given time.
   *
   * @param id the circle
   * @param t a time within the recording
   * @return the coordinate; infinite if the circle was beyond the range of doubles
   * @throws IllegalArgumentException if the circle was not there then, or is not recorded
   */
  public double y(int id, double t) {
    FlightHistory track = track(id, t);
    return track.y(track.find(t), t, recorder.walls());
  }

  /**
   * The x component of a circle's velocity at a given time; at an impact, the one after it.
   *
   * @param id the circle
   * @param t a time within the recording
   * @return the component
   * @throws IllegalArgumentException if the circle was not there then, or is not recorded
   */
  public double vx(int id, double t) {
    FlightHistory track = track(id, t);
    return track.vx(track.find(t));
  }

  /**
   * The y component of a circle's velocity at a given time; at an impact, the one after it.
   *
   * @param id the circle
   * @param t a time within the recording
   * @return the component
   * @throws IllegalArgumentException if the circle was not there then, or is not recorded
   */
  public double vy(int id, double t) {
    FlightHistory track = track(id, t);
    return track.vy(track.find(t));
  }

  /**
   * The radius of a circle at a given time.
   *
   * @param id the circle
   * @param t a time within the recording
   * @return more than 0
   * @throws IllegalArgumentException if the circle was not there then, or is not recorded
   */
  public double radius(int id, double t) {
    FlightHistory track = track(id, t);
    return track.radius(track.find(t));
  }

  /**
   * A line as it was at a given time.
   *
   * @param id the line
   * @param t a time within the recording
   * @return the line; empty if it was not there then
   * @throws IllegalArgumentException if the time is not within the recording
   */
  public Optional<Line> line(int id, double t) {
    double time = checked(t);
    return !isId(Kind.LINE, id)
        ? Optional.empty()
        : Optional.ofNullable(recorder.obstacle(Codes.line(id), time))
            .map(row -> PublicRecords.line(row, 0));
  }

  /**
   * A peg as it was at a given time.
   *
   * @param id the peg
   * @param t a time within the recording
   * @return the peg; empty if it was not there then
   * @throws IllegalArgumentException if the time is not within the recording
   */
  public Optional<Circle> peg(int id, double t) {
    double time = checked(t);
    return !isId(Kind.PEG, id)
        ? Optional.empty()
        : Optional.ofNullable(recorder.obstacle(Codes.peg(id), time))
            .map(row -> PublicRecords.peg(row, 0));
  }

  private static boolean isId(int kind, int id) {
    return id >= 0 && id < Codes.limit(kind);
  }

  private double checked(double t) {
    if (!(t >= start() && t <= end())) {
      throw Check.refused("t", t, "a time of the recording, from " + start() + " to " + end());
    }
    return t;
  }

  private FlightHistory track(int id, double t) {
    FlightHistory track = recorder.track(id, t);
    if (track == null) {
      checked(t);
      throw Check.refused("circle " + id, "unknown at " + t, "one that was there then");
    }
    return track;
  }
}
