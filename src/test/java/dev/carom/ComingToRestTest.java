// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.box;
import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How bounces under gravity end: when, where, after how many rows, and that no row follows. */
class ComingToRestTest {

  /**
   * From rest at height h to the floor in t1 = sqrt(2 h / g); each bounce takes e times the time of
   * the one before, so all end at t1 (1 + e) / (1 - e).
   */
  @ParameterizedTest
  @CsvSource({"0, 2", "0.1, 10", "0.3, 20", "0.5, 30", "0.9, 200", "0.99, 2000"})
  void aBallComesToRestWhenTheorySays(double e, int most) {
    World world = new World(box().circle(50, 11, 1, 0, 0).restitution(e).build());
    double first = Math.sqrt(2 * 10 / 10.0);
    double rest = first * (1 + e) / (1 - e);
    int rows = rows(world, rest * (1 - 1e-6));
    if (e > 0) {
      assertThat(world.vy(0)).isNotZero();
    }
    rows += rows(world, rest * (1 + 1e-6));
    assertThat(world.vy(0)).isZero();
    assertThat(world.y(0)).isCloseTo(1, within(2e-14));
    assertThat(rows).isLessThanOrEqualTo(most);
    assertThat(rows(world, 1e6)).isZero();
    assertThat(world.isResting(0)).isTrue();
    world.setVelocity(0, 0, 3);
    assertThat(world.isResting(0)).isFalse();
  }

  @Test
  void theApexesOfABallFallByTheSquareOfItsRestitution() {
    World world = new World(box().circle(50, 17, 1, 0, 0).restitution(0.8).build());
    double height = 16;
    for (int i = 0; i < 10; i++) {
      assertThat(world.advanceToImpact(1e9)).isTrue();
      height *= 0.64;
      assertThat(world.vy(0) * world.vy(0) / 20).isCloseTo(height, within(1e-12 * 16));
    }
  }

  @ParameterizedTest
  @CsvSource({"0", "0.5", "0.9"})
  void aBallComesToRestInAWedge(double e) {
    World world =
        new World(
            Scene.builder()
                .gravity(0, -10)
                .line(-50, 50, 0, 0)
                .line(0, 0, 60, 40)
                .circle(-10, 30, 1, 3, 0)
                .restitution(e)
                .build());
    int rows = rows(world, 200);
    assertThat(world.vx(0)).isZero();
    assertThat(world.vy(0)).isZero();
    assertThat(rows(world, 1000)).isZero();
    assertThat(rows).isLessThan(2000);
  }

  /**
   * Between a line that moves slowly and a wall: the gap between them closes without end. With
   * impacts of two finite masses that are not counted, these seeds need more than one call.
   */
  @ParameterizedTest
  @ValueSource(ints = {28, 41, 61, 69, 70, 75})
  void twoBallsInAWedgeThatClosesAreJammed(int seed) {
    Random random = new Random(seed);
    double e = seed % 2 == 0 ? 1 : 0.8 + 0.2 * random.nextDouble();
    double g = random.nextInt(3) == 0 ? 10 : 0.1;
    double speed = random.nextDouble() * (g > 1 ? 5 : 0.5);
    SceneBuilder builder = Scene.builder().bounds(0, 0, 100, 100).gravity(0, -g);
    double x = 20 + 10 * random.nextDouble();
    double y = 20 + 10 * random.nextDouble();
    builder.line(x, y, x + 60, y + 60 * random.nextDouble());
    builder.velocity(speed * random.nextGaussian(), speed);
    for (int left = 20; left <= 60; left += 40) {
      double at = left + 20 * random.nextDouble();
      double radius = 3 + 3 * random.nextDouble();
      builder.circle(at, 85, radius, random.nextGaussian(), 0).restitution(e);
    }
    World world = new World(builder.build());
    for (int i = 1; i <= 100; i++) {
      world.advanceTo(1.2 * i / speed);
    }
  }

  /**
   * What the bounce leaves it is no hop from the floor; along that it still leads into the line.
   */
  @Test
  void aBallOnTheFloorDoesNotCreepIntoALineThatLeansOverIt() {
    World world = new World(box().line(14, 0, 7, 8).circle(5, 2, 2, 1, 0).restitution(0.5).build());
    rows(world, 1e9);
    assertThat(Falling.overlap(world)).isLessThan(1e-13);
    assertThat(world.vx(0)).isNotPositive();
  }

  /** Thrown up so that it comes to the peg's lowest point almost at its apex. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void nothingHangsUnderAPeg(double e) {
    double speed = Math.sqrt(16 * (1 + 1e-5));
    World world =
        new World(
            Scene.builder()
                .gravity(0, -8)
                .peg(0, 3, 1)
                .circle(0, 0, 1, 0, speed)
                .restitution(e)
                .build());
    assertThat(rows(world, 2)).isEqualTo(1);
    assertThat(world.isResting(0)).isFalse();
    assertThat(world.y(0)).isLessThan(-5);
  }
}
