// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.bench.experiment.SceneCopy;
import dev.carom.bench.reference.Reference;
import java.util.function.IntFunction;

/** Scenes whose circles start elsewhere: a method is set to a state by starting it there. */
final class States {

  private States() {}

  /** The same obstacles, and circles in the state of the reference at the end of a frame. */
  static Scene at(Scene scene, Reference reference, int frame) {
    return with(
        scene,
        i -> new Vec2(reference.x(frame, i), reference.y(frame, i)),
        i -> new Vec2(reference.vx(frame, i), reference.vy(frame, i)));
  }

  /** The same obstacles, and circles where a run has them after a frame, flying back. */
  static Scene reversed(Scene scene, RecordedRun run, int frame) {
    return with(
        scene,
        i -> new Vec2(run.x(frame, i), run.y(frame, i)),
        i -> new Vec2(-run.vx(frame, i), -run.vy(frame, i)));
  }

  /** The same scene, every coordinate of a circle's start one ulp greater. */
  static Scene oneUlpAway(Scene scene) {
    return with(
        scene,
        i ->
            new Vec2(
                Math.nextUp(((Circle) scene.shape(Kind.CIRCLE, i)).x()),
                Math.nextUp(((Circle) scene.shape(Kind.CIRCLE, i)).y())),
        i -> scene.velocity(Kind.CIRCLE, i));
  }

  private static Scene with(Scene scene, IntFunction<Vec2> centers, IntFunction<Vec2> velocities) {
    SceneBuilder builder = SceneCopy.obstacles(scene);
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      SceneCopy.circle(builder, scene, i, centers.apply(i), velocities.apply(i));
    }
    return builder.build();
  }
}
