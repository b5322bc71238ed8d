// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles collide unless a scene says otherwise; a circle that is alone pays nothing for it. */
class LoneCircleTest {

  private static SceneBuilder box(double g) {
    return Scene.builder().bounds(0, 0, 800, 600).gravity(0, g).peg(400, 300, 30);
  }

  /** A tiny circle would otherwise spend its budget on cells of its own size. */
  @ParameterizedTest
  @ValueSource(doubles = {0, -0x1p-6})
  void itSpendsItsBudgetOnImpactsOnly(double g) {
    SceneBuilder scene = box(g).circle(100, 100, 0x1p-10, 300, 200);
    World world = new World(scene.build());
    World alone = new World(scene.collide(false).build());

    assertThat(world.advanceTo(300, 4_000)).isTrue();
    alone.advanceTo(300);
    assertThat(world.x(0)).isEqualTo(alone.x(0));
    assertThat(world.y(0)).isEqualTo(alone.y(0));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -0x1p-6})
  void itMeetsTheSecondOneThatComes(double g) {
    World world = new World(box(g).circle(100, 100, 5, 3, 0).build());
    world.step(1);
    int second = world.addCircle(200, 100, 5, -3, 0, Traits.DEFAULT);
    World both = new World(box(g).circle(100, 100, 5, 3, 0).circle(900, 100, 5, 0, 0).build());
    both.step(1);
    both.setPosition(second, 200, 100);
    both.setVelocity(second, -3, 0);
    world.advanceTo(100);
    both.advanceTo(100);

    assertThat(world.vx(second)).isPositive();
    for (int id = 0; id <= second; id++) {
      assertThat(world.x(id)).isEqualTo(both.x(id));
      assertThat(world.y(id)).isEqualTo(both.y(id));
    }
  }
}
