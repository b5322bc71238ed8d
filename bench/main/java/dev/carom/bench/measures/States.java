// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.ObstacleKind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
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
        i -> new Vec2(Math.nextUp(scene.circle(i).x()), Math.nextUp(scene.circle(i).y())),
        scene::velocity);
  }

  private static Scene with(Scene scene, IntFunction<Vec2> centers, IntFunction<Vec2> velocities) {
    Vec2 g = scene.gravity();
    SceneBuilder builder = Scene.builder().collide(scene.collide()).gravity(g.x(), g.y());
    addObstacles(scene, builder);
    for (int i = 0; i < scene.circleCount(); i++) {
      Vec2 c = centers.apply(i);
      Vec2 v = velocities.apply(i);
      builder.circle(c.x(), c.y(), scene.circle(i).radius(), v.x(), v.y());
      builder.restitution(scene.restitution(ObstacleKind.CIRCLE, i)).mass(scene.mass(i));
    }
    return builder.build();
  }

  private static void addObstacles(Scene scene, SceneBuilder builder) {
    if (scene.bounds().isPresent()) {
      Bounds b = scene.bounds().get();
      builder.bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax());
      builder.restitution(scene.restitution(ObstacleKind.WALL, 0));
    }
    for (int k = 0; k < scene.lineCount(); k++) {
      Line line = scene.line(k);
      builder.line(line.ax(), line.ay(), line.bx(), line.by());
      builder.restitution(scene.restitution(ObstacleKind.LINE, k));
    }
    for (int k = 0; k < scene.pegCount(); k++) {
      Circle peg = scene.peg(k);
      builder
          .peg(peg.x(), peg.y(), peg.radius())
          .restitution(scene.restitution(ObstacleKind.PEG, k));
    }
  }
}
