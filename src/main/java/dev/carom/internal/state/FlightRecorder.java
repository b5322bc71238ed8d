// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/** Records the flights of circles, and where lines and pegs were at their changes. */
public final class FlightRecorder {

  private final int most;
  private final IntUnaryOperator ids;
  private FlightHistories tracks;
  private ObstacleHistory obstacles;
  private double[] walls;
  private double begin;
  private double end;

  // Flights of a step that may still be rolled back: their circles, and their numbers.
  private int[] pendingIds = new int[16];
  private double[] pending = new double[16 * FlightHistory.FLIGHT];
  private int pendings;

  /**
   * A recorder that has yet to {@linkplain #begin begin}.
   *
   * @param most how many flights to keep of each circle, and changes of each line and peg
   * @param ids the id of the circle at a slot
   */
  public FlightRecorder(int most, IntUnaryOperator ids) {
    this.most = most;
    this.ids = ids;
  }

  /** From when on everything is known. */
  public double start() {
    return Math.max(begin, Math.max(obstacles.start(), tracks.start()));
  }

  /** Up to when everything is known. */
  public double end() {
    return end;
  }

  /** The track of a circle that was there at a given time, null if none is known. */
  public FlightHistory track(int id, double t) {
    FlightHistory track = tracks.get(id);
    boolean known = track != null && t >= track.start() && t < track.end() && t <= end;
    return known ? track : null;
  }

  /** The row of the line or peg that had a code at a given time, null if nothing had it then. */
  public double[] obstacle(int code, double t) {
    return obstacles.at(code, t);
  }

  /** The walls around all circles, as {@link ObstacleTable#walls}. */
  public double[] walls() {
    return walls;
  }

  /** Forgets all, and begins at a given time, with what stands still then. */
  public void begin(double now, ObstacleTable here) {
    tracks = new FlightHistories(most);
    obstacles = new ObstacleHistory(here, most);
    walls = here.walls;
    begin = now;
    end = now;
    pendings = 0;
  }

  /** Notes a flight of the step in hand. */
  public void note(MovingCircle m) {
    if (pendings == pendingIds.length) {
      pendingIds = Arrays.copyOf(pendingIds, 2 * pendings);
      pending = Arrays.copyOf(pending, 2 * pendings * FlightHistory.FLIGHT);
    }
    pendingIds[pendings] = ids.applyAsInt(m.id);
    FlightRow.put(m, pending, pendings * FlightHistory.FLIGHT);
    pendings++;
  }

  /** Drops what was noted in the step in hand. */
  public void undo() {
    pendings = 0;
  }

  /** Adds a flight for good. */
  public void add(MovingCircle m) {
    note(m);
    keep();
  }

  /** The step in hand is done: the world stands at a given time. */
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

  /** Notes that a line or a peg is new, elsewhere, or gone. */
  public void noteObstacle(int code, ObstacleTable here, double now) {
    obstacles.note(code, here, now);
  }

  public void remove(int id, double now) {
    tracks.remove(id, now);
  }
}
