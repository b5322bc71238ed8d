// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import java.awt.geom.Line2D;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LineMapTest {

  @Test
  void findsEveryCrossing() {
    Random random = new Random(1);
    SceneBuilder builder = Scene.builder().line(0, 0, 800, 0).line(3, -40, 3, 700);
    for (int i = 0; i < 30; i++) {
      double x = random.nextDouble() * 800;
      double y = random.nextDouble() * 600;
      builder.line(x, y, x + random.nextGaussian() * 30, y + random.nextGaussian() * 30);
    }
    Scene scene = builder.build();
    LineMap map = new LineMap(scene);
    int crossings = 0;
    for (int i = 0; i < 2_000; i++) {
      double px = random.nextDouble() * 1000 - 100;
      double py = random.nextDouble() * 800 - 100;
      double qx = px + random.nextGaussian() * 60;
      double qy = py + random.nextGaussian() * 60;
      boolean crossed = isCrossed(scene, px, py, qx, qy);
      assertThat(map.isCrossed(px, py, qx, qy)).as("path %d", i).isEqualTo(crossed);
      crossings += crossed ? 1 : 0;
    }
    assertThat(crossings).isBetween(100, 1_900);
  }

  @Test
  void endsOnALineDoNotCross() {
    LineMap map = new LineMap(Scene.builder().line(0, 0, 10, 0).build());

    assertThat(map.isCrossed(5, 5, 5, 0)).isFalse();
    assertThat(map.isCrossed(5, 5, 5, -1)).isTrue();
  }

  private static boolean isCrossed(Scene scene, double px, double py, double qx, double qy) {
    for (int i = 0; i < scene.lineCount(); i++) {
      if (Line2D.linesIntersect(
          px,
          py,
          qx,
          qy,
          scene.line(i).ax(),
          scene.line(i).ay(),
          scene.line(i).bx(),
          scene.line(i).by())) {
        return true;
      }
    }
    return false;
  }
}
