// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.Kind;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;

/** The lines and pegs during a recording: the ones at its start, and each change since. */
final class ObstacleHistory {

  /** An obstacle from a time on. */
  private static final class State {

    /** Where it was at a time that its motion knows; null once it is removed. */
    final double[] row;

    final int traits;
    final long filter;

    /** Its motion; as number 0; null if it never moved. */
    final ObstacleMotions motion;

    State(ObstacleTable here, int code) {
      boolean gone = here.isGone(code);
      row = gone ? null : here.row(code);
      traits = gone ? 0 : here.traits(code);
      filter = gone ? Filter.DEFAULT : here.filter(code);
      motion = !gone && here.moves(code) ? here.motions().only(code) : null;
    }

    double[] at(double t, int coordinates) {
      if (row == null || motion == null) {
        return row;
      }
      double[] placed = row.clone();
      double dt = motion.elapsed(0, t, 0);
      for (int c = 0; c < coordinates; c++) {
        placed[c] = motion.after(0, c, row[c], dt);
      }
      return placed;
    }
  }

  private final ObstacleTable first;
  private final int most;
  private final Map<Integer, Changes<State>> changes = new HashMap<>();

  /** The codes of removed obstacles in order of removal, and the number of their kept changes. */
  private final Deque<Integer> removed = new ArrayDeque<>();

  private long changesOfRemoved;

  /** One more than the largest code that was given, of each kind. */
  private final int[] ends = new int[Kind.CIRCLE];

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
    ObstacleTable.kindsOfRows().forEach(kind -> ends[kind] = first.ofKind(kind).end);
  }

  double start() {
    return start;
  }

  /** Records that a line or a peg was added, changed or removed at a given time. */
  void note(int code, ObstacleTable now, double t) {
    Changes<State> ofThis = changes.computeIfAbsent(code, this::newChanges);
    ends[Codes.kind(code)] = Math.max(ends[Codes.kind(code)], code + 1);
    ofThis.add(t, new State(now, code));
    if (ofThis.keep(most)) {
      start = Math.max(start, ofThis.start());
    }
    if (now.isGone(code)) {
      remove(code, ofThis.size());
    }
  }

  private Changes<State> newChanges(int code) {
    if (!isFirst(code)) {
      present++;
      mostPresent = Math.max(mostPresent, present);
    }
    return new Changes<>();
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
    Changes<State> dropped = changes.remove(code);
    changesOfRemoved -= dropped.size();
    dropped.keep(1);
    start = Math.max(start, dropped.start());
    if (isFirst(code)) {
      changes.put(code, dropped); // else it would still seem to exist
    }
  }

  /** The row of an obstacle at a given time; null if it did not exist then. */
  double[] at(int code, double t) {
    State its = state(code, t);
    return its == null ? null : its.at(t, first.of(code).shape.coordinates);
  }

  /** An obstacle at a given time; null if it did not exist by then. */
  private State state(int code, double t) {
    Changes<State> ofThis = changes.get(code);
    State changed = ofThis == null ? null : ofThis.at(t);
    return changed == null && isFirst(code) ? new State(first, code) : changed;
  }

  /** All obstacles at a given time; the properties of the walls then are given. */
  ObstacleTable at(double t, double restitution, int traits, long filter) {
    if (changes.isEmpty()) {
      ObstacleTable same = first.copy();
      same.boundsRestitution = restitution;
      same.boundsTraits = traits;
      same.setFilter(Codes.LEFT, filter);
      return same;
    }
    ObstacleRows[] rows =
        ObstacleTable.kindsOfRows().mapToObj(kind -> rowsAt(kind, t)).toArray(ObstacleRows[]::new);
    ObstacleTable then = ObstacleTable.of(first.walls, restitution, traits, filter, rows);
    then.setMotions(motionsAt(t));
    return then;
  }

  private ObstacleRows rowsAt(int kind, double t) {
    int from = Codes.of(kind, 0);
    int count = endAt(kind, t) - from;
    int width = ObstacleTable.width(kind);
    double[] rows = new double[count * width];
    Arrays.fill(rows, Double.NaN);
    byte[] traits = new byte[count];
    long[] filters = Filter.defaults(count);
    for (int i = 0; i < count; i++) {
      State its = state(from + i, t);
      if (its != null && its.row != null) {
        System.arraycopy(its.row, 0, rows, i * width, width);
        traits[i] = (byte) its.traits;
        filters[i] = its.filter;
      }
    }
    return ObstacleTable.rows(kind, rows, traits, Filter.unlessDefault(filters, count));
  }

  /** One more than the largest code of a kind that was given by a time. */
  private int endAt(int kind, double t) {
    int low = first.ofKind(kind).end;
    int high = ends[kind];
    while (low < high) {
      int middle = (low + high) >>> 1;
      Changes<State> its = changes.get(middle);
      if (its == null || its.start() <= t) { // null: it is dropped
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  private ObstacleMotions motionsAt(double t) {
    IntStream.Builder codes = IntStream.builder();
    DoubleList motions = new DoubleList();
    for (ObstacleRows ofKind : first.kinds) {
      int end = endAt(Codes.kind(ofKind.first()), t);
      for (int code = ofKind.first(); code < end; code++) {
        State its = state(code, t);
        if (its != null && its.motion != null) {
          codes.add(code);
          motions.add(its.motion.motion(0));
        }
      }
    }
    return ObstacleMotions.of(codes.build().toArray(), motions.toArray());
  }

  /** Whether an obstacle existed when the recording began. */
  private boolean isFirst(int code) {
    return code < first.of(code).end && !first.isGone(code);
  }
}
