// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static dev.carom.stability.Play.advance;
import static dev.carom.stability.Play.among;
import static dev.carom.stability.Play.world;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dev.carom.Circle;
import dev.carom.Line;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Restitution 0, 1 and above 1: two bumpers that face each other. */
class RestitutionTest {

  private static final Line FLOOR = new Line(-1e6, 0, 1e6, 0);

  /**
   * Gravity is set before each frame: the naive circle creeps into the floor, and is pushed out.
   */
  @Test
  void withoutRestitutionItStaysOnTheFloor() {
    Naive naive = new Naive(new Circle(0, 5, 1), new Vec2(3, -1), FLOOR);
    double lowest = 5;
    for (int frame = 0; frame < 100; frame++) {
      naive.vy -= 0.1;
      naive.x += naive.vx;
      naive.y += naive.vy;
      lowest = Math.min(lowest, naive.y);
      naive.y -= naive.vy;
      naive.x -= naive.vx;
      naive.pushOut(1, 0);
    }
    assertThat(lowest).as("reaches into the floor").isLessThan(1);

    World world = world(among(FLOOR).restitution(0).circle(0, 5, 1, 3, -1));
    for (int frame = 1; frame <= 100; frame++) {
      world.setVelocity(0, world.vx(0), world.vy(0) - 0.1);
      advance(world, frame);
      assertThat(world.y(0)).isGreaterThanOrEqualTo(1);
      assertThat(world.vx(0)).as("friction is none").isEqualTo(3);
    }
    assertThat(world.y(0)).isEqualTo(1);
  }

  /** 80,000 bounces between two lines, of which one impact a frame would do a quarter. */
  @Test
  void elasticItKeepsItsSpeed() {
    Line roof = new Line(-1e6, 6, 1e6, 6);
    Naive naive = new Naive(new Circle(0, 3, 1), new Vec2(0, 16), FLOOR, roof);
    for (int frame = 0; frame < 100; frame++) {
      naive.oneImpactPerFrame(1);
    }
    assertThat(naive.impacts).as("16 / 4 impacts in each of 100 frames").isLessThan(200);

    World world = world(among(FLOOR, roof).circle(0, 3, 1, 0, 16));
    int impacts = 0;
    for (int frame = 1; frame <= 20_000; frame++) {
      impacts += advance(world, frame).size();
    }
    assertThat(impacts).isEqualTo(80_000);
    Play.assertState(world, 0, 0, 3, 0, 16);
  }

  /**
   * Each crossing takes half as long: infinitely many before 2 gaps / v, with speeds without end.
   */
  @Test
  @Timeout(value = 600, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void twoFacingBumpersEnd() {
    Line left = new Line(0, -50, 0, 50);
    double speed = 1;
    double time = 0;
    for (int i = 0; i < 2000; i++) {
      time += 8 / speed;
      speed *= 2;
    }
    assertThat(speed).as("a naive circle's speed").isInfinite();
    assertThat(time).as("at a time it never gets past").isLessThanOrEqualTo(16);

    World world =
        world(
            among(left).restitution(2).line(10, -50, 10, 50).restitution(2).circle(1, 0, 1, 1, 0));
    List<Run.Row> hits = Play.finish(world, 100, 5);
    assertThat(hits.get(1).time()).isEqualTo(8 + 4);
    assertThat(hits.get(1).speed()).isEqualTo(2);
    assertThat(hits).hasSizeBetween(50, 4_000);
    assertThat(hits).allMatch(hit -> hit.time() <= 16);
    assertThat(world.x(0)).isBetween(1.0, 9.0);
    assertThat(world.vx(0)).isFinite();
  }

  /** Two bumpers of a pair: e = 4 of the product gives (1 + 4) / 2 of the approach to the other. */
  @Test
  void ofAPairTheProductCounts() {
    World world =
        world(
            Scene.builder()
                .circle(0, 0, 1, 1, 0)
                .restitution(2)
                .circle(4, 0, 1, 0, 0)
                .restitution(2));
    assertThat(advance(world, 3)).hasSize(1);
    assertThat(world.vx(0)).isCloseTo(-1.5, within(1e-15));
    assertThat(world.vx(1)).isCloseTo(2.5, within(1e-15));
  }
}
