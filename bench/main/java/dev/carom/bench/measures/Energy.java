// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The kinetic energy of each circle, which no impact of an elastic scene changes. */
final class Energy {

  private final RecordedRun run;

  Energy(RecordedRun run) {
    this.run = run;
  }

  /** The drift is that of the worst circle at the worst frame: |E/E0 - 1|. */
  List<Row> rows(Trial trial) {
    double worst = 0;
    for (int frame = 1; frame <= run.frames(); frame++) {
      for (double change : changes(frame)) {
        worst = Double.isNaN(change) ? change : Math.max(worst, Math.abs(change));
      }
    }
    List<Row> rows = new ArrayList<>();
    rows.add(trial.row("energy_drift", "max", worst, Trial.ONE, run.circles()));
    rows.addAll(Drift.rows(trial, "drift_energy", Trial.ONE, run.frames(), this::changes));
    return rows;
  }

  private double[] changes(int frame) {
    double[] changes = new double[run.circles()];
    Arrays.setAll(
        changes,
        i -> {
          double before = run.speed(0, i);
          double ratio = run.speed(frame, i) / before;
          return before == 0 ? run.speed(frame, i) : (ratio - 1) * (ratio + 1);
        });
    return changes;
  }
}
