// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.results.Row;
import java.util.Arrays;
import java.util.List;

/**
 * Elastic motion can be undone: after {@value #FRAMES} frames every velocity is turned round, and
 * after as many again every circle should be where it started.
 */
final class Reversal {

  static final int FRAMES = 60;

  private Reversal() {}

  static List<Row> rows(Trial trial, Subject subject) {
    Quantiles errors = new Quantiles(errors(trial.contender(), subject.scene()));
    return List.of(
        trial.row("reversal_error", "max", errors.max(), Trial.RADII, errors.size()),
        trial.row("reversal_error", "median", errors.median(), Trial.RADII, errors.size()));
  }

  private static double[] errors(Contender contender, Scene scene) {
    double[] errors = new double[scene.circleCount()];
    Arrays.fill(errors, Double.NaN);
    Course there = Course.play(contender, scene, FRAMES);
    if (there.failure().isPresent()) {
      return errors;
    }
    Course back = Course.play(contender, States.reversed(scene, there, FRAMES), FRAMES);
    Arrays.setAll(
        errors,
        i ->
            Math.hypot(back.x(FRAMES, i) - there.x(0, i), back.y(FRAMES, i) - there.y(0, i))
                / scene.circle(i).radius());
    return errors;
  }
}
