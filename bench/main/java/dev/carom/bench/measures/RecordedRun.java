// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Method;
import java.util.Arrays;
import java.util.Optional;

/**
 * A run, written down: the state of every circle at the end of every frame, 0 for the start. From
 * the frame on in which the method failed, all is NaN.
 */
final class RecordedRun {

  private final double[][] x;
  private final double[][] y;
  private final double[][] vx;
  private final double[][] vy;
  private final Counters counters = new Counters();
  private String failure;

  private RecordedRun(int frames, int circles) {
    x = unknown(frames, circles);
    y = unknown(frames, circles);
    vx = unknown(frames, circles);
    vy = unknown(frames, circles);
  }

  private static double[][] unknown(int frames, int circles) {
    double[][] values = new double[frames + 1][circles];
    for (double[] row : values) {
      Arrays.fill(row, Double.NaN);
    }
    return values;
  }

  /**
   * Plays a scene.
   *
   * @throws UnsupportedOperationException if the contender cannot run here
   */
  static RecordedRun play(Contender contender, Scene scene, int frames) {
    RecordedRun run = new RecordedRun(frames, scene.count(Kind.CIRCLE));
    try (Method method = contender.start(scene)) {
      run.record(method, 0);
      for (int frame = 1; frame <= frames && run.failure == null; frame++) {
        run.playFrame(method, frame);
      }
    }
    return run;
  }

  private void playFrame(Method method, int frame) {
    try {
      method.frame();
    } catch (IllegalStateException | ArithmeticException | IndexOutOfBoundsException e) {
      failure = "frame " + frame + ": " + e.getMessage();
      return;
    }
    counters.add(method);
    record(method, frame);
  }

  private void record(Method method, int frame) {
    for (int i = 0; i < circles(); i++) {
      x[frame][i] = method.x(i);
      y[frame][i] = method.y(i);
      vx[frame][i] = method.vx(i);
      vy[frame][i] = method.vy(i);
    }
  }

  int frames() {
    return x.length - 1;
  }

  int circles() {
    return x[0].length;
  }

  double x(int frame, int circle) {
    return x[frame][circle];
  }

  double y(int frame, int circle) {
    return y[frame][circle];
  }

  double vx(int frame, int circle) {
    return vx[frame][circle];
  }

  double vy(int frame, int circle) {
    return vy[frame][circle];
  }

  double speed(int frame, int circle) {
    return Math.hypot(vx[frame][circle], vy[frame][circle]);
  }

  /** The events that the frames took. */
  Counters counters() {
    return counters;
  }

  /** Why the run ended before its last frame, if it did. */
  Optional<String> failure() {
    return Optional.ofNullable(failure);
  }
}
