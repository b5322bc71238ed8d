// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Internals;
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
import org.junit.jupiter.api.Test;
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

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"base-1.csv", "fast-1.csv", "radii.csv"})
  void onTheScenesOfTheExperiment(String file) {
    assertSameWithAllMachinery(TestScenes.read(file), 600);
  }

  @Test
  void alsoWhereStepsMakeTheSearchGoOnBitByBit() {
    double[] times = IntStream.rangeClosed(1, 2400).mapToDouble(i -> i * 0.25).toArray();
    assertSameWithAllMachinery(TestScenes.read("base-1.csv"), times);
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

  @ParameterizedTest(name = "{0}")
  @MethodSource("recipes")
  void onARandomScene(String name, RandomScenes.Recipe recipe) {
    assertSameWithAllMachinery(recipe.draw(new Random(6)).build(), 0.5, 40, 120);
  }

  /** In cells smaller than the circles, and in one cell for all. */
  @ParameterizedTest
  @ValueSource(doubles = {0.7, 3, 4000})
  void inCellsOfExtremeSizes(double cell) {
    Scene scene = RandomScenes.mixed(new Random(99)).build();
    assertThat(Run.advance(Internals.world(scene, EngineOptions.cells(cell)), 100))
        .isEqualTo(Run.advance(Internals.world(scene, EngineOptions.EACH), 100));
  }

  /**
   * Moved far away, a cell is only some thousand ulps wide: the grid may not trust its rounding.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e6, 1e9, 0x1p33 * 100, 1e12, 4e13})
  void farFromTheOrigin(double far) {
    SceneBuilder builder = Scene.builder();
    Random random = new Random(5);
    for (int i = 0; i < 50; i++) {
      double x = far + random.nextInt(800);
      double y = random.nextInt(600) - far;
      builder.line(x, y, x + random.nextInt(40) - 20, y + random.nextInt(40) - 20);
    }
    for (int i = 0; i < 50; i++) {
      double x = far + random.nextInt(800);
      double y = random.nextInt(600) - far;
      builder.circle(x, y, 8, random.nextInt(21) - 10, random.nextInt(21) - 10);
    }
    assertSameWithAllMachinery(builder.build(), 300);
  }

  /** So fast or slow that cells cannot be counted by time, or hardly. */
  @ParameterizedTest
  @ValueSource(ints = {-1000, -480, 480, 520, 990})
  void inAnyUnitOfTime(int exponent) {
    Scene scene = RandomScenes.mixed(new Random(7)).build();
    SceneBuilder builder = Scene.builder().bounds(0, 0, 800, 600);
    for (int i = 0; i < scene.lineCount(); i++) {
      Line l = scene.line(i);
      builder.line(l.ax(), l.ay(), l.bx(), l.by());
    }
    for (int i = 0; i < scene.circleCount(); i++) {
      Circle c = scene.circle(i);
      Vec2 v = scene.velocity(i);
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
      List<Integer> lines = shuffled(scene.lineCount(), random);
      List<Integer> pegs = shuffled(scene.pegCount(), random);
      List<Integer> circles = shuffled(scene.circleCount(), random);
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

  /** Not scenes with gravity: contact adds up impulses in the order of the obstacles. */
  static Stream<RandomScenes.Recipe> scenesWithPegs() {
    return Stream.of(RandomScenes::mixed);
  }

  /** Impacts at one time would stand in the order of circles; none of them do at time 0. */
  @ParameterizedTest
  @MethodSource("scenesWithPegs")
  void theOrderOfThingsChangesNoBitAmongPegsEither(RandomScenes.Recipe recipe) {
    Scene scene = withoutOverlaps(recipe.draw(new Random(1)).build());
    assertThat(scene.circleCount()).isGreaterThan(20);
    assertOrderDoesNotMatter(scene, 300);
  }

  /** The scene without the circles that have an impact at time 0, all of which would be ties. */
  private static Scene withoutOverlaps(Scene scene) {
    World world = new World(scene);
    Run.step(world, 0);
    List<Integer> early = Run.rows(world.impacts()).stream().map(Run.Row::circle).toList();
    return SceneParts.of(
        scene,
        all(scene.circleCount()).filter(i -> !early.contains(i)).toList(),
        all(scene.lineCount()).toList(),
        all(scene.pegCount()).toList());
  }

  private static Stream<Integer> all(int count) {
    return IntStream.range(0, count).boxed();
  }
}
