// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;

/**
 * Parts of a scene in a new one, to which others are added. Copied are places, velocities of
 * circles, restitutions and masses; not filters, responses and velocities of obstacles.
 */
public final class SceneCopy {

  private SceneCopy() {}

  /** The bounds, lines and pegs, the gravity, and whether circles collide. */
  public static SceneBuilder obstacles(Scene scene) {
    Vec2 g = scene.gravity();
    SceneBuilder builder = bounds(scene).collide(scene.collide()).gravity(g.x(), g.y());
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      line(builder, (Line) scene.shape(Kind.LINE, i))
          .restitution(scene.traits(Kind.LINE, i).restitution());
    }
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      Circle peg = (Circle) scene.shape(Kind.PEG, i);
      builder.peg(peg.x(), peg.y(), peg.radius());
      builder.restitution(scene.traits(Kind.PEG, i).restitution());
    }
    return builder;
  }

  /** The bounds alone, if it has any. */
  public static SceneBuilder bounds(Scene scene) {
    SceneBuilder builder = Scene.builder().collide(false);
    scene
        .bounds()
        .ifPresent(
            b ->
                builder
                    .bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax())
                    .restitution(scene.traits(Kind.WALL, 0).restitution()));
    return builder;
  }

  /** Adds a line. */
  public static SceneBuilder line(SceneBuilder builder, Line line) {
    return builder.line(line.ax(), line.ay(), line.bx(), line.by());
  }

  /** Adds all circles. */
  public static SceneBuilder circles(SceneBuilder builder, Scene scene) {
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      circle(builder, scene, i);
    }
    return builder;
  }

  /** Adds one of the circles. */
  public static SceneBuilder circle(SceneBuilder builder, Scene scene, int i) {
    Circle circle = (Circle) scene.shape(Kind.CIRCLE, i);
    return circle(
        builder, scene, i, new Vec2(circle.x(), circle.y()), scene.velocity(Kind.CIRCLE, i));
  }

  /** Adds one of the circles, at another place and with another velocity. */
  public static SceneBuilder circle(
      SceneBuilder builder, Scene scene, int i, Vec2 center, Vec2 velocity) {
    double radius = ((Circle) scene.shape(Kind.CIRCLE, i)).radius();
    return builder
        .circle(center.x(), center.y(), radius, velocity.x(), velocity.y())
        .restitution(scene.traits(Kind.CIRCLE, i).restitution())
        .mass(scene.traits(Kind.CIRCLE, i).mass());
  }
}
