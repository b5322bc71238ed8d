// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.MovingCircle;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DuePrefetcherTest {

  private static final int SIDE = 1000;

  private final SplittableRandom random = new SplittableRandom(1);

  @ParameterizedTest
  @ValueSource(ints = {1, 16, 17, 5000})
  void eachPassFindsThoseThatAreDueInTheirOrder(int count) {
    StaticScene staticScene = new StaticScene(Internals.data(scene(count)), EngineOptions.CHOSEN);
    CircleTable circles = anywhere(count);
    double[] state = circles.state.clone();
    DuePrefetcher due = new DuePrefetcher(circles, staticScene);
    for (double now = 0; now < 10; now++) {
      double end = now;
      int next = due.first(end);
      for (int i = 0; i < count; i++) {
        if (circles.due.get(i) <= end) {
          assertThat(next).isEqualTo(i);
          if (random.nextInt(40) == 0) { // it spent its budget
            end = Math.min(end, now - random.nextDouble());
          }
          circles.due.set(i, Math.nextUp(now) + 9 * random.nextDouble());
          next = due.next(end);
        }
      }
      assertThat(next).isEqualTo(circles.due.size());
    }
    assertThat(circles.state).isEqualTo(state);
  }

  /** Circles ignore each other, so it does not matter in what company they fly. */
  @ParameterizedTest
  @ValueSource(ints = {DuePrefetcher.LEAST_CIRCLES - 1, DuePrefetcher.LEAST_CIRCLES})
  void manyFlyAsFewDo(int count) {
    Scene scene = scene(count);
    World world = new World(scene);
    World[] parts = new World[8];
    int each = count / parts.length;
    for (int k = 0; k < parts.length; k++) {
      parts[k] = new World(part(scene, k * each, (k + 1) * each));
    }
    for (int step = 0; step < 20; step++) {
      world.step(1);
      for (int k = 0; k < parts.length; k++) {
        parts[k].step(1);
        for (int i = 0; i < each; i++) {
          assertThat(world.x(k * each + i)).isEqualTo(parts[k].x(i));
          assertThat(world.vy(k * each + i)).isEqualTo(parts[k].vy(i));
        }
      }
    }
  }

  /** Circles with any number that their state can hold. */
  private CircleTable anywhere(int count) {
    CircleTable circles = new CircleTable(count);
    double[] special = {0, -1e300, Double.POSITIVE_INFINITY, Double.NaN};
    int[] codes = {MovingCircle.NOTHING, Codes.TOP, Codes.line(0), Codes.peg(0), -20};
    for (int i = 0; i < count; i++) {
      double x = random.nextInt(9) == 0 ? special[random.nextInt(4)] : SIDE * random.nextDouble();
      circles.state[circles.at(i) + FlightRow.X] = x;
      circles.state[circles.at(i) + FlightRow.VY] = random.nextDouble();
      circles.state[circles.at(i) + CircleTable.CLEARED] = x;
      circles.codes[circles.codesAt(i) + CircleTable.NEXT] = codes[random.nextInt(codes.length)];
      circles.due.set(i, 9 * random.nextDouble());
    }
    return circles;
  }

  private Scene scene(int count) {
    SceneBuilder builder =
        Scene.builder().collide(false).bounds(0, 0, SIDE, SIDE).peg(SIDE / 2, SIDE / 2, 3);
    for (int i = 0; i < 100; i++) {
      double x = place();
      double y = place();
      builder.line(x, y, x + 20, y + random.nextDouble(20));
    }
    for (int i = 0; i < count; i++) {
      builder.circle(place(), place(), 1, random.nextDouble(-20, 20), random.nextDouble(-20, 20));
    }
    return builder.build();
  }

  private double place() {
    return random.nextDouble(10, SIDE - 10);
  }

  private static Scene part(Scene scene, int from, int to) {
    SceneBuilder builder =
        Scene.builder().collide(false).bounds(0, 0, SIDE, SIDE).peg(SIDE / 2, SIDE / 2, 3);
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      Line line = (Line) scene.shape(Kind.LINE, i);
      builder.line(line.ax(), line.ay(), line.bx(), line.by());
    }
    for (int i = from; i < to; i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      builder.circle(
          c.x(),
          c.y(),
          c.radius(),
          scene.velocity(Kind.CIRCLE, i).x(),
          scene.velocity(Kind.CIRCLE, i).y());
    }
    return builder.build();
  }
}
