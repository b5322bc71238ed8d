// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/** Records the flights of circles, and the positions of lines and pegs at each change. */
public final class FlightRecorder {

  private final int most;
  private final IntUnaryOperator ids;
  private FlightHistories tracks;
  private ObstacleHistory obstacles;
  private ObstacleTable here;
  private double begin;
  private double end;

  // Flights of a step that may still be rolled back: the ids of their circles, and their rows.
  private int[] pendingIds = new int[16];
  private double[] pending = new double[16 * FlightHistory.FLIGHT];
  private int pendings;

  /**
   * Creates a recorder that has yet to {@linkplain #begin begin}.
   *
   * @param most the number of flights to keep of each circle, and of changes of each line and peg
   * @param ids maps the slot of a circle to its id
   */
  public FlightRecorder(int most, IntUnaryOperator ids) {
    this.most = most;
    this.ids = ids;
  }

  /** The earliest time from which the recording is complete. */
  public double start() {
    return Math.max(begin, Math.max(obstacles.start(), tracks.start()));
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
    return obstacles.at(code, t);
  }

  /** The walls, as {@link ObstacleTable#walls}. */
  public double[] walls() {
    return here.walls;
  }

  /**
   * Discards the recording, and begins a new one at a given time with the static obstacles of that
   * time.
   */
  public void begin(double now, ObstacleTable here) {
    tracks = new FlightHistories(most);
    obstacles = new ObstacleHistory(here, most);
    this.here = here;
    begin = now;
    end = now;
    pendings = 0;
  }

  /** Adds a flight of the current step, which {@link #undo} may still drop. */
  public void note(MovingCircle m) {
    if (pendings == pendingIds.length) {
      pendingIds = Arrays.copyOf(pendingIds, 2 * pendings);
      pending = Arrays.copyOf(pending, 2 * pendings * FlightHistory.FLIGHT);
    }
    pendingIds[pendings] = ids.applyAsInt(m.id);
    FlightHistory.put(m, here, pending, pendings * FlightHistory.FLIGHT);
    pendings++;
  }

  /** Drops the flights of the current step. */
  public void undo() {
    pendings = 0;
  }

  /** Adds a flight that cannot be undone. */
  public void add(MovingCircle m) {
    note(m);
    keep();
  }

  /** Commits the flights of the current step, which ended at a given time. */
  public void advance(double now) {
    keep();
    end = now;
  }

  private void keep() {
    for (int i = 0; i < pendings; i++) {
      tracks.add(pendingIds[i], pending, i * FlightHistory.FLIGHT);
    }
    pendings = 0;
  }

  /** Records that a line or a peg was added, changed or removed. */
  public void noteObstacle(int code, ObstacleTable here, double now) {
    obstacles.note(code, here, now);
  }

  public void remove(int id, double now) {
    tracks.remove(id, now);
  }
}
