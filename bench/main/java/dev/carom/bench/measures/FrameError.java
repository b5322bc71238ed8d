// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.results.Row;
import java.util.Arrays;
import java.util.List;

/**
 * The error of one frame, in radii: in each frame every circle starts from the true state, and
 * where it is after that one frame is compared with where it should be. So no error of an earlier
 * frame is multiplied by the scene.
 */
final class FrameError {

  private FrameError() {}

  static List<Row> rows(Trial trial, Subject subject, Reference reference) {
    Quantiles errors =
        new Quantiles(errors(trial.contender(), subject.scene(), reference, subject.frames()));
    return List.of(
        row(trial, "max", errors.max(), errors),
        row(trial, "p99.9", errors.at(0.999), errors),
        row(trial, "median", errors.median(), errors));
  }

  private static Row row(Trial trial, String stat, double value, Quantiles errors) {
    return trial.row("frame_error", stat, value, Trial.RADII, errors.size());
  }

  private static double[] errors(
      Contender contender, Scene scene, Reference reference, int frames) {
    int circles = scene.count(Kind.CIRCLE);
    double[] errors = new double[frames * circles];
    Arrays.fill(errors, Double.NaN);
    for (int frame = 0; frame < frames; frame++) {
      try (Method method = contender.start(States.at(scene, reference, frame))) {
        method.frame();
        for (int i = 0; i < circles; i++) {
          errors[frame * circles + i] =
              Math.hypot(
                      method.x(i) - reference.x(frame + 1, i),
                      method.y(i) - reference.y(frame + 1, i))
                  / ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
        }
      } catch (IllegalStateException failed) {
        // The errors of this frame stay NaN.
      }
    }
    return errors;
  }
}
