// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;

/** A quantity of all circles over the frames of a run: its median, and the band of 5 to 95 %. */
final class Drift {

  /** Frames from one point of the series to the next. */
  static final int STRIDE = 10;

  private Drift() {}

  static List<Row> rows(
      Trial trial, String metric, String unit, int frames, IntFunction<double[]> ofFrame) {
    List<Row> rows = new ArrayList<>();
    for (int frame = STRIDE; frame <= frames; frame += STRIDE) {
      Quantiles values = new Quantiles(ofFrame.apply(frame));
      int n = values.size();
      rows.add(trial.row(metric, "median@" + frame, values.median(), unit, n));
      rows.add(trial.row(metric, "p5@" + frame, values.at(0.05), unit, n));
      rows.add(trial.row(metric, "p95@" + frame, values.at(0.95), unit, n));
    }
    return rows;
  }
}
