// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * No jitter, without a threshold: contact without approach is no impact, and what was just hit is
 * not hit again before a velocity changes; so circles at rest stay where they are, to the bit.
 */
@Tag("long")
class RestTest {

  private static int impactsOf(World world, int steps) {
    int impacts = 0;
    for (int i = 0; i < steps; i++) {
      world.step(1);
      impacts += world.impacts().size();
    }
    return impacts;
  }

  /** A pair, a chain from wall to wall, a pile in a corner, and one between line and peg. */
  private static SceneBuilder resting(double vx, double vy) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 40, 100);
    builder.line(0, 50, 40, 50).peg(20, 56, 1);
    for (int i = 0; i < 20; i++) {
      builder.circle(1 + 2 * i, 30, 1, vx, vy);
    }
    builder.circle(1, 1, 1, vx, vy).circle(3, 1, 1, vx, vy).circle(1, 3, 1, vx, vy);
    builder.circle(10, 70, 3, vx, vy).circle(14, 73, 2, vx, vy).restitution(0.5);
    builder.circle(20, 52.5, 2.5, vx, vy);
    return builder;
  }

  @Test
  void whatRestsInContactStaysThereForAMillionSteps() {
    World world = new World(resting(0, 0).build());
    List<Run.State> before = Run.states(world);
    assertThat(impactsOf(world, 1_000_000)).isZero();
    assertThat(Run.states(world)).isEqualTo(before);
  }

  /** Side by side at one velocity, along the walls they touch, until the end of the box. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-300, 1e-12, 1e-6, 1e-4})
  void whatMovesTogetherInContactMeetsNoOne(double speed) {
    World world = new World(chain(speed, 1).build());
    assertThat(impactsOf(world, 100_000)).isZero();
    for (int i = 0; i < 20; i++) {
      assertThat(world.x(i)).isEqualTo(1 + 2 * i);
      assertThat(world.vy(i)).isEqualTo(speed);
    }
  }

  /** From wall to wall, touching both. */
  private static SceneBuilder chain(double speed, double restitution) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 40, 100);
    for (int i = 0; i < 20; i++) {
      builder.circle(1 + 2 * i, 30, 1, 0, speed).restitution(restitution);
    }
    return builder;
  }

  @Test
  void whatMovesAlongAnotherTangentiallyLeavesIt() {
    Scene scene = Scene.builder().circle(0, 0, 1, 0, 0).circle(2, 0, 1, 0, 1e-9).build();
    World world = new World(scene);
    assertThat(impactsOf(world, 100_000)).isZero();
    assertThat(Run.states(world).get(0)).isEqualTo(new Run.State(0, 0, 0, 0));
  }

  /** However slowly: it is one collision, and they part. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-300, 1e-15, 1e-9, 1e-3})
  void aNearlyRestingPairInContactCollidesOnce(double speed) {
    Scene scene = Scene.builder().circle(0, 0, 1, speed, 0).circle(2, 0, 1, 0, 0).build();
    World world = new World(scene);
    assertThat(impactsOf(world, 100_000)).isEqualTo(1);
    assertThat(world.vx(0)).isZero();
    assertThat(world.vx(1)).isEqualTo(speed);
  }

  /** Rounding leaves them a last bit of approach or of parting; they do not hit again for it. */
  @Test
  void pairsWithoutBounceStayTogether() {
    int pairs = 100;
    SceneBuilder builder = Scene.builder();
    Random random = new Random(1);
    for (int i = 0; i < pairs; i++) {
      double angle = random.nextDouble() * 6;
      double y = 1e4 * i;
      builder.circle(0, y, 1, 0, 0).mass(1 + random.nextInt(5)).restitution(0);
      double x = 4 * Math.cos(angle);
      builder.circle(x, y + 4 * Math.sin(angle), 1, -x * 1e-3, -4e-3 * Math.sin(angle));
    }
    World world = new World(builder.build());
    assertThat(impactsOf(world, 100_000)).isEqualTo(pairs);
    for (int i = 0; i < pairs; i++) {
      double dx = world.x(2 * i + 1) - world.x(2 * i);
      double dy = world.y(2 * i + 1) - world.y(2 * i);
      assertThat(Math.hypot(dx, dy)).isBetween(2 - 1e-9, 2 + 1e-9);
    }
  }

  /** A wedge of two lines that opens upwards, and a circle that comes down into it. */
  private static World intoCorner(double halfAngle, double speed, double restitution) {
    double x = 100 * Math.sin(halfAngle);
    double y = 100 * Math.cos(halfAngle);
    return new World(
        Scene.builder()
            .line(0, 0, x, y)
            .restitution(restitution)
            .line(0, 0, -x, y)
            .restitution(restitution)
            .circle(0.3, 40, 1, 0, -speed)
            .build());
  }

  /**
   * It hits one side, slides down along it, hits the other one, and so on at one place: in a wedge
   * below a right angle it slides downwards each time, slower by the cosine of the angle, to rest.
   * The last bit of speed that rounding leaves makes it touch a side again once in very long.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0.02, 0.3, 0.7, 0.78})
  void aCircleThatComesToRestInACornerStaysThereForAMillionSteps(double halfAngle) {
    World world = intoCorner(halfAngle, 1, 0);
    world.step(1e6);
    List<Run.State> before = Run.states(world);
    assertThat(Math.hypot(world.vx(0), world.vy(0))).isLessThan(1e-15);
    assertThat(impactsOf(world, 1_000_000)).isLessThan(10);
    assertThat(world.x(0)).isCloseTo(before.get(0).x(), within(1e-12));
    assertThat(world.y(0)).isCloseTo(before.get(0).y(), within(1e-12));
  }

  /** Gravity, set before each frame: one impact a frame, and not a bit of creeping. */
  @Test
  void aCirclePressedToTheFloorEachFrameStaysThere() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 40, 40).restitution(0);
    scene.circle(20.3, 1, 1, 0, 0).circle(39, 1, 1, 0, 0).circle(37, 1, 1, 0, 0).collide(true);
    World world = new World(scene.build());
    List<Run.State> before = Run.states(world);
    int impacts = 0;
    for (int frame = 0; frame < 50_000; frame++) {
      for (int id = 0; id < 3; id++) {
        world.setVelocity(id, world.vx(id), world.vy(id) - 0.01);
      }
      world.step(1);
      impacts += world.impacts().size();
    }
    assertThat(impacts).isEqualTo(150_000);
    assertThat(Run.states(world)).isEqualTo(before);
  }
}
