// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Gravity, set before each frame: what lies on each other stays so, and takes no time to speak of.
 */
class HeapTest {

  /** Disks of radius 3 in a box of 100, on a grid; and how far each is off it. */
  private static World heap(int count, double e, double off) {
    int side = count > 100 ? 15 : 10;
    double spacing = count > 100 ? 6.5 : 9;
    Random random = new Random(count);
    SceneBuilder scene = Scene.builder().bounds(0, 0, 100, 100).restitution(e);
    for (int i = 0; i < count; i++) {
      double x = 5 + spacing * (i % side) + off * random.nextDouble();
      int row = i / side;
      double y = 5 + spacing * row + off * random.nextDouble();
      scene.circle(x, y, 3, 0, 0).restitution(e);
    }
    return new World(scene.build());
  }

  /** The most rows of a frame from the given one on. */
  private static int play(World world, int frames, int from) {
    int most = 0;
    for (int frame = 0; frame < frames; frame++) {
      for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
        world.setVelocity(i, world.vx(i), world.vy(i) - 0.05);
      }
      world.step(1);
      most = frame < from ? most : Math.max(most, world.impacts().size());
    }
    return most;
  }

  private static double overlap(World world) {
    double most = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      double wall = Math.min(world.x(i), Math.min(100 - world.x(i), world.y(i)));
      most = Math.max(most, 3 - wall);
      for (int j = 0; j < i; j++) {
        double distance = Math.hypot(world.x(i) - world.x(j), world.y(i) - world.y(j));
        most = Math.max(most, 6 - distance);
      }
    }
    return most;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.3, 0.5, 0.8, 0.9})
  void columnsOfTenStand(double e) {
    World world = heap(100, e, 0);
    assertThat(play(world, 200, 100)).isLessThan(3_000);
    assertThat(overlap(world)).isLessThan(1e-13);
    assertThat(world.y(95)).isBetween(57 - 1e-9, 58.0);
  }

  /** Without friction no column stands that is not upright. */
  @Tag("long")
  @ParameterizedTest
  @CsvSource({"60, 0", "60, 0.5", "60, 0.3", "60, 0.9", "100, 0.8"})
  void heapsCollapseAndComeToRest(int count, double e) {
    World world = heap(count, e, 0.4);
    play(world, 150, 0);
    assertThat(overlap(world)).isLessThan(1e-12);
    double height = 0;
    for (int i = 0; i < count; i++) {
      height += world.y(i) / count;
    }
    assertThat(height).isLessThan(count == 60 ? 15 : 26);
  }

  private static World onTwoPegs(double apart, double x, double y) {
    SceneBuilder scene = Scene.builder().peg(0, 0, 1).peg(apart, 0, 1);
    return new World(scene.circle(x, y, 1, 0, 0).restitution(0).build());
  }

  /** It falls on one peg, then on the other, and both act at once: three rows a frame. */
  @Test
  void aBallWithoutBounceLiesOnTwoPegs() {
    World world = onTwoPegs(3, 1.5, 1.4);
    assertThat(play(world, 300, 0)).isLessThanOrEqualTo(3);
    assertThat(Math.hypot(world.x(0), world.y(0))).isBetween(2 - 1e-12, 2 + 1e-12);
    assertThat(world.vy(0)).isZero();
  }

  /** It slides into a gap of exactly its diameter, from peg to peg, until it touches both. */
  @Test
  void aBallWithoutBounceComesToAGapOfItsDiameter() {
    World world = onTwoPegs(4, 1.9, 3);
    assertThat(play(world, 11, 0)).isLessThanOrEqualTo(20);
    assertThat(world.x(0)).isCloseTo(2, within(1e-13));
    assertThat(world.y(0)).isBetween(0.0, 1e-6);
  }
}
