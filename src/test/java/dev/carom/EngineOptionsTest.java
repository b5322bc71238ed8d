// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The machinery that a world chooses changes the cost and no bit of the result: asking every
 * obstacle and circle, and cells of any size, give the same impacts; so do circles and obstacles in
 * another order.
 */
class EngineOptionsTest {

  /** Grids of obstacles, and cells of circles in diameters. */
  private static final List<EngineOptions> MACHINERY =
      List.of(
          EngineOptions.EACH,
          new EngineOptions(false, 0, 1000, 1),
          new EngineOptions(true, 5, 1.5, 1),
          new EngineOptions(true, 17, 2, 1),
          new EngineOptions(true, 40, 5, 1),
          new EngineOptions(true, 64, 1000, 1),
          new EngineOptions(true, 200, 1.5, 1),
          new EngineOptions(true, 1000, 2, 1));

  static Stream<Arguments> recipes() {
    return Stream.of(
        recipe("mixed", RandomScenes::mixed),
        recipe("responses", RandomScenes::responses),
        recipe("long lines", RandomScenes::longLines),
        recipe("mixed radii", RandomScenes::mixedRadii),
        recipe("falling", RandomScenes::falling),
        recipe("open", RandomScenes::open),
        recipe("lattice", RandomScenes::lattice),
        recipe("crowd", random -> RandomScenes.crowd(random, 60)),
        recipe("gas", random -> RandomScenes.gas(random, 60)),
        recipe("inelastic", random -> RandomScenes.inelastic(random, 60)),
        recipe("heap", random -> RandomScenes.inelastic(random, 60).gravity(0, -0.05)));
  }

  private static Arguments recipe(String name, RandomScenes.Recipe recipe) {
    return Arguments.of(name, recipe);
  }

  @Tag("long")
  @ParameterizedTest(name = "{0}")
  @MethodSource("recipes")
  void cellsOfAnySizeGiveTheSame(String name, RandomScenes.Recipe recipe) {
    int impacts = 0;
    for (int seed = 0; seed < 4; seed++) {
      boolean collide = seed < 2;
      Scene scene = recipe.draw(new Random(seed)).collide(collide).build();
      double[] times = collide ? new double[] {0.5, 5, 12} : new double[] {0.5, 40, 250};
      Run chosen = Run.advance(new World(scene), times);
      for (EngineOptions options : MACHINERY) {
        assertThat(Run.advance(new World(scene, options), times))
            .as("seed %s, %s", seed, options)
            .isEqualTo(chosen);
      }
      impacts += chosen.impacts().size();
    }
    assertThat(impacts).isGreaterThan(100);
  }

  /** In cells smaller than the circles, and in one cell for all. */
  @ParameterizedTest
  @ValueSource(doubles = {0.7, 3, 4000})
  void inCellsOfExtremeSizes(double cell) {
    Scene scene = RandomScenes.mixed(new Random(99)).build();
    assertThat(Run.advance(new World(scene, EngineOptions.cells(cell)), 100))
        .isEqualTo(Run.advance(new World(scene, EngineOptions.EACH), 100));
  }

  /** So fast or slow that cells cannot be counted by time, or hardly. */
  @ParameterizedTest
  @ValueSource(ints = {-1000, -480, 480, 520, 990})
  void inAnyUnitOfTime(int exponent) {
    List<Run> runs = new ArrayList<>();
    for (EngineOptions options : List.of(EngineOptions.EACH, EngineOptions.cells(17))) {
      World world = new World(RandomScenes.mixed(new Random(7)).build(), options);
      for (int i : world.ids(Kind.CIRCLE)) {
        world.setVelocity(i, Math.scalb(world.vx(i), exponent), Math.scalb(world.vy(i), exponent));
      }
      runs.add(Run.advance(world, Math.scalb(5.0, -exponent)));
    }
    assertThat(runs.get(0)).isEqualTo(runs.get(1));
  }

  /** One ulp is a good part of a radius there: cells may not trust their rounding. */
  @ParameterizedTest
  @ValueSource(doubles = {1e6, 1e9, 1e12})
  void thePlainWayGivesTheSameFarFromTheOrigin(double far) {
    for (int seed = 0; seed < 2; seed++) {
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
      BesidePlain both = new BesidePlain(builder.build());
      int impacts = 0;
      for (double t = 4; impacts < 300 && t < 100; t += 4) {
        impacts += both.advanceTo(t);
      }
      assertThat(impacts).isGreaterThan(50);
    }
  }

  // Order.

  static Stream<Arguments> scenes() {
    Stream<Arguments> ofFiles =
        Stream.of("base-1.csv", "fast-1.csv", "radii.csv")
            .map(file -> Arguments.of(file, TestScenes.read(file), 600));
    Stream<Arguments> crowds =
        IntStream.range(1, 9)
            .mapToObj(
                seed ->
                    Arguments.of(
                        "crowd " + seed,
                        RandomScenes.crowd(new Random(seed), 60)
                            .gravity(0, seed > 5 ? -0.5 : 0)
                            .build(),
                        60));
    return Stream.concat(ofFiles, crowds);
  }

  /** Without ties the order of circles and obstacles changes no bit of times and motions. */
  @ParameterizedTest(name = "{0}")
  @MethodSource("scenes")
  void theOrderOfThingsChangesNoBit(String name, Scene drawn, double time) {
    Scene scene = withoutOverlaps(drawn);
    Random random = new Random(1);
    List<List<Integer>> things = new ArrayList<>();
    for (Kind kind : Kind.values()) {
      things.add(shuffled(scene.count(kind), random));
    }
    List<Integer> circles = things.get(Kind.CIRCLE.ordinal());
    List<Integer> lines = things.get(Kind.LINE.ordinal());
    Scene other = SceneParts.of(scene, circles, lines, things.get(Kind.PEG.ordinal()));
    things.set(Kind.WALL.ordinal(), List.of(0, 1, 2, 3));

    Run run = Run.advance(new World(scene), time);
    Run ofOther = Run.advance(new World(other), time);
    assertThat(run.impacts()).hasSizeGreaterThan(50);
    assertThat(
            ofOther.map(
                row ->
                    seen(
                        row,
                        circles.get(row.circle()),
                        things.get(row.kind().ordinal()).get(row.id()))))
        .isEqualTo(run.map(row -> seen(row, row.circle(), row.id())));
    for (int i = 0; i < circles.size(); i++) {
      assertThat(ofOther.end().get(i)).isEqualTo(run.end().get(circles.get(i)));
    }
  }

  /** The row in which the lower id comes first; the contact point is that of the one named. */
  private static Impact seen(Impact row, int circle, int id) {
    boolean pair = row.kind() == Kind.CIRCLE;
    boolean turned = pair && circle > id;
    double sign = turned ? -1 : 1;
    return new Impact(
        row.time(),
        turned ? id : circle,
        row.kind(),
        turned ? circle : id,
        row.part(),
        row.feature(),
        pair ? 0 : row.x(),
        pair ? 0 : row.y(),
        sign * row.nx() + 0.0,
        sign * row.ny() + 0.0,
        row.approachSpeed(),
        row.impulse(),
        row.outcome());
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
    for (Impact row : Run.rows(world.impacts())) {
      for (int id : new int[] {row.circle(), row.kind() == Kind.CIRCLE ? row.id() : -1}) {
        if (world.contains(Kind.CIRCLE, id)) {
          world.remove(Kind.CIRCLE, id);
        }
      }
    }
    List<Integer> lines = IntStream.range(0, scene.count(Kind.LINE)).boxed().toList();
    List<Integer> pegs = IntStream.range(0, scene.count(Kind.PEG)).boxed().toList();
    return SceneParts.of(scene, IntStream.of(world.ids(Kind.CIRCLE)).boxed().toList(), lines, pegs);
  }
}
