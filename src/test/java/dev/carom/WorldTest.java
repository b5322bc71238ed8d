// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import dev.carom.internal.state.EngineDescription;
import dev.carom.internal.state.EngineOptions;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A world on scenes whose course can be worked out by hand. */
class WorldTest {

  private static World world(SceneBuilder builder) {
    return new World(builder.build());
  }

  private static void assertAt(World world, int id, double x, double y) {
    assertThat(new Vec2(world.x(id), world.y(id))).isEqualTo(new Vec2(x, y));
  }

  /** Velocities are rounded at each impact, by some ulps. */
  private static void assertMoves(World world, int id, double vx, double vy) {
    assertThat(world.vx(id)).isCloseTo(vx, within(2e-15));
    assertThat(world.vy(id)).isCloseTo(vy, within(2e-15));
  }

  /** A circle falls onto the floor, with a second one that flies past. */
  private static SceneBuilder floor() {
    return Scene.builder()
        .collide(false)
        .line(-100, 0, 100, 0)
        .circle(0, 10, 2, 1, -4)
        .circle(0, 20, 2, 0, 8);
  }

  // Clock and places.

  @Test
  void startsAtTimeZeroAsTheSceneSays() {
    Scene scene = floor().build();
    World world = new World(scene);
    assertThat(world.now()).isZero();
    assertThat(world.scene()).isSameAs(scene);
    assertThat(world.count(Kind.CIRCLE)).isEqualTo(2);
    assertThat(world.impacts().size()).isZero();
    assertThat(world.radius(1)).isEqualTo(2);
    assertAt(world, 0, 0, 10);
    assertMoves(world, 1, 0, 8);
  }

  @Test
  void fliesStraightUntilItsImpact() {
    World world = world(floor());
    world.step(1.5);
    assertAt(world, 0, 1.5, 4);
    assertMoves(world, 0, 1, -4);
    assertAt(world, 1, 0, 32);
    assertThat(world.impacts().size()).isZero();
  }

  @Test
  void bouncesInsideAStepAndUsesTheRestOfIt() {
    World world = world(floor());
    world.step(3);
    assertThat(world.now()).isEqualTo(3);
    assertAt(world, 0, 3, 6);
    assertMoves(world, 0, 1, 4);
  }

  @Test
  void theLogHoldsAllOfAnImpact() {
    World world = world(floor());
    world.step(3);
    ImpactLog log = world.impacts();
    assertThat(log.size()).isEqualTo(1);
    assertThat(log.time(0)).isEqualTo(2);
    assertThat(log.circle(0)).isZero();
    assertThat(log.kind(0)).isEqualTo(Kind.LINE);
    assertThat(log.id(0)).isZero();
    assertThat(log.feature(0)).isEqualTo(Feature.SIDE);
    assertThat(log.x(0)).isCloseTo(2, within(1e-14));
    assertThat(log.y(0)).isZero();
    assertThat(log.nx(0)).isZero();
    assertThat(log.ny(0)).isEqualTo(1);
    assertThat(log.approachSpeed(0)).isEqualTo(4);
    assertThat(log.outcome(0)).isEqualTo(Outcome.BOUNCED);
  }

  @Test
  void anImpactAtTheEndOfAStepBelongsToIt() {
    World world = world(floor());
    world.step(2);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertAt(world, 0, 2, 2);
    assertMoves(world, 0, 1, 4);
    world.step(1);
    assertThat(world.impacts().size()).isZero();
  }

  @Test
  void theLogIsAlwaysTheSameAndHoldsOnlyTheLastStep() {
    World world = world(floor());
    ImpactLog log = world.impacts();
    world.step(2);
    assertThat(log.size()).isEqualTo(1);
    world.step(0);
    assertThat(log.size()).isZero();
    assertThat(world.impacts()).isSameAs(log);
  }

  @Test
  void advanceToGoesThereExactly() {
    World world = world(floor());
    world.advanceTo(0.1);
    world.advanceTo(0.3);
    assertThat(world.now()).isEqualTo(0.3);
    world.advanceTo(0.3);
  }

  @Test
  void aWorldWithoutCirclesHasAClock() {
    World world = world(Scene.builder().bounds(0, 0, 9, 9).line(1, 1, 2, 2));
    world.step(7);
    assertThat(world.now()).isEqualTo(7);
  }

  // Arguments.

  /** Else a loop until some time would never end. */
  @CollidingOrNot
  void refusesAStepThatCannotMoveTheClock(boolean collide) {
    World world = new World(Scene.builder().collide(collide).circle(0, 0, 1, 0, 0).build());
    world.step(Double.MIN_VALUE);
    world.advanceTo(0x1p53);
    Snapshot before = world.snapshot();
    for (double dt : new double[] {Double.MIN_VALUE, 0.5, 1}) {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> world.step(dt))
          .withMessage(
              "dt is %s: expected 0, or enough to move the clock on from 9.007199254740992E15", dt);
    }
    assertThat(world.snapshot()).isEqualTo(before);
    world.step(0);
    world.step(-0.0);
    assertThat(world.now()).isEqualTo(0x1p53);
    world.step(Math.nextUp(1.0));
    assertThat(world.now()).isEqualTo(0x1p53 + 2);
    world.step(1);
    assertThat(world.now()).isEqualTo(0x1p53 + 4);
  }

  /** Where a step ended early, what is left of it always moves the clock. */
  @Test
  void whatIsLeftOfAnUnfinishedStepIsEnough() {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 10, 10).circle(5, 5, 1, 8, 0);
    for (int i = 1; i < 400; i++) {
      scene.circle(5, 5, 1, 0, 0);
    }
    World world = new World(scene.build());
    double end = Math.nextUp(20_000.0);
    int calls = 0;
    while (!world.advanceTo(end, Run.work(world, 5))) {
      assertThat(world.now() + (end - world.now())).isEqualTo(end).isGreaterThan(world.now());
      calls++;
    }
    assertThat(calls).isPositive();
    assertThat(world.now()).isEqualTo(end);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, -1, 0.999, Double.POSITIVE_INFINITY})
  void refusesToGoBack(double t) {
    World world = world(floor());
    world.advanceTo(1);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.advanceTo(t))
        .withMessageContaining("t is " + t)
        .withMessageContaining("1.0");
    assertThat(world.now()).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(ints = {-1, 1, 15, Integer.MAX_VALUE})
  void refusesRowsThatDoNotExist(int row) {
    World world = world(floor());
    world.step(3);
    ImpactLog log = world.impacts();
    for (Runnable query :
        List.<Runnable>of(
            () -> log.time(row),
            () -> log.circle(row),
            () -> log.kind(row),
            () -> log.id(row),
            () -> log.feature(row),
            () -> log.x(row),
            () -> log.y(row),
            () -> log.nx(row),
            () -> log.ny(row),
            () -> log.approachSpeed(row),
            () -> log.outcome(row))) {
      assertThatExceptionOfType(IndexOutOfBoundsException.class)
          .isThrownBy(query::run)
          .withMessage("row is " + row + ": expected 0 to 0");
    }
  }

  @Test
  void anEmptyLogHasNoRow() {
    ImpactLog log = world(floor()).impacts();
    assertThatExceptionOfType(IndexOutOfBoundsException.class)
        .isThrownBy(() -> log.time(0))
        .withMessage("row is 0: expected none, the log is empty");
  }

  // The order of the log.

  @Test
  void impactsStandInTheOrderOfTimeThenOfCircles() {
    SceneBuilder builder = Scene.builder().collide(false).line(-1000, 0, 1000, 0);
    for (int i = 0; i < 100; i++) {
      builder.circle(i, 2 + (i * 37 % 100) / 2, 2, 0, -1);
    }
    World world = world(builder);
    world.step(100);
    List<Impact> rows = Run.rows(world.impacts());
    assertThat(rows).hasSize(100);
    int together = 0;
    for (int i = 1; i < rows.size(); i++) {
      Impact before = rows.get(i - 1);
      Impact row = rows.get(i);
      assertThat(row.time()).isGreaterThanOrEqualTo(before.time());
      if (row.time() == before.time()) {
        assertThat(row.circle()).isGreaterThan(before.circle());
        together++;
      }
    }
    assertThat(together).as("two at each height").isEqualTo(50);
  }

  /** Two things are touched at t = 2, one at the left, one below; each turns another component. */
  private static Stream<Arguments> simultaneous() {
    return Stream.of(
        arguments(Scene.builder().bounds(5, 5, 99, 99), "WALL 0, WALL 2"),
        arguments(Scene.builder().line(0, 5, 40, 5).bounds(5, 0, 99, 99), "WALL 0, LINE 0"),
        arguments(Scene.builder().line(5, 0, 5, 40).bounds(0, 5, 99, 99), "WALL 2, LINE 0"),
        arguments(Scene.builder().line(0, 5, 40, 5).line(5, 0, 5, 40), "LINE 0, LINE 1"),
        arguments(Scene.builder().line(5, 0, 5, 40).line(0, 5, 40, 5), "LINE 0, LINE 1"),
        arguments(Scene.builder().peg(10, 2, 3).line(5, 0, 5, 40), "LINE 0, PEG 0"),
        arguments(Scene.builder().peg(10, 2, 3).bounds(5, 0, 99, 99), "WALL 0, PEG 0"),
        arguments(Scene.builder().peg(10, 2, 3).peg(3, 10, 2), "PEG 0, PEG 1"),
        arguments(Scene.builder().peg(3, 10, 2).peg(10, 2, 3), "PEG 0, PEG 1"));
  }

  @ParameterizedTest
  @MethodSource("simultaneous")
  void simultaneousImpactsAreTakenByKindThenByNumber(SceneBuilder builder, String expected) {
    Scene scene = builder.circle(12, 12, 5, -1, -1).build();
    for (EngineOptions options : List.of(EngineOptions.EACH, EngineOptions.cells(7))) {
      World world = new World(scene, options);
      world.advanceTo(2);
      List<Impact> rows = Run.rows(world.impacts());
      assertThat(rows).allMatch(row -> row.time() == 2);
      assertThat(
              rows.stream()
                  .map(row -> row.kind() + " " + row.id())
                  .collect(Collectors.joining(", ")))
          .isEqualTo(expected);
      assertMoves(world, 0, 1, 1);
    }
  }

  // Restitution.

  /** Restitutions of the obstacle and of the circle, and what their product leaves of 4. */
  @ParameterizedTest
  @CsvSource({"1,1,4", "0.5,1,2", "1,0.5,2", "0,1,0", "1,0,0", "2,1,8", "0.5,0.5,1", "0.25,4,4"})
  void restitutionActsAlongTheNormalAlone(double obstacle, double circle, double left) {
    List<SceneBuilder> floors =
        List.of(
            Scene.builder().line(-100, 0, 100, 0),
            Scene.builder().line(100, 0, -100, 0),
            Scene.builder().bounds(-100, 0, 100, 100));
    for (SceneBuilder floor : floors) {
      World world = world(floor.restitution(obstacle).circle(0, 10, 2, 3, -4).restitution(circle));
      world.advanceTo(2);
      assertThat(world.impacts().size()).isEqualTo(1);
      assertMoves(world, 0, 3, left);
    }
  }

  @ParameterizedTest
  @CsvSource({"1,1,4", "0.5,1,2", "0,1,0", "2,0.75,6"})
  void endpointsAndPegsHaveARestitutionToo(double obstacle, double circle, double left) {
    List<SceneBuilder> below =
        List.of(
            Scene.builder().line(0, 0, 0, -10),
            Scene.builder().peg(0, 0, 0),
            Scene.builder().peg(0, -3, 3));
    for (SceneBuilder builder : below) {
      World world =
          world(builder.restitution(obstacle).circle(0, 10, 2, 0, -4).restitution(circle));
      world.advanceTo(2);
      assertThat(world.impacts().size()).isEqualTo(1);
      assertMoves(world, 0, 0, left);
    }
  }

  // Walls, pegs, open scenes.

  /** Left 0, right 1, bottom 2, top 3; at t = 3 and t = 9 two of them at once. */
  @Test
  void theFourWallsAreNumbered() {
    World world = world(Scene.builder().bounds(0, 0, 20, 10).circle(10, 5, 2, 8, 1));
    world.advanceTo(9);
    assertThat(Run.rows(world.impacts()))
        .extracting(Impact::time, Impact::id)
        .containsExactly(
            tuple(1.0, 1),
            tuple(3.0, 0),
            tuple(3.0, 3),
            tuple(5.0, 1),
            tuple(7.0, 0),
            tuple(9.0, 1),
            tuple(9.0, 2));
    assertThat(Run.rows(world.impacts()))
        .allMatch(row -> row.kind() == Kind.WALL && row.feature() == Feature.SIDE);
  }

  @Test
  void theModelSaysWhatIsUsed() {
    SceneBuilder empty = Scene.builder().bounds(0, 0, 9, 9).circle(4, 4, 1, 1, 1);
    assertThat(world(empty).toString()).endsWith("; circles that collide, no lines or pegs]");
    assertThat(world(empty.collide(false)).toString())
        .endsWith("; circles that ignore each other, no lines or pegs]");
    assertThat(world(floor()).toString()).contains("1 line or peg without a grid");
    assertThat(new World(TestScenes.read("base-1.csv")).toString())
        .contains("100 lines and pegs in 1 grid of");
    assertThat(new World(TestScenes.read("base-1.csv"), EngineOptions.EACH).toString())
        .contains("100 lines and pegs without a grid");
    assertThat(new EngineDescription(true, 2, 1, 1, 30))
        .hasToString("circles that collide, 2 lines and pegs in 1 grid of 30 cells, and 1 moving");
    assertThat(new EngineDescription(false, 1, 0, 2, 30))
        .hasToString("circles that ignore each other, 1 line or peg in 2 grids of 30 cells");
  }

  @Test
  void aStepMayLeadToTheLastOfAllTimes() {
    World world = new World(Scene.builder().circle(0, 0, 1, 0, 0).build());
    world.step(Double.MAX_VALUE);
    assertThat(world.now()).isEqualTo(Double.MAX_VALUE);
  }

  @Test
  void eachLineIsTheSceneS() {
    Scene scene = Scene.builder().line(1, 2, 3, 4).line(5, 6, 7, 8).build();
    World world = new World(scene);
    assertThat(world.line(0)).isEqualTo((Line) scene.shape(Kind.LINE, 0));
    assertThat(world.line(1)).isEqualTo((Line) scene.shape(Kind.LINE, 1));
  }

  /** Coordinates may be -0; where a component of the normal is 0, it is not. */
  @Test
  void normalsHaveNoMinusZero() {
    SceneBuilder scene = Scene.builder().collide(false).line(-4, -0.0, 4, 0).circle(0, 3, 1, 0, -1);
    scene.circle(0, -3, 1, 0, 1).line(-0.0, 10, 0, 18).circle(3, 14, 1, -1, 0);
    World world = new World(scene.circle(-3, 14, 1, 1, 0).build());
    world.step(2);
    for (int row = 0; row < 4; row++) {
      double zero = row < 2 ? world.impacts().nx(row) : world.impacts().ny(row);
      assertThat(Double.doubleToRawLongBits(zero)).isZero();
    }
  }

  // The text for a debugger.

  @Test
  void aWorldTellsWhatIsThereAndWhen() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 9, 8).line(1, 2, 3, 4);
    World world = new World(scene.peg(5, 5, 1).peg(6, 5, 1).circle(7, 2, 1, 2, 0).build());
    world.remove(Kind.PEG, 0);
    world.addCircle(2, 7, 0.5, 0, 0, Traits.DEFAULT);
    world.step(1.5);
    assertThat(world)
        .hasToString(
            "World[now=1.5, 2 circles, bounds Bounds[xmin=0.0, ymin=0.0, xmax=9.0, ymax=8.0],"
                + " 1 impacts in the last step;"
                + " circles that collide, 2 lines and pegs without a grid]");
    assertThat(new World(Scene.builder().build()))
        .hasToString(
            "World[now=0.0, 0 circles, bounds none, 0 impacts in the last step;"
                + " circles that collide, no lines or pegs]");
  }

  @Test
  void aLogTellsItsFirstRows() {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 10, 20).line(4, 4, 6, 4);
    World world = new World(scene.circle(5, 2, 1, 0, 4).circle(5, 10, 1, 2, 0).build());
    assertThat(world.impacts()).hasToString("ImpactLog of 0 rows");
    world.step(1);
    assertThat(world.impacts())
        .hasToString(
            """
            ImpactLog of 2 rows
            0: time 0.25, circle 0, line 0 SIDE, approach speed 4.0
            1: time 0.75, circle 0, wall 2 SIDE, approach speed 4.0""");
    world.step(100);
    int size = world.impacts().size();
    assertThat(world.impacts().toString().lines())
        .hasSize(12)
        .startsWith(
            "ImpactLog of " + size + " rows",
            "0: time 1.25, circle 0, line 0 SIDE, approach speed 4.0")
        .endsWith("and " + (size - 10) + " more");
  }
}
