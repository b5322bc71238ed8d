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

/** Scenes whose circles start elsewhere: a method is set to a state by starting it there. */
final class States {

  /** Where a circle starts, and how it moves. */
  interface State {
    Circle circle(int i);

    Vec2 velocity(int i);
  }

  private States() {}

  /** The same obstacles, and circles in the state of the reference at the end of a frame. */
  static Scene at(Scene scene, Reference reference, int frame) {
    return with(
        scene,
        new State() {
          @Override
          public Circle circle(int i) {
            double r = scene.circle(i).radius();
            return new Circle(reference.x(frame, i), reference.y(frame, i), r);
          }

          @Override
          public Vec2 velocity(int i) {
            return new Vec2(reference.vx(frame, i), reference.vy(frame, i));
          }
        });
  }

  /** The same obstacles, and circles where a run has them after a frame, flying back. */
  static Scene reversed(Scene scene, RecordedRun run, int frame) {
    return with(
        scene,
        new State() {
          @Override
          public Circle circle(int i) {
            double r = scene.circle(i).radius();
            return new Circle(run.x(frame, i), run.y(frame, i), r);
          }

          @Override
          public Vec2 velocity(int i) {
            return new Vec2(-run.vx(frame, i), -run.vy(frame, i));
          }
        });
  }

  /** The same scene, every coordinate of a circle's start one ulp greater. */
  static Scene oneUlpAway(Scene scene) {
    return with(
        scene,
        new State() {
          @Override
          public Circle circle(int i) {
            Circle c = scene.circle(i);
            return new Circle(Math.nextUp(c.x()), Math.nextUp(c.y()), c.radius());
          }

          @Override
          public Vec2 velocity(int i) {
            return scene.velocity(i);
          }
        });
  }

  private static Scene with(Scene scene, State state) {
    Vec2 g = scene.gravity();
    SceneBuilder builder = Scene.builder().collide(scene.collide()).gravity(g.x(), g.y());
    addObstacles(scene, builder);
    for (int i = 0; i < scene.circleCount(); i++) {
      Circle c = state.circle(i);
      Vec2 v = state.velocity(i);
      builder.circle(c.x(), c.y(), c.radius(), v.x(), v.y());
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
