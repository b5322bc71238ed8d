// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * How far a run is from the true course, and when it is lost: its horizon is the first frame at
 * whose end a circle is more than {@value #LOST} radii from its true place, and one more than the
 * number of frames if that does not happen.
 */
final class TrajectoryError {

  /** In radii. */
  static final double LOST = 0.1;

  private final Scene scene;
  private final RecordedRun run;
  private final Reference reference;

  TrajectoryError(Scene scene, RecordedRun run, Reference reference) {
    this.scene = scene;
    this.run = run;
    this.reference = reference;
  }

  List<Row> rows(Trial trial) {
    List<Row> rows = new ArrayList<>();
    Quantiles horizons = new Quantiles(horizons());
    int n = horizons.size();
    rows.add(trial.row("horizon", "any", horizons.at(0), Trial.FRAMES, n));
    rows.add(trial.row("horizon", "median", horizons.median(), Trial.FRAMES, n));
    rows.addAll(Drift.rows(trial, "drift_trajectory", Trial.RADII, run.frames(), this::errors));
    return rows;
  }

  private double[] horizons() {
    double[] horizons = new double[run.circles()];
    Arrays.fill(horizons, run.frames() + 1);
    for (int frame = run.frames(); frame > 0; frame--) {
      double[] errors = errors(frame);
      for (int i = 0; i < errors.length; i++) {
        if (!(errors[i] <= LOST)) {
          horizons[i] = frame;
        }
      }
    }
    return horizons;
  }

  private double[] errors(int frame) {
    double[] errors = new double[run.circles()];
    Arrays.setAll(
        errors,
        i ->
            Math.hypot(
                    run.x(frame, i) - reference.x(frame, i),
                    run.y(frame, i) - reference.y(frame, i))
                / ((Circle) scene.shape(Kind.CIRCLE, i)).radius());
    return errors;
  }
}
