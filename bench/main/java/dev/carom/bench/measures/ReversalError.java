// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.results.Row;
import java.util.Arrays;
import java.util.List;

/**
 * Elastic motion can be undone: after some frames every velocity is turned round, and after as many
 * again every circle should be where it started. Played are as many frames as the median circle
 * takes for {@value #TRAVEL} median radii: on longer ways chaos hides what a method does.
 */
final class ReversalError {

  static final double TRAVEL = 30;

  private final Contender contender;
  private final Scene scene;
  private final int frames;

  ReversalError(Contender contender, Scene scene) {
    this.contender = contender;
    this.scene = scene;
    frames = frames(scene);
  }

  private static int frames(Scene scene) {
    double[] radii = new double[scene.count(Kind.CIRCLE)];
    double[] speeds = new double[scene.count(Kind.CIRCLE)];
    Arrays.setAll(radii, i -> ((Circle) scene.shape(Kind.CIRCLE, i)).radius());
    Arrays.setAll(speeds, i -> scene.velocity(Kind.CIRCLE, i).length());
    double frames = TRAVEL * new Quantiles(radii).median() / new Quantiles(speeds).median();
    return (int) Math.min(Math.ceil(frames), Subjects.FRAMES);
  }

  List<Row> rows(Trial trial) {
    Quantiles errors = new Quantiles(errors());
    return List.of(
        trial.row("reversal_error", "max", errors.max(), Trial.RADII, errors.size()),
        trial.row("reversal_error", "median", errors.median(), Trial.RADII, errors.size()));
  }

  private double[] errors() {
    double[] errors = new double[scene.count(Kind.CIRCLE)];
    Arrays.fill(errors, Double.NaN);
    RecordedRun there = RecordedRun.play(contender, scene, frames);
    if (there.failure().isPresent()) {
      return errors;
    }
    RecordedRun back = RecordedRun.play(contender, States.reversed(scene, there, frames), frames);
    Arrays.setAll(
        errors,
        i ->
            Math.hypot(back.x(frames, i) - there.x(0, i), back.y(frames, i) - there.y(0, i))
                / ((Circle) scene.shape(Kind.CIRCLE, i)).radius());
    return errors;
  }
}
