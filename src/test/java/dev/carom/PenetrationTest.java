// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Nothing is passed through: at no frame does a circle reach into a line or over the bounds. */
@Tag("long")
class PenetrationTest {

  private static final int FRAMES = 600;

  /** The overlap that rounding may leave, in px. */
  private static final double DEPTH = 1e-11;

  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "base-2.csv", "base-3.csv", "fast-1.csv", "radii.csv"})
  void noCircleReachesIntoAnything(String file) {
    Scene scene = TestScenes.read(file);
    World world = new World(scene);
    double deepest = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      Run.step(world, 1);
      for (int i = 0; i < world.circleCount(); i++) {
        deepest = Math.max(deepest, depth(scene, world, i));
      }
    }
    assertThat(deepest).isLessThan(DEPTH);
  }

  private static double depth(Scene scene, World world, int i) {
    double r = world.radius(i);
    double x = world.x(i);
    double y = world.y(i);
    Bounds b = scene.bounds().orElseThrow();
    double room =
        Math.min(Math.min(x - b.xmin(), b.xmax() - x), Math.min(y - b.ymin(), b.ymax() - y));
    Vec2 centre = new Vec2(x, y);
    for (int k = 0; k < scene.lineCount(); k++) {
      Vec2 closest = scene.line(k).closestPoint(centre);
      double dx = x - closest.x();
      double dy = y - closest.y();
      room = Math.min(room, Math.sqrt(dx * dx + dy * dy));
    }
    return r - room;
  }
}
