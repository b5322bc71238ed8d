// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class GrownCircleTest {

  /** Where lines were removed, a grid may be left that is not worth another one, for a larger r. */
  @Test
  void whoGrowsAmongFewLinesThatHadAGridStillMeetsThem() {
    SceneBuilder builder = Scene.builder();
    for (int i = 0; i < 10; i++) {
      builder.line(6 * i, 0, 6 * i, 1);
    }
    World world = new World(builder.circle(-50, 8.5, 4.1, 1, 0).build());
    world.remove(ObstacleKind.LINE, 8);
    world.remove(ObstacleKind.LINE, 9);
    world.setRadius(0, 7.9);
    world.step(100);
    assertThat(world.impacts().size()).isEqualTo(1);
    assertThat(world.impacts().id(0)).isZero();
  }
}
