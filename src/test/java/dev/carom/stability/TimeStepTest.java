// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.Run.states;
import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Time steps of 0, the least double, 1e150, and those that are refused. */
class TimeStepTest {

  private static final Line FLOOR = new Line(-100, 0, 100, 0);

  private static SceneBuilder falling() {
    return among(FLOOR).circle(0, 10, 1, 0, -1);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, Double.MIN_VALUE})
  void stepsOfNoLengthMoveNothing(double dt) {
    World world = world(falling());
    for (int i = 0; i < 1000; i++) {
      world.step(dt);
    }
    assertThat(world.now()).isEqualTo(1000 * dt);
    Play.assertState(world, 0, 0, 10, 0, -1);
  }

  /** Frame after frame a naive circle that overlaps is turned round, and round again. */
  @Test
  void aStepOfZeroTakesTheImpactOfNowOnce() {
    Naive naive = new Naive(new Circle(0, 1, 1), new Vec2(0, -1), FLOOR);
    naive.impactsPerFrame(1, 1);
    assertThat(naive.y).as("in touch, it sinks in").isLessThan(1);

    World world = world(among(FLOOR).circle(0, 1, 1, 0, -1));
    world.step(0);
    assertThat(Run.rows(world.impacts())).hasSize(1);
    world.step(0);
    assertThat(Run.rows(world.impacts())).isEmpty();
    Play.assertState(world, 0, 0, 1, 0, 1);
  }

  /** 1e150 frames in a box: the budget ends each call, and each goes on from there. */
  @Test
  @Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void aStepOf1e150IsUnfinishedAndGoesOn() {
    Naive naive = new Naive(new Circle(5, 5, 1), new Vec2(3, 2), FLOOR);
    naive.overlapTest(1e150);
    assertThat(naive.x).as("anywhere").isGreaterThan(1e149);

    for (boolean collide : new boolean[] {false, true}) {
      SceneBuilder builder = Scene.builder().collide(collide).bounds(0, 0, 10, 10);
      builder.circle(5, 5, 1, 3, 2);
      for (int i = 0; i < 399 && !collide; i++) {
        builder.circle(5, 5, 1, 0, 0);
      }
      World world = new World(builder.build());
      double now = 0;
      int impacts = 0;
      for (int call = 0; call < 3; call++) {
        assertThat(world.advanceTo(world.now() + 1e150, Run.work(world, 20))).isFalse();
        assertThat(world.now()).isGreaterThan(now);
        now = world.now();
        impacts += world.impacts().size();
        assertThat(world.x(0)).isBetween(1 - 1e-9, 9 + 1e-9);
      }
      // 3 / 8 and 2 / 8 impacts a frame.
      assertThat((double) impacts).isBetween(now * 5 / 8 - 3, now * 5 / 8 + 3);
    }
  }

  @ParameterizedTest
  @ValueSource(
      doubles = {
        Double.NaN,
        -1,
        -Double.MIN_VALUE,
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY
      })
  void otherStepsAreRefusedAndChangeNothing(double dt) {
    World world = world(falling());
    world.step(3);
    List<Run.State> before = states(world);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.step(dt))
        .withMessageContaining("dt is " + dt)
        .withMessageContaining("expected at least 0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> world.advanceTo(dt))
        .withMessageContaining("t is " + dt);
    assertThat(world.now()).isEqualTo(3);
    assertThat(states(world)).isEqualTo(before);
    world.step(7);
    Play.assertState(world, 0, 0, 2, 0, 1);
  }

  /** There are many circles, so that the budget of each is small. */
  @Test
  void anUnfinishedStepReportsItsOwnImpactsOnly() {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 10, 10).circle(5, 5, 1, 0, 8);
    for (int i = 0; i < 400; i++) {
      scene.circle(5, 5, 1, i == 0 ? 1 : 0, 0);
    }
    World world = new World(scene.build());
    world.step(1);
    assertThat(world.impacts().size()).isPositive();
    world.setVelocity(1, 1e150, 0);
    assertThat(world.advanceTo(2, Run.work(world, 20))).isFalse();
    assertThat(world.impacts().size()).isPositive();
    for (int row = 0; row < world.impacts().size(); row++) {
      assertThat(world.impacts().time(row)).isGreaterThanOrEqualTo(1);
    }
    assertThat(world.y(0)).isBetween(1.0, 9.0);
    world.setVelocity(1, 0, 0);
    World other = new World(world.scene());
    other.advanceTo(world.now());
    world.advanceTo(20);
    other.advanceTo(20);
    assertThat(impactsOfTheFirst(world)).isEqualTo(impactsOfTheFirst(other)).isGreaterThan(10);
    assertThat(world.y(0)).as("the others go on as they would").isEqualTo(other.y(0));
    assertThat(world.vy(0)).isEqualTo(other.vy(0));
  }

  private static int impactsOfTheFirst(World world) {
    int count = 0;
    for (int row = 0; row < world.impacts().size(); row++) {
      count += world.impacts().circle(row) == 0 ? 1 : 0;
    }
    return count;
  }
}
