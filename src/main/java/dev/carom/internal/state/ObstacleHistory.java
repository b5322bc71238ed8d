// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The lines and pegs during a recording: the ones at its start, and each change since. */
final class ObstacleHistory {

  /** An obstacle from a time on. */
  private static final class Change {

    final double from;

    /** Where it was at a time since when it moves with a velocity; null once it is removed. */
    final double[] row;

    final double since;
    final double ux;
    final double uy;

    /** From a time t on, obstacle code as it is now. */
    Change(double t, int code, ObstacleTable now) {
      from = t;
      row = now.isGone(code) ? null : now.row(code);
      since = now.moves(code) ? now.motions().since(now.motions().indexOf(code)) : t;
      ux = now.ux(code);
      uy = now.uy(code);
    }

    double[] at(double t, int coordinates) {
      if (row == null || (ux == 0 && uy == 0)) {
        return row;
      }
      double[] placed = row.clone();
      ObstacleMotions.shift(placed, coordinates, ux, uy, t - since);
      return placed;
    }
  }

  private final ObstacleTable first;
  private final int most;
  private final Map<Integer, List<Change>> changes = new HashMap<>();

  /** The codes of removed obstacles in order of removal, and the number of their kept changes. */
  private final Deque<Integer> removed = new ArrayDeque<>();

  private long changesOfRemoved;

  private int present;
  private int mostPresent;

  /**
   * The earliest time from which the history is complete: later than the start of the recording
   * once changes were dropped.
   */
  private double start = Double.NEGATIVE_INFINITY;

  /**
   * Begins a recording with the current obstacles.
   *
   * @param most the number of changes to keep of each obstacle; the oldest are dropped
   */
  ObstacleHistory(ObstacleTable now, int most) {
    first = now.copy();
    this.most = most;
    present = first.size();
    mostPresent = present;
  }

  double start() {
    return start;
  }

  /** Records that a line or a peg was added, changed or removed at a given time. */
  void note(int code, ObstacleTable now, double t) {
    List<Change> ofThis = changes.computeIfAbsent(code, this::newChanges);
    boolean gone = now.isGone(code);
    ofThis.add(new Change(t, code, now));
    if (ofThis.size() > most) {
      ofThis.remove(0);
      start = Math.max(start, ofThis.get(0).from);
    }
    if (gone) {
      remove(code, ofThis.size());
    }
  }

  private List<Change> newChanges(int code) {
    if (!isFirst(code)) {
      present++;
      mostPresent = Math.max(mostPresent, present);
    }
    return new ArrayList<>();
  }

  /** Counts an obstacle as removed, and drops those removed first if there is no room. */
  private void remove(int code, int itsChanges) {
    present--;
    removed.add(code);
    changesOfRemoved += itsChanges;
    while (changesOfRemoved > (long) most * mostPresent) {
      dropFirst();
    }
  }

  private void dropFirst() {
    int code = removed.remove();
    List<Change> dropped = changes.remove(code);
    Change last = dropped.get(dropped.size() - 1);
    changesOfRemoved -= dropped.size();
    start = Math.max(start, last.from);
    if (isFirst(code)) {
      changes.put(code, List.of(last)); // else it would still seem to exist
    }
  }

  /** The row of an obstacle at a given time; null if it did not exist then. */
  double[] at(int code, double t) {
    List<Change> ofThis = changes.getOrDefault(code, List.of());
    for (int i = ofThis.size() - 1; i >= 0; i--) {
      if (ofThis.get(i).from <= t) {
        return ofThis.get(i).at(t, first.of(code).shape.coordinates);
      }
    }
    return isFirst(code) ? first.rowAt(code, t, 0) : null;
  }

  /** Whether an obstacle existed when the recording began. */
  private boolean isFirst(int code) {
    return code < first.of(code).end && !first.isGone(code);
  }
}
