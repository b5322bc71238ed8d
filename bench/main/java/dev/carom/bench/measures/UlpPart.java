// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.results.Row;
import java.util.List;

/**
 * The effect of a last bit: the scene started one ulp away, played by this library. No method in
 * doubles can be expected to stay longer with the true course.
 */
record UlpPart(String scene) implements Part {

  private static final Contender NUDGED =
      new Contender(
          "reference-1ulp",
          "reference+1ulp",
          "",
          scene -> Methods.CAROM.start(States.oneUlpAway(scene)));

  @Override
  public String id() {
    return String.join("/", "scene", scene, NUDGED.id());
  }

  /** The first part of a scene reads, or computes, its true course. */
  @Override
  public double seconds() {
    return 2;
  }

  @Override
  public List<Row> run() {
    Subject subject = Subjects.load(scene);
    return subject
        .reference()
        .map(
            reference -> {
              RecordedRun run = RecordedRun.play(NUDGED, subject.scene(), subject.frames());
              return new TrajectoryError(subject.scene(), run, reference)
                  .rows(new Trial(scene, NUDGED));
            })
        .orElse(List.of());
  }
}
