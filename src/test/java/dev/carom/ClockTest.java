// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * A frame is as accurate after a million frames as after one: the same states, started late and
 * started at 0, make the same impacts to the bit. A single double as clock would know times of 1e6
 * only to 1e-10.
 *
 * <p>So that the state at the late start is known exactly, the circles spend 2^20 frames in a
 * shaft, bounce to and fro between its walls in exactly 128 frames, and drift upward by exactly
 * 2^-4 a frame. Then they come into a field of pegs and lines.
 *
 * <pre>
 *     | *  \   --  |
 *     |   /  *    \|     the field, 64 high
 *     |            |
 *     |  <-- o --> |     the shaft, 2^16 high
 *     |            |
 * </pre>
 */
@Tag("long")
class ClockTest {

  private static final double LATE = 0x1p20;
  private static final double DRIFT = 0x1p-4;
  private static final int CIRCLES = 64;
  private static final int FRAMES = 600;

  /** At time 0 the circles are so many frames from the field. */
  private static Scene scene(double frames) {
    SceneBuilder builder = Scene.builder().collide(false).bounds(0, -70_000, 66, 64);
    for (int i = 0; i < CIRCLES; i++) {
      builder.circle(i + 1, -frames * DRIFT, 1, i % 2 == 0 ? 1 : -1, DRIFT);
    }
    Random random = new Random(11);
    for (int i = 0; i < 100; i++) {
      double x = 66 * random.nextDouble();
      double y = 4 + 60 * random.nextDouble();
      if (i % 2 == 0) {
        builder.peg(x, y, random.nextDouble());
      } else {
        builder.line(x, y, x + random.nextGaussian(), y + 2 * random.nextDouble());
      }
    }
    return builder.build();
  }

  private static World late() {
    World world = new World(scene(LATE));
    world.advanceTo(LATE);
    return world;
  }

  private static World early() {
    return new World(scene(0));
  }

  @Test
  void afterAMillionFramesTheStatesAreThoseOfTheStart() {
    World world = late();
    assertThat(world.impacts().size()).isEqualTo(CIRCLES * 16_384);
    for (int i = 0; i < CIRCLES; i++) {
      Run.State state = Run.states(world).get(i);
      assertThat(state.x()).isEqualTo(i + 1);
      assertThat(state.y()).isZero();
      assertThat(state.vx()).isEqualTo(i % 2 == 0 ? 1 : -1);
      assertThat(state.vy()).isEqualTo(DRIFT);
    }
  }

  @Test
  void theSameImpactsFollowAsFromTimeZero() {
    World late = late();
    World early = early();
    Run lateRun = Run.step(late, 1, FRAMES);
    Run earlyRun = Run.step(early, 1, FRAMES);
    assertThat(earlyRun.impacts().stream().filter(row -> row.kind() != Kind.WALL).count())
        .isGreaterThan(80);
    assertThat(lateRun.impacts())
        .usingRecursiveFieldByFieldElementComparatorIgnoringFields("time")
        .isEqualTo(earlyRun.impacts());
    for (int i = 0; i < lateRun.impacts().size(); i++) {
      assertThat(lateRun.impacts().get(i).time() - LATE)
          .isCloseTo(earlyRun.impacts().get(i).time(), within(Math.ulp(LATE)));
    }
  }

  /**
   * To the rounding of the time since the last impact, below 1,024, and of the place: 2^-44 each,
   * in both worlds.
   */
  @Test
  void theSamePlacesFollowAsFromTimeZero() {
    World late = late();
    World early = early();
    for (int frame = 1; frame <= FRAMES; frame++) {
      late.step(1);
      early.step(1);
      for (int i = 0; i < CIRCLES; i++) {
        assertThat(late.x(i)).isCloseTo(early.x(i), within(0x1p-42));
        assertThat(late.y(i)).isCloseTo(early.y(i), within(0x1p-42));
        assertThat(late.vx(i)).isEqualTo(early.vx(i));
        assertThat(late.vy(i)).isEqualTo(early.vy(i));
      }
    }
  }
}
