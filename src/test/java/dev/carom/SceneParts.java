// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.List;

/** Scenes made of some things of another one, in another order; all circles are elastic. */
public final class SceneParts {

  private SceneParts() {}

  /** The things with these numbers, in this order, within the same bounds. */
  public static Scene of(
      Scene scene, List<Integer> circles, List<Integer> lines, List<Integer> pegs) {
    SceneBuilder builder = Scene.builder().collide(scene.collide());
    builder.gravity(scene.gravity().x(), scene.gravity().y());
    scene
        .bounds()
        .ifPresent(
            b ->
                builder
                    .bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax())
                    .restitution(scene.traits(Kind.WALL, 0).restitution()));
    for (int i : lines) {
      Line l = (Line) scene.shape(Kind.LINE, i);
      builder
          .line(l.ax(), l.ay(), l.bx(), l.by())
          .restitution(scene.traits(Kind.LINE, i).restitution());
    }
    for (int i : pegs) {
      Circle p = (Circle) scene.shape(Kind.PEG, i);
      builder.peg(p.x(), p.y(), p.radius()).restitution(scene.traits(Kind.PEG, i).restitution());
    }
    for (int i : circles) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 v = scene.velocity(Kind.CIRCLE, i);
      builder
          .circle(c.x(), c.y(), c.radius(), v.x(), v.y())
          .mass(scene.traits(Kind.CIRCLE, i).mass());
    }
    return builder.build();
  }
}
