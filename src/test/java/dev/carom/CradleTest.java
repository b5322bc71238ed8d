// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Newton's cradle: of equal circles in contact as many leave as come in, and the rest stand. */
class CradleTest {

  @ParameterizedTest
  @CsvSource({"1, 1", "1, 4", "2, 3", "3, 2", "4, 1", "5, 5", "1, 200", "500, 500"})
  void asManyLeaveAsComeIn(int moving, int resting) {
    SceneBuilder builder = Scene.builder().bounds(-1100, -5, 1100, 5);
    for (int i = 0; i < moving; i++) {
      builder.circle(2 * (i - moving) - 3, 0, 1, 1, 0);
    }
    for (int i = 0; i < resting; i++) {
      builder.circle(2 * i, 0, 1, 0, 0);
    }
    World world = new World(builder.build());
    world.advanceTo(10);
    assertThat(world.impacts().size()).isEqualTo(moving * resting);
    for (int i = 0; i < moving + resting; i++) {
      assertThat(world.vx(i)).as("circle %s", i).isEqualTo(i < resting ? 0 : 1);
      assertThat(world.vy(i)).isZero();
      assertThat(world.y(i)).isZero();
    }
    assertThat(world.x(moving + resting - 1)).isEqualTo(2 * (resting - 1) + 7);
  }
}
