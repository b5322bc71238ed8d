// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;

/** What stands still in a scene, for a scene with other circles. */
final class Obstacles {

  private Obstacles() {}

  static SceneBuilder of(Scene scene) {
    SceneBuilder builder = Scene.builder().collide(scene.collide());
    scene
        .bounds()
        .ifPresent(
            b ->
                builder
                    .bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax())
                    .restitution(scene.boundsRestitution()));
    for (int i = 0; i < scene.lineCount(); i++) {
      Line l = scene.line(i);
      builder.line(l.ax(), l.ay(), l.bx(), l.by()).restitution(scene.lineRestitution(i));
    }
    for (int i = 0; i < scene.pegCount(); i++) {
      Circle p = scene.peg(i);
      builder.peg(p.x(), p.y(), p.radius()).restitution(scene.pegRestitution(i));
    }
    return builder;
  }
}
