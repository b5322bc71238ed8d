// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Whether lines and walls hold: how deep circles reach into them at the end of a frame, how many
 * circles ever get through a line, and how many ever leave the bounds, or are outside at the end.
 */
final class Solidity {

  private final SolidScene solid;
  private final RecordedRun run;

  Solidity(Scene scene, RecordedRun run) {
    solid = new SolidScene(scene);
    this.run = run;
  }

  List<Row> rows(Trial trial) {
    List<Row> rows = new ArrayList<>();
    long n = (long) run.frames() * run.circles();
    rows.add(trial.row("penetration", "max", deepest(), Trial.RADII, n));
    rows.add(trial.row("tunnelled", "circles", tunnelled(), Trial.ONE, run.circles()));
    rows.add(trial.row("escaped", "circles", escaped(0), Trial.ONE, run.circles()));
    int end = run.frames();
    rows.add(trial.row("outside_at_end", "circles", escaped(end), Trial.ONE, run.circles()));
    rows.addAll(Drift.rows(trial, "drift_penetration", Trial.RADII, run.frames(), this::depths));
    return rows;
  }

  private double deepest() {
    double deepest = 0;
    for (int frame = 1; frame <= run.frames(); frame++) {
      deepest = Math.max(deepest, new Quantiles(depths(frame)).max());
    }
    return deepest;
  }

  private double[] depths(int frame) {
    double[] depths = new double[run.circles()];
    Arrays.setAll(depths, i -> solid.depth(run.x(frame, i), run.y(frame, i), i));
    return depths;
  }

  /** How many are outside of the bounds after that frame or later; NaN if the run did not end. */
  private double escaped(int from) {
    int count = 0;
    for (int i = 0; i < run.circles(); i++) {
      boolean inside = true;
      for (int frame = from; frame <= run.frames() && inside; frame++) {
        inside = solid.isInside(run.x(frame, i), run.y(frame, i));
      }
      count += inside ? 0 : 1;
    }
    return run.failure().isPresent() ? Double.NaN : count;
  }

  /** NaN if the run did not end. */
  private double tunnelled() {
    int count = 0;
    for (int i = 0; i < run.circles(); i++) {
      boolean passed = false;
      for (int frame = 1; frame <= run.frames() && !passed; frame++) {
        passed = passesSomeLine(frame, i);
      }
      count += passed ? 1 : 0;
    }
    return run.failure().isPresent() ? Double.NaN : count;
  }

  private boolean passesSomeLine(int frame, int i) {
    return solid.passes(
        run.x(frame - 1, i),
        run.y(frame - 1, i),
        run.x(frame, i),
        run.y(frame, i),
        Math.max(run.speed(frame - 1, i), run.speed(frame, i)));
  }
}
