// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.RandomScenes;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SceneParts;
import dev.carom.TestScenes;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The machinery that a world chooses changes the cost and no bit of the result: asking every
 * obstacle and grids of any size give the same impacts; so do circles and obstacles in another
 * order.
 */
class EngineOptionsTest {

  private static final double[] CELLS = {5, 17, 40, 64, 200, 1000};

  private static void assertSameWithAllMachinery(Scene scene, double... times) {
    Run each = Run.advance(Internals.world(scene, EngineOptions.EACH), times);
    assertThat(Run.advance(new World(scene), times)).as("as chosen").isEqualTo(each);
    for (double cell : CELLS) {
      assertThat(Run.advance(Internals.world(scene, EngineOptions.cells(cell)), times))
          .as("cells of %s", cell)
          .isEqualTo(each);
    }
  }

  static Stream<Arguments> recipes() {
    return Stream.of(
        recipe("mixed", RandomScenes::mixed),
        recipe("responses", RandomScenes::responses),
        recipe("long lines", RandomScenes::longLines),
        recipe("mixed radii", RandomScenes::mixedRadii),
        recipe("falling", RandomScenes::falling),
        recipe("open", RandomScenes::open),
        recipe("lattice", RandomScenes::lattice));
  }

  private static Arguments recipe(String name, RandomScenes.Recipe recipe) {
    return Arguments.of(name, recipe);
  }

  @Tag("long")
  @ParameterizedTest(name = "{0}")
  @MethodSource("recipes")
  void onRandomScenes(String name, RandomScenes.Recipe recipe) {
    int impacts = 0;
    for (int seed = 0; seed < 6; seed++) {
      Scene scene = recipe.draw(new Random(seed)).build();
      assertSameWithAllMachinery(scene, 0.5, 40, 250);
      impacts += Run.advance(new World(scene), 250).impacts().size();
    }
    assertThat(impacts).isGreaterThan(500);
  }

  /** In cells smaller than the circles, and in one cell for all. */
  @ParameterizedTest
  @ValueSource(doubles = {0.7, 3, 4000})
  void inCellsOfExtremeSizes(double cell) {
    Scene scene = RandomScenes.mixed(new Random(99)).build();
    assertThat(Run.advance(Internals.world(scene, EngineOptions.cells(cell)), 100))
        .isEqualTo(Run.advance(Internals.world(scene, EngineOptions.EACH), 100));
  }

  /** So fast or slow that cells cannot be counted by time, or hardly. */
  @ParameterizedTest
  @ValueSource(ints = {-1000, -480, 480, 520, 990})
  void inAnyUnitOfTime(int exponent) {
    Scene scene = RandomScenes.mixed(new Random(7)).build();
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, 0, 800, 600);
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      Line l = (Line) scene.shape(Kind.LINE, i);
      builder.line(l.ax(), l.ay(), l.bx(), l.by());
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) scene.shape(Kind.CIRCLE, i);
      Vec2 v = scene.velocity(Kind.CIRCLE, i);
      builder.circle(
          c.x(), c.y(), c.radius(), Math.scalb(v.x(), exponent), Math.scalb(v.y(), exponent));
    }
    double time = Math.scalb(5.0, -exponent);
    assertThat(Run.advance(Internals.world(builder.build(), EngineOptions.cells(17)), time))
        .isEqualTo(Run.advance(Internals.world(builder.build(), EngineOptions.EACH), time));
  }

  // Order.

  /** A scene taken apart and put together in another order, and what each thing is called then. */
  private record Shuffled(
      Scene scene, List<Integer> lines, List<Integer> pegs, List<Integer> circles) {

    static Shuffled of(Scene scene, Random random) {
      List<Integer> lines = shuffled(scene.count(Kind.LINE), random);
      List<Integer> pegs = shuffled(scene.count(Kind.PEG), random);
      List<Integer> circles = shuffled(scene.count(Kind.CIRCLE), random);
      Scene parts = SceneParts.of(scene, circles, lines, pegs);
      return new Shuffled(parts, lines, pegs, circles);
    }

    private static List<Integer> shuffled(int count, Random random) {
      List<Integer> order = new ArrayList<>(all(count).toList());
      Collections.shuffle(order, random);
      return order;
    }

    /** The row with the names of the first scene. */
    Run.Row renamed(Run.Row row) {
      int obstacle =
          switch (row.kind()) {
            case WALL -> row.obstacle();
            case LINE -> lines.get(row.obstacle());
            case PEG -> pegs.get(row.obstacle());
            default -> circles.get(row.obstacle());
          };
      return row.renamed(circles.get(row.circle()), obstacle);
    }
  }

  private static void assertOrderDoesNotMatter(Scene scene, double time) {
    Run run = Run.advance(new World(scene), time);
    for (int seed = 0; seed < 5; seed++) {
      Shuffled shuffled = Shuffled.of(scene, new Random(seed));
      Run other = Run.advance(new World(shuffled.scene()), time);
      assertThat(other.map(shuffled::renamed)).isEqualTo(run.impacts());
      for (int i = 0; i < other.end().size(); i++) {
        assertThat(other.end().get(i)).isEqualTo(run.end().get(shuffled.circles().get(i)));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "fast-1.csv", "radii.csv"})
  void theOrderOfThingsChangesNoBit(String file) {
    assertOrderDoesNotMatter(TestScenes.read(file), 600);
  }

  private static Stream<Integer> all(int count) {
    return IntStream.range(0, count).boxed();
  }
}
