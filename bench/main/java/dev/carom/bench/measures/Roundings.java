// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.results.Row;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The errors of one contender by circle and frame, in units of 2^-53 times their conditioning. */
final class Roundings {

  private final int circles;
  private final double[] units;
  private final double[] ofFrames;

  Roundings(int frames, int circles) {
    this.circles = circles;
    units = new double[frames * circles];
    ofFrames = new double[frames];
  }

  /** Takes the errors of a frame, in px, and what one unit is for each circle. */
  void add(int frame, double[] px, double[] unit) {
    for (int i = 0; i < circles; i++) {
      units[frame * circles + i] = px[i] / unit[i];
    }
    ofFrames[frame] =
        Arrays.stream(px).max().orElseThrow() / Arrays.stream(unit).max().orElseThrow();
  }

  /** The frame of the greatest error. */
  int worstFrame() {
    return worst() / circles;
  }

  /** The circle of the greatest error. */
  int worstCircle() {
    return worst() % circles;
  }

  private int worst() {
    int worst = 0;
    for (int k = 1; k < units.length; k++) {
      worst = units[k] > units[worst] ? k : worst;
    }
    return worst;
  }

  List<Row> rows(Trial trial) {
    Quantiles all = new Quantiles(units);
    int n = all.size();
    double above = (double) Arrays.stream(units).filter(u -> u > RoundingPart.LIMIT).count();
    double worstOfFrames = new Quantiles(ofFrames).max();
    return new ArrayList<>(
        List.of(
            trial.row(RoundingPart.METRIC, "max", all.max(), Trial.ONE, n),
            trial.row(RoundingPart.METRIC, "p99.9", all.at(0.999), Trial.ONE, n),
            trial.row(RoundingPart.METRIC, "median", all.median(), Trial.ONE, n),
            trial.row(RoundingPart.METRIC, RoundingPart.ABOVE, above, Trial.ONE, n),
            trial.row(
                RoundingPart.METRIC,
                RoundingPart.OF_FRAMES,
                worstOfFrames,
                Trial.ONE,
                ofFrames.length)));
  }
}
