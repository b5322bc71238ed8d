// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.bench.experiment.SceneCopy;

/** Derivatives of places by differences of two runs in many digits. */
final class Differences {

  /** How far a start value moves, relative to itself. */
  private static final double STEP = 0x1p-40;

  private Differences() {}

  /** |d place / d ln q| of a circle at a frame; q = 4 i + k is x, y, vx or vy of circle i. */
  static double derivative(Scene scene, int q, int frame, int circle) {
    double[] near = Truth.of(moved(scene, q, 0), frame, () -> {}).course(circle).states[frame];
    double[] far = Truth.of(moved(scene, q, STEP), frame, () -> {}).course(circle).states[frame];
    double dx = (far[0] - near[0]) + (far[CircleFrames.TAILS] - near[CircleFrames.TAILS]);
    double dy = (far[1] - near[1]) + (far[CircleFrames.TAILS + 1] - near[CircleFrames.TAILS + 1]);
    return Math.hypot(dx, dy) / STEP;
  }

  /** With values of 24 bits, so that a step of one is what it is called. */
  static Scene moved(Scene scene, int q, double step) {
    SceneBuilder builder = SceneCopy.obstacles(scene);
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 v = scene.velocity(Kind.CIRCLE, i);
      double[] values = {c.x(), c.y(), v.x(), v.y()};
      for (int k = 0; k < values.length; k++) {
        double value = (float) values[k];
        values[k] = 4 * i + k == q ? value * (1 + step) : value;
      }
      Vec2 center = new Vec2(values[0], values[1]);
      SceneCopy.circle(builder, scene, i, center, new Vec2(values[2], values[3]));
    }
    return builder.build();
  }
}
