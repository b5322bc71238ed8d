// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Kind.CIRCLE;
import static dev.carom.Kind.LINE;
import static dev.carom.Kind.PEG;
import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.internal.state.EngineOptions;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A world and one that was restored from its snapshot get the same edits and steps, as in a game
 * that is played on two machines: their snapshots are equal at every moment.
 */
class LockstepTest {

  private static void assertSame(World world, Consumer<World> edit) {
    RestoredTwin twin = new RestoredTwin(world.scene(), EngineOptions.CHOSEN, new Random(1));
    twin.follow(world);
    edit.accept(world);
    edit.accept(twin.world());
    twin.compare(world);
    double end = world.now() + 10;
    world.advanceTo(end);
    twin.advance(world, end, Run.rows(world.impacts()));
  }

  /** A search had gone beyond now, in one world only, before there was a sensor. */
  @CollidingOrNot
  void theFirstSensorFindsNoDifference(boolean collide) {
    for (double vx : new double[] {0, 1}) {
      Scene scene = Scene.builder().collide(collide).peg(6, 7, 0).circle(1, 11, 1, vx, 0).build();
      World world = new World(scene);
      world.step(0.1);
      assertSame(world, w -> w.setTraits(PEG, 0, w.traits(PEG, 0).withResponse(Response.SENSOR)));
    }
  }

  /** Where there are bounds only, one that collides is not searched for until a wall is near. */
  @Test
  void theFirstObstacleFindsNoDifference() {
    for (double x : new double[] {2, 50}) {
      SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 100);
      World world = new World(scene.circle(x, 50, 1, 0.25, 0).build());
      world.step(0.1);
      assertSame(world, w -> w.addPeg(6, 7, 0, Traits.DEFAULT.withResponse(Response.SENSOR)));
    }
  }

  /**
   * Within the last place of now an edited circle has a sensor ahead, or a line, or both: they are
   * met with the next step.
   */
  @ParameterizedTest
  @CsvSource({"false, true", "false, false", "true, true", "true, false"})
  void whatAnEditedCircleMeetsAtOnceIsStillToBeMet(boolean collide, boolean sensorFirst) {
    double late = 0x1p50;
    double near = sensorFirst ? 1 : 2;
    SceneBuilder setup = Scene.builder().collide(collide);
    setup.line(10 + near, -9, 10 + near, 9).response(Response.SENSOR);
    Scene scene = setup.line(13 - near, -9, 13 - near, 9).circle(0, 0, 1, 0, 0).build();
    World world = new World(scene);
    world.advanceTo(late);
    world.setVelocity(0, 0x1p7, 0);
    assertSame(world, w -> w.setTraits(CIRCLE, 0, w.traits(CIRCLE, 0).withRestitution(0.5)));
    world.setVelocity(0, 0x1p7, 0);
    assertSame(world, w -> w.remove(LINE, 1));
    world.setVelocity(0, 0x1p7, 0);
    assertSame(world, w -> w.remove(LINE, 0));
  }

  /** An edit comes after the impacts of now, also of a circle that is gone. */
  @Test
  void theLastImpactOfACircleThatWasRemovedIsNotForgotten() {
    SceneBuilder setup = Scene.builder().bounds(0, 0, 10, 10).circle(5, 2, 1, 0.7, 0);
    Scene scene = setup.circle(5, 8, 1, 0, 0.3).build();
    int rounded = 0;
    for (Impact row : Run.advance(new World(scene), 200).impacts()) {
      World world = new World(scene);
      world.advanceTo(row.time());
      rounded += tail(world, row.circle()) > 0 ? 1 : 0;
      world.remove(CIRCLE, row.circle());
      assertSame(world, w -> w.setVelocity(1 - row.circle(), 0.1, 0.2));
    }
    assertThat(rounded).isPositive();
  }

  private static double tail(World world, int id) {
    world.circles.load(id);
    return world.circles.body.tl;
  }

  /** Contacts that are still to come at the time at which a budget was spent. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void anUnfinishedStepLeavesNoDifference(int sensors) {
    SceneBuilder builder =
        Scene.builder().collide(false).bounds(0, 0, 10, 10).circle(5, 5, 1, 8, 0);
    for (int i = 1; i < 400; i++) {
      builder.circle(5, 5, 1, 0, 0); // the more there are, the less each one may do
    }
    for (int i = 0; i < sensors; i++) {
      builder.line(8, 0, 8, 10).response(Response.SENSOR);
    }
    Scene scene = builder.peg(9, 9, 0).build();
    List<Consumer<World>> edits =
        List.of(
            w -> w.setTraits(CIRCLE, 0, w.traits(CIRCLE, 0).withRestitution(0.5)),
            w -> w.setTraits(PEG, 0, w.traits(PEG, 0).withResponse(Response.SENSOR)),
            w -> w.addLine(9, 0, 9, 10, Traits.DEFAULT.withResponse(Response.SENSOR)),
            w -> w.remove(PEG, 0),
            w -> w.setVelocity(0, 7, 1));
    for (Consumer<World> edit : edits) {
      World world = new World(scene);
      assertThat(world.advanceTo(1e9, Run.work(world, 5))).isFalse();
      assertSame(world, edit);
    }
  }
}
