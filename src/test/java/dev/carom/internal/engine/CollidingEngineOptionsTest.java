// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.CollidingScenes;
import dev.carom.ImpactLog;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.PlainWorld;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SceneParts;
import dev.carom.World;
import dev.carom.internal.state.EngineOptions;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * How circles that collide are found - cells, grids, the calendar, steps - changes the cost and no
 * bit of the result: it is that of asking everyone about everything before each event.
 */
class CollidingEngineOptionsTest {

  private static final double[] PAIR_CELLS = {1.5, 2, 5, 1000};
  private static final int SEEDS = 2;

  /** Draws a scene with a number of circles. */
  private interface Recipe {
    SceneBuilder draw(Random random, int count);
  }

  static Stream<Arguments> recipes() {
    return Stream.of(
        recipe("mixed", CollidingScenes::mixed),
        recipe("falling", CollidingScenes::falling),
        recipe("open", CollidingScenes::open),
        recipe("gas", CollidingScenes::gas),
        recipe("inelastic", CollidingScenes::inelastic),
        recipe("lattice", CollidingScenes::lattice));
  }

  private static Arguments recipe(String name, Recipe recipe) {
    return Arguments.of(name, recipe);
  }

  private static Scene draw(Object recipe, int count, long seed) {
    return ((Recipe) recipe).draw(new Random(seed), count).build();
  }

  // Against the plain way.

  /** One ulp is a good part of a radius there: cells may not trust their rounding. */
  @ParameterizedTest
  @ValueSource(doubles = {1e6, 1e9, 1e12})
  void thePlainWayGivesTheSameFarFromTheOrigin(double far) {
    for (int seed = 0; seed < SEEDS; seed++) {
      SceneBuilder builder = Scene.builder().bounds(far, -far, far + 400, 300 - far);
      Random random = new Random(seed);
      for (int i = 0; i < 30; i++) {
        builder.circle(
            far + 10 + random.nextInt(380),
            random.nextInt(280) - far + 10,
            8,
            random.nextInt(11) - 5,
            random.nextInt(3) - 1);
      }
      assertThePlainWayGivesTheSame(builder.build());
    }
  }

  /** Some hundred impacts and the rest of those at the time of the last one. */
  private static int assertThePlainWayGivesTheSame(Scene scene) {
    World world = new World(scene);
    List<Run.Row> rows = new ArrayList<>();
    while (rows.size() < 300 && world.now() < 100) {
      world.step(0.25);
      rows.addAll(Run.rows(world.impacts()));
    }
    ImpactLog plain = new PlainWorld(scene).advance(world.now(), rows.size() + 1);
    assertThat(Run.rows(plain)).isEqualTo(rows);
    return rows.size();
  }

  // Forced.

  @Tag("long")
  @ParameterizedTest(name = "{0}")
  @MethodSource("recipes")
  void cellsAndGridsOfAnySizeGiveTheSame(String name, Object recipe) {
    for (int seed = 10; seed < 10 + SEEDS; seed++) {
      Scene scene = draw(recipe, 60, seed);
      Run chosen = Run.advance(new World(scene), 0.5, 10, 25);
      for (double diameters : PAIR_CELLS) {
        for (EngineOptions grid :
            List.of(EngineOptions.EACH, EngineOptions.cells(17), EngineOptions.cells(200))) {
          World world =
              Internals.world(scene, new EngineOptions(grid.grid(), grid.cell(), diameters, 1));
          assertThat(Run.advance(world, 0.5, 10, 25)).as("cells %s", diameters).isEqualTo(chosen);
        }
      }
    }
  }

  // Frames.

  // Order.

  /** Without ties the order of circles and obstacles changes no bit of times and motions. */
  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0", "3, 0", "4, 0", "5, 0", "1, -0.5", "2, -0.5", "3, -0.5"})
  void theOrderOfThingsChangesNoBit(long seed, double gravity) {
    SceneBuilder drawn = CollidingScenes.mixed(new Random(seed), 60).gravity(0, gravity);
    Scene scene = withoutOverlaps(drawn.build());
    List<Integer> circles = shuffled(scene.count(Kind.CIRCLE), new Random(seed));
    List<Integer> lines = shuffled(scene.count(Kind.LINE), new Random(seed));
    List<Integer> pegs = shuffled(scene.count(Kind.PEG), new Random(seed));
    Run run = Run.advance(new World(scene), 60);
    Run other = Run.advance(new World(SceneParts.of(scene, circles, lines, pegs)), 60);

    List<Seen> renamed = new ArrayList<>();
    for (Run.Row row : other.impacts()) {
      int obstacle =
          switch (row.kind()) {
            case WALL -> row.obstacle();
            case LINE -> lines.get(row.obstacle());
            case PEG -> pegs.get(row.obstacle());
            case CIRCLE -> circles.get(row.obstacle());
          };
      renamed.add(Seen.of(row, circles.get(row.circle()), obstacle));
    }
    List<Seen> first = new ArrayList<>();
    for (Run.Row row : run.impacts()) {
      first.add(Seen.of(row, row.circle(), row.obstacle()));
    }
    assertThat(run.impacts()).hasSizeGreaterThan(50);
    assertThat(renamed).isEqualTo(first);
    for (int i = 0; i < circles.size(); i++) {
      assertThat(other.end().get(i)).isEqualTo(run.end().get(circles.get(i)));
    }
  }

  /** A row in which the lower number comes first; the contact point is that of the one named. */
  private record Seen(
      double time, int circle, Kind kind, int obstacle, double nx, double ny, double v) {

    static Seen of(Run.Row row, int circle, int obstacle) {
      boolean turned = row.kind() == Kind.CIRCLE && circle > obstacle;
      double sign = turned ? -1 : 1;
      return new Seen(
          row.time(),
          turned ? obstacle : circle,
          row.kind(),
          turned ? circle : obstacle,
          sign * row.nx() + 0.0,
          sign * row.ny() + 0.0,
          row.speed());
    }
  }

  private static List<Integer> shuffled(int count, Random random) {
    List<Integer> order = new ArrayList<>(IntStream.range(0, count).boxed().toList());
    Collections.shuffle(order, random);
    return order;
  }

  /** The scene without the circles that have an impact at time 0, all of which would be ties. */
  private static Scene withoutOverlaps(Scene scene) {
    World world = new World(scene);
    world.step(0);
    List<Integer> early = new ArrayList<>();
    for (Run.Row row : Run.rows(world.impacts())) {
      early.add(row.circle());
      if (row.kind() == Kind.CIRCLE) {
        early.add(row.obstacle());
      }
    }
    return SceneParts.of(
        scene,
        IntStream.range(0, scene.count(Kind.CIRCLE))
            .filter(i -> !early.contains(i))
            .boxed()
            .toList(),
        IntStream.range(0, scene.count(Kind.LINE)).boxed().toList(),
        IntStream.range(0, scene.count(Kind.PEG)).boxed().toList());
  }
}
