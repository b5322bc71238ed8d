// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Equal circles in contact, row by row and column by column. More of it: CradleTest, RestTest. */
class LatticeTest {

  private static final int SIDE = 8;

  private static SceneBuilder square() {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 2 * SIDE, 2 * SIDE);
    for (int i = 0; i < SIDE * SIDE; i++) {
      int row = i / SIDE;
      builder.circle(1 + 2 * (i % SIDE), 1 + 2 * row, 1, 0, 0);
    }
    return builder;
  }

  /** With a slop of 1e-12 a naive overlap test finds every contact, each frame. */
  @Test
  void atRestNothingHappens() {
    World world = world(square());
    List<Run.State> before = Run.states(world);
    int contacts = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
      for (int j = 0; j < i; j++) {
        double d = Math.hypot(world.x(i) - world.x(j), world.y(i) - world.y(j));
        contacts += d < 2 + 1e-12 ? 1 : 0;
      }
    }
    assertThat(contacts).as("a naive test resolves").isEqualTo(2 * SIDE * (SIDE - 1));

    for (int frame = 1; frame <= 1000; frame++) {
      assertThat(Play.advance(world, frame)).isEmpty();
    }
    assertThat(Run.states(world)).isEqualTo(before);
  }

  /** A cue ball into fifteen in a triangle: momentum and energy are kept. */
  @Test
  void aBreakKeepsMomentumAndEnergy() {
    SceneBuilder builder = Scene.builder().circle(-10, 0.1, 1, 5, 0);
    for (int row = 0; row < 5; row++) {
      for (int k = 0; k <= row; k++) {
        builder.circle(row * Math.sqrt(3), 2 * k - row, 1, 0, 0);
      }
    }
    World world = world(builder);
    Play.finish(world, 20, 5);
    List<Run.State> states = Run.states(world);
    assertThat(states.stream().mapToDouble(s -> s.vx() * s.vx() + s.vy() * s.vy()).sum())
        .isCloseTo(25, within(1e-12));
    assertThat(states.stream().mapToDouble(Run.State::vx).sum()).isCloseTo(5, within(1e-13));
    assertThat(states.stream().mapToDouble(Run.State::vy).sum()).isCloseTo(0, within(1e-13));
  }
}
