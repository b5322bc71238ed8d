// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Where lines and pegs were during a recording: what was there first, and each change since. */
final class PastObstacles {

  /** A thing from a time on; null where it is gone. */
  private record Change(double from, Obstacle thing) {}

  private final Obstacles first;
  private final int most;
  private final Map<Integer, List<Change>> changes = new HashMap<>();

  /** From when on everything is known: later than the start once changes were dropped. */
  private double start = Double.NEGATIVE_INFINITY;

  /**
   * Begins with what is there.
   *
   * @param most how many changes to keep of each thing; beyond that the oldest are dropped
   */
  PastObstacles(Obstacles now, int most) {
    first = now.copy();
    this.most = most;
  }

  double start() {
    return start;
  }

  /** Notes that a line or a peg is new, elsewhere, or gone, from a given time on. */
  void note(int code, Obstacles now, double t) {
    List<Change> ofThis = changes.computeIfAbsent(code, none -> new ArrayList<>());
    ofThis.add(new Change(t, now.isGone(code) ? null : now.thing(code)));
    if (ofThis.size() > most) {
      ofThis.remove(0);
      start = Math.max(start, ofThis.get(0).from());
    }
  }

  /** What had a code at a given time, null if nothing had it then. */
  Obstacle at(int code, double t) {
    List<Change> ofThis = changes.getOrDefault(code, List.of());
    for (int i = ofThis.size() - 1; i >= 0; i--) {
      if (ofThis.get(i).from() <= t) {
        return ofThis.get(i).thing();
      }
    }
    int end = code < Obstacles.PEGS ? first.endOfLines : first.endOfPegs;
    return code < end && !first.isGone(code) ? first.thing(code) : null;
  }
}
