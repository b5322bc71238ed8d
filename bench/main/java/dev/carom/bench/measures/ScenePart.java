// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** All that one contender's run of a scene tells, but for its time. */
record ScenePart(String scene, Contender contender) implements Part {

  private static final Map<String, Double> SLOW =
      Map.of("substeps-32", 3.0, "substeps-64", 6.0, "substeps-128", 12.0, "substeps-256", 24.0);

  @Override
  public String id() {
    return String.join("/", "scene", scene, contender.id());
  }

  /** Methods of many small steps take as long as all others together. */
  @Override
  public double seconds() {
    return SLOW.getOrDefault(contender.id(), 1.5);
  }

  @Override
  public List<Row> run() {
    Trial trial = new Trial(scene, contender);
    try {
      return measure(trial, Subjects.load(scene));
    } catch (UnsupportedOperationException | LinkageError e) {
      return List.of(trial.row("frame_error", "max", Double.NaN, Trial.RADII, 0), trial.failure(e));
    }
  }

  static List<Row> measure(Trial trial, Subject subject) {
    RecordedRun run = RecordedRun.play(trial.contender(), subject.scene(), subject.frames());
    List<Row> rows = new ArrayList<>();
    run.failure().ifPresent(reason -> rows.add(trial.failure(reason)));
    subject
        .reference()
        .ifPresent(
            reference -> {
              rows.addAll(FrameError.rows(trial, subject, reference));
              rows.addAll(new TrajectoryError(subject.scene(), run, reference).rows(trial));
            });
    rows.addAll(new Solidity(subject.scene(), run).rows(trial));
    rows.addAll(new Energy(run).rows(trial));
    rows.addAll(new ReversalError(trial.contender(), subject.scene()).rows(trial));
    rows.addAll(run.counters().rows(trial));
    return rows;
  }
}
