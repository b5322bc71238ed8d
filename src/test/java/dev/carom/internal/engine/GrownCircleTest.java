// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Internals;
import dev.carom.ObstacleKind;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.internal.search.Grid;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.util.Kind;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;

/** A circle whose radius changes is never looked up in a grid for smaller ones. */
class GrownCircleTest {

  private static final int CIRCLES = 5;

  /** About the number of lines from which on there are grids. */
  private static final int LINES = 9;

  /** Where lines were removed, a grid may be left that is not worth another one, for a larger r. */
  @Test
  void whoGrowsAmongFewLinesThatHadAGridStillMeetsThem() {
    SceneBuilder builder = Scene.builder();
    for (int i = 0; i < 10; i++) {
      builder.line(6 * i, 0, 6 * i, 1);
    }
    World world = new World(builder.circle(-50, 8.5, 4.1, 1, 0).build());
    world.remove(ObstacleKind.LINE, 8);
    world.remove(ObstacleKind.LINE, 9);
    world.setRadius(0, 7.9);
    Run.step(world, 100);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.impacts().id(0)).isZero();
  }

  @RepeatedTest(200)
  void whateverIsEditedEachGridServesTheRadiusOfItsCircle(RepetitionInfo info) {
    Random random = new Random(info.getCurrentRepetition());
    Scene scene = scene(random);
    CircleTable circles = circles(scene);
    CircleRegistry registry = new CircleRegistry(Internals.data(scene), 1);
    StaticScene staticScene = new StaticScene(Internals.data(scene), EngineOptions.CHOSEN);
    List<Integer> lines = new ArrayList<>();
    for (int i = 0; i < LINES; i++) {
      lines.add(Codes.line(i));
    }
    for (int edit = 0; edit < 40; edit++) {
      int i = random.nextInt(CIRCLES);
      switch (random.nextInt(4)) {
        case 0 -> resize(circles, staticScene, i, radius(random));
        case 1 -> addLine(staticScene, lines, edit);
        case 2 -> removeLine(staticScene, lines, random);
        default -> staticScene.prepare(circles, registry);
      }
      for (int k = 0; k < CIRCLES; k++) {
        Grid grid = staticScene.grid(k);
        if (grid != null) {
          assertThat(grid.radius)
              .as("after edit %s", edit)
              .isGreaterThanOrEqualTo(circles.radius(k));
        }
      }
    }
  }

  /** A radius of one octave or of its neighbours. */
  private static double radius(Random random) {
    return Math.scalb(1 + random.nextDouble(), random.nextInt(3));
  }

  private static Scene scene(Random random) {
    SceneBuilder scene = Scene.builder();
    for (int i = 0; i < LINES; i++) {
      scene.line(6 * i, 0, 6 * i, 1);
    }
    for (int i = 0; i < CIRCLES; i++) {
      scene.circle(20 * i, 50, radius(random), 1, 0);
    }
    return scene.build();
  }

  private static CircleTable circles(Scene scene) {
    CircleTable circles = new CircleTable(CIRCLES);
    for (int i = 0; i < CIRCLES; i++) {
      circles.start(Internals.data(scene), i);
      circles.storeAndSetDue(i);
    }
    return circles;
  }

  private static void resize(CircleTable circles, StaticScene staticScene, int i, double radius) {
    circles.load(i);
    circles.body.radius = radius;
    circles.storeAndSetDue(i);
    staticScene.setRadius(i, radius);
  }

  private static void addLine(StaticScene staticScene, List<Integer> lines, int x) {
    int line = staticScene.obstacles.add(Kind.LINE, x, 10, x, 11);
    lines.add(line);
    staticScene.changed(line);
  }

  private static void removeLine(StaticScene staticScene, List<Integer> lines, Random random) {
    if (!lines.isEmpty()) {
      int line = lines.remove(random.nextInt(lines.size()));
      staticScene.obstacles.remove(line);
      staticScene.changed(line);
    }
  }
}
