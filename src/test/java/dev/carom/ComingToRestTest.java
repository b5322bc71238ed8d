// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.box;
import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How bounces under gravity end: when, where, after how many rows, and that no row follows. */
class ComingToRestTest {

  @ParameterizedTest
  @CsvSource({"0.5, 30", "0.9, 200", "0, 2"})
  void aBallComesToRestWhenTheorySays(double e, int most) {
    World world = new World(box().circle(50, 11, 1, 0, 0).restitution(e).build());
    double first = Math.sqrt(2 * 10 / 10.0);
    double rest = first * (1 + e) / (1 - e);
    int rows = rows(world, rest * (1 - 1e-6));
    assertThat(e == 0 ? 1 : Math.abs(world.vy(0))).isGreaterThan(0);
    rows += rows(world, rest * (1 + 1e-6));
    assertThat(world.vy(0)).isZero();
    assertThat(world.y(0)).isCloseTo(1, within(1e-14));
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
      assertThat(world.advanceToImpact(1e9)).isEqualTo(StopReason.IMPACT);
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

  /** Between a line that moves slowly and a wall: the gap between them closes without end. */
  @Test
  void twoBallsInAWedgeThatClosesAreJammed() {
    World world =
        new World(
            Scene.builder()
                .collide(true)
                .bounds(0, 0, 200, 150)
                .gravity(0, -0.103)
                .line(37.7, 37.2, 93.9, 93.4)
                .velocity(-0.4465043250932107, 0.27527439287918987)
                .circle(20, 135, 5.600229664270529, -0.1067, 0)
                .restitution(0.82)
                .circle(70, 135, 6.364845897878658, -0.1419, 0)
                .restitution(0.83)
                .build());
    for (int i = 1; i <= 250; i++) {
      assertThat(world.advanceTo(i)).as("at %d", i).isTrue();
    }
  }
}
