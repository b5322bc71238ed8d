// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.TimelineRecorder;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Consumer;

/**
 * The edits of a recorded world, as calls: contact is found by playing on from a stand, through the
 * edits that followed.
 */
final class RecordedEdits {

  private record Edit(double time, Consumer<World> call) {}

  private final TimelineRecorder recorder;
  private final Deque<Edit> edits = new ArrayDeque<>();

  RecordedEdits(TimelineRecorder recorder) {
    this.recorder = recorder;
  }

  /** Adds an edit that was made now, unless a stand follows; drops those before the first stand. */
  void add(Consumer<World> call) {
    if (recorder.isStandDue()) {
      return;
    }
    double horizon = recorder.horizon();
    while (!edits.isEmpty() && edits.getFirst().time() <= horizon) {
      edits.removeFirst();
    }
    edits.addLast(new Edit(recorder.end(), call));
  }

  void clear() {
    edits.clear();
  }

  /** Plays a world on from a stand, of which the edits of its time are part. */
  void play(World world, double goal) {
    double stand = world.now();
    for (Edit edit : edits) {
      if (stand < edit.time() && edit.time() <= goal) {
        if (edit.time() > world.now()) {
          world.advanceTo(edit.time(), Long.MAX_VALUE);
        }
        edit.call().accept(world);
      }
    }
    world.advanceTo(goal, Long.MAX_VALUE);
  }
}
