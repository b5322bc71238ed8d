// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.TreeMap;

/** Whether a timeline gives the places and velocities that a world gave when it stood there. */
final class PastCheck {

  private final World world;
  private final Timeline past;

  /** The states of each circle, by the times at which the world left them. */
  private final TreeMap<Integer, TreeMap<Double, Run.State>> seen = new TreeMap<>();

  /** The snapshot that was taken last at each time. */
  private final TreeMap<Double, Snapshot> snapshots = new TreeMap<>();

  PastCheck(World world) {
    this.world = world;
    past = world.record(Double.POSITIVE_INFINITY);
  }

  /** After a step: impacts at once changed what was seen when it began. */
  void forget(double time) {
    seen.values().forEach(states -> states.remove(time));
    snapshots.remove(time);
  }

  /** Before or after a step: what is seen last at a time counts. */
  void look() {
    snapshots.put(world.now(), world.snapshot());
    for (int i = 0; i < world.idLimit(Kind.CIRCLE); i++) {
      if (world.contains(Kind.CIRCLE, i)) {
        Run.State state = new Run.State(world.x(i), world.y(i), world.vx(i), world.vy(i));
        seen.computeIfAbsent(i, k -> new TreeMap<>()).put(world.now(), state);
      }
    }
  }

  /** Compares all that is still recorded, and returns how much that is. */
  int compare() {
    look();
    int compared = compareSnapshots();
    for (int i : seen.keySet()) {
      for (double t : seen.get(i).keySet()) {
        if (past.contains(Kind.CIRCLE, i, t)) {
          Run.State then = new Run.State(past.x(i, t), past.y(i, t), past.vx(i, t), past.vy(i, t));
          assertThat(then).as("circle %s at %s", i, t).isEqualTo(seen.get(i).get(t));
          compared++;
        }
      }
    }
    return compared;
  }

  private int compareSnapshots() {
    snapshots.tailMap(past.start()).forEach(this::compare);
    return snapshots.size();
  }

  private void compare(double t, Snapshot snapshot) {
    assertThat(SnapshotParts.of(past.snapshot(t)))
        .as("at %s", t)
        .isEqualTo(SnapshotParts.of(snapshot));
    assertThat(past.snapshot(t)).as("at %s", t).isEqualTo(snapshot);
  }
}
