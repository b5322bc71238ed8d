// SPDX-License-Identifier: Apache-2.0
package dev.carom.stability;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A circle that overlaps several things cannot get away from them. That is its own affair: others
 * arrive where they go, at their times, and neither their number nor the steps change a row.
 */
class TrappedTest {

  /** A disk on the three lines of a triangle, each of which turns it towards the other two. */
  private static SceneBuilder triangle() {
    SceneBuilder builder = Scene.builder().collide(false).line(-10, -2, 10, -2).line(-8, -6, 4, 8);
    return builder.line(8, -6, -4, 8).circle(0, 0, 5, 3, 1);
  }

  private static SceneBuilder bystanders(SceneBuilder scene, int count) {
    for (int i = 0; i < count; i++) {
      scene.circle(100 + 3 * i, 50, 1, 0, 1);
    }
    return scene;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 9_999})
  void itJamsAfterAsManyImpactsHoweverManyOthersThereAre(int others) {
    World world = new World(bystanders(triangle(), others).build());
    world.step(1);
    ImpactLog impacts = world.impacts();
    assertThat(impacts.size()).isBetween(1_537, 1_550);
    assertThat(impacts.outcome(impacts.size() - 1)).isEqualTo(Outcome.JAMMED);
    assertThat(world.vx(0)).isZero();
    assertThat(world.vy(0)).isZero();
    world.step(1e6);
    assertThat(world.impacts().size()).isZero();
    for (int i = 1; i <= others; i++) {
      assertThat(world.y(i)).isEqualTo(50 + world.now());
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 999})
  void soItDoesAmongCirclesThatCollide(int others) {
    World world = new World(bystanders(triangle(), others).collide(true).build());
    world.step(1);
    assertThat(world.impacts().size()).isBetween(1_537, 1_550);
    world.step(1e3);
    assertThat(world.impacts().size()).isZero();
  }

  @Test
  void anEditOfItsSurroundingsLetsItGo() {
    World world = new World(triangle().build());
    world.step(1);
    world.remove(Kind.LINE, 1);
    world.setVelocity(0, -3, 1);
    world.step(10);
    assertThat(world.x(0)).isLessThan(-20);
  }

  /** Some of a thousand disks thrown at random overlap several of 2,000 lines. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void ofAThousandThrownAtRandomAllArrive(long seed) {
    Random random = new Random(seed);
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 1000, 1000);
    for (int i = 0; i < 2_000; i++) {
      double x = 10 + 980 * random.nextDouble();
      double y = 10 + 980 * random.nextDouble();
      double angle = 2 * Math.PI * random.nextDouble();
      scene.line(x, y, x + 20 * Math.cos(angle), y + 20 * Math.sin(angle));
    }
    for (int i = 0; i < 1_000; i++) {
      double angle = 2 * Math.PI * random.nextDouble();
      double speed = 30 * random.nextDouble();
      double x = 5 + 990 * random.nextDouble();
      double y = 5 + 990 * random.nextDouble();
      scene.circle(x, y, 5, speed * Math.cos(angle), speed * Math.sin(angle));
    }
    World world = new World(scene.build());
    int[] rows = new int[1_000];
    BitSet jammed = new BitSet();
    for (int step = 1; step <= 60; step++) {
      world.advanceTo(step / 60.0);
      ImpactLog impacts = world.impacts();
      for (int i = 0; i < impacts.size(); i++) {
        rows[impacts.circle(i)]++;
        if (impacts.outcome(i) == Outcome.JAMMED) {
          jammed.set(impacts.circle(i));
        }
      }
    }
    assertThat(jammed.cardinality()).isBetween(15, 30);
    assertThat(Arrays.stream(rows).max().getAsInt()).isLessThanOrEqualTo(3_000);
    world.step(1);
    ImpactLog impacts = world.impacts();
    for (int i = 0; i < impacts.size(); i++) {
      assertThat(jammed.get(impacts.circle(i))).as("of a trapped one").isFalse();
    }
  }

  /** A clearance of 18 ulps among three points: too little for doubles to tell where it is. */
  @Test
  void aPocketOfSomeUlpsJams() {
    SceneBuilder scene = Scene.builder().peg(0, 1.000000000000004, 0);
    scene.peg(.866025403784442, -.500000000000002, 0).peg(-.866025403784442, -.500000000000002, 0);
    World world = new World(scene.circle(0, 0, 1, .3, .2).build());
    world.step(1);
    assertThat(world.impacts().size()).isBetween(1_537, 1_600);
    world.step(1);
    assertThat(world.impacts().size()).isZero();
  }
}
