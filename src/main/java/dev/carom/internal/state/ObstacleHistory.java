// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.KindNumber;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Map;
import java.util.Queue;
import java.util.SortedMap;
import java.util.TreeMap;

/** The lines and pegs during a recording: the ones at its start, and each change since. */
final class ObstacleHistory {

  /** An obstacle from a time on. */
  private static final class State {

    /** Where it was at a time that its motion knows; null once it is removed. */
    final double[] row;

    final int traits;
    final long filter;

    /** Its motion, as number 0; null if it never moved. */
    final ObstacleMotions motion;

    State(ObstacleTable here, int code) {
      boolean gone = here.isGone(code);
      row = gone ? null : here.row(code);
      traits = gone ? 0 : here.traits(code);
      filter = gone ? FilterBits.DEFAULT : here.filter(code);
      motion = !gone && here.moves(code) ? here.motions().only(code) : null;
    }

    double[] at(double t, int coordinates) {
      if (row == null || motion == null) {
        return row;
      }
      double[] placed = row.clone();
      motion.place(0, t, 0, row, 0, placed, 0, coordinates);
      return placed;
    }

    /** Puts it, but for its motion, in a table of which it may be the next of its kind. */
    void put(ObstacleTable all, int code) {
      int numbers = all.of(code).shape.restitution;
      double[] its = row == null ? new double[numbers] : Arrays.copyOf(row, numbers);
      if (code == all.of(code).end) {
        all.add(Codes.kind(code), its);
      } else {
        all.move(code, its, 0);
      }
      if (row == null) {
        all.remove(code);
      } else {
        all.setRestitution(code, row[numbers]);
        all.setTraits(code, traits);
        all.setFilter(code, filter);
      }
    }
  }

  /** The obstacles as they were before all changes that are kept. */
  private final ObstacleTable first;

  private final SortedMap<Integer, Changes<State>> changes = new TreeMap<>();

  /** The codes of removed obstacles in order of removal. */
  private final Queue<Integer> removed = new ArrayDeque<>();

  /** One more than the largest code of those that were dropped, of each kind. */
  private final int[] ends = new int[KindNumber.CIRCLE];

  /** Begins a recording with the current obstacles. */
  ObstacleHistory(ObstacleTable now) {
    first = now.copy();
  }

  /**
   * Records that a line or a peg was added, changed or removed at a given time.
   *
   * @param horizon what ended by this time may be dropped
   */
  void note(int code, ObstacleTable now, double t, double horizon) {
    Changes<State> its = changes.computeIfAbsent(code, any -> new Changes<>());
    its.set(t, new State(now, code), horizon);
    if (now.isGone(code)) {
      removed.add(code);
    }
  }

  /** Drops the obstacles that were removed by a time. */
  void forget(double time) {
    while (!removed.isEmpty() && changes.get(removed.element()).since() <= time) {
      int code = removed.remove();
      changes.remove(code);
      if (isFirst(code)) {
        first.remove(code);
      } else {
        ends[Codes.kind(code)] = Math.max(ends[Codes.kind(code)], code + 1);
      }
    }
  }

  /** Whether an obstacle existed when the recording began. */
  private boolean isFirst(int code) {
    return code < first.of(code).end;
  }

  /** The row of an obstacle at a given time; null if it did not exist then. */
  double[] at(int code, double t) {
    State its = state(code, t);
    return its == null ? null : its.at(t, first.of(code).shape.coordinates);
  }

  /** Where an obstacle that existed at a time was outside, see {@link ObstacleTable#outside}. */
  int outside(int code, double t) {
    return ContactFlags.outside(state(code, t).traits);
  }

  /** An obstacle at a given time; null if it did not exist by then. */
  private State state(int code, double t) {
    Changes<State> its = changes.get(code);
    State changed = its == null ? null : its.at(t);
    return changed == null && isFirst(code) ? new State(first, code) : changed;
  }

  /**
   * All obstacles at a given time; the properties of the walls then are given.
   *
   * @param now a later table: ids do not change
   */
  ObstacleTable at(ObstacleTable now, double t, double restitution, int traits, long filter) {
    ObstacleTable then = first.copy();
    then.boundsRestitution = restitution;
    then.boundsTraits = traits;
    then.setFilter(Codes.LEFT, filter);
    ObstacleMotions motions = then.motions();
    then.setMotions(ObstacleMotions.NONE);
    for (Map.Entry<Integer, Changes<State>> each : changes.entrySet()) {
      State its = each.getValue().at(t);
      if (its != null) {
        fill(then, then.of(each.getKey()), each.getKey());
        its.put(then, each.getKey());
        motions = motions.with(each.getKey(), its.motion);
      }
    }
    then.setMotions(motions);
    then.kinds.forEach(rows -> fill(then, rows, ends[rows.kind()]));
    then.kinds.forEach(rows -> rows.joinAs(now.ofKind(rows.kind())));
    return then;
  }

  /** Adds rows of removed obstacles up to a code. */
  private static void fill(ObstacleTable all, ObstacleRows rows, int end) {
    while (rows.end < end) {
      all.remove(rows.add(new double[rows.shape.restitution]));
    }
  }
}
