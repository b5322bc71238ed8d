// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.World;
import dev.carom.bench.replay.Counted;
import java.io.IOException;
import java.util.Locale;

/** A scene played frame by frame, in front of a recorder. */
final class Simulation {

  /** The most impacts that a call lists in the log: their rows take some 160 MB. */
  private static final long WORK = 2_000_000;

  private final World world;
  private final Recorder recorder;
  private long impacts;
  private long wallImpacts;
  private long jammed;
  private long settled;

  Simulation(Scene scene, Recorder recorder) {
    world = new World(scene);
    this.recorder = recorder;
  }

  /** Frame k ends at k dt, rounded once: time does not gather the rounding of frames. */
  void play(int frames, double dt) throws IOException {
    for (int k = 0; k < frames; k++) {
      int frame = k + 1;
      boolean complete;
      do {
        complete = world.advanceTo(frame * dt, WORK);
        count(world.impacts());
        recorder.recordImpacts(world.impacts());
      } while (!complete);
      recorder.recordPositions(frame, world);
    }
  }

  private void count(ImpactLog log) {
    impacts += log.size();
    for (int row = 0; row < log.size(); row++) {
      wallImpacts += log.kind(row) == Kind.WALL ? 1 : 0;
      jammed += log.outcome(row) == Outcome.JAMMED ? 1 : 0;
      settled += log.outcome(row) == Outcome.SETTLED ? 1 : 0;
    }
  }

  /** The run in one line. */
  String summary() {
    String line =
        String.format(
            Locale.ROOT,
            "time %s: %s, %s, %,d of them with walls",
            Decimals.shortest(world.now()),
            Counted.of(world.count(Kind.CIRCLE), "circle"),
            Counted.of(impacts, "impact"),
            wallImpacts);
    return line + times(jammed, "jammed") + times(settled, "settled");
  }

  private static String times(long count, String outcome) {
    return count == 0 ? "" : ", " + Counted.of(count, "time") + " " + outcome;
  }
}
