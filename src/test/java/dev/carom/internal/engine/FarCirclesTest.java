// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Filter;
import dev.carom.Internals;
import dev.carom.Kind;
import dev.carom.RandomScenes;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Traits;
import dev.carom.World;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Circles far from the others: they fly as well as all others, whichever way they came there, and
 * flying where nothing is costs next to nothing.
 */
class FarCirclesTest {

  /** The most work that a call may spend on a flight through nothing, of the millions it has. */
  private static final int LITTLE = 1_000;

  private static long spent(World world) {
    return ((CollidingEngine) Internals.engine(world)).spent;
  }

  private static void assertArrivesAtOnce(World world, double end) {
    long before = spent(world);
    world.advanceTo(end);
    assertThat(spent(world) - before).isLessThanOrEqualTo(LITTLE);
  }

  /**
   * A circle in bounds, and one outside that moves away: it once could not leave its first cell.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e3, 1e8, 1e9, 1e12, -1e9})
  void whoStartsFarOutsideOfTheBoundsFliesOn(double far) {
    for (int mask : new int[] {-1, 2}) {
      SceneBuilder scene = Scene.builder().bounds(0, 0, 10, 10).filter(new Filter(2, 2));
      scene.circle(5, 5, 0.5, 1, 1).circle(far, 5, 0.5, 1, 0).filter(new Filter(1, mask));
      World world = new World(scene.build());
      assertArrivesAtOnce(world, 1);
      assertThat(world.x(1)).isEqualTo(far + 1);
      assertArrivesAtOnce(world, 100);
    }
  }

  /** The same by an edit, from a snapshot, and as a new one. */
  @Test
  void whoIsPutFarOutsideFliesOn() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 10, 10);
    World world = new World(scene.circle(5, 5, 0.5, 1, 1).circle(2, 2, 0.5, 1, 0).build());
    world.setPosition(1, 1e9, 5);
    world.addCircle(1e9, -1e9, 0.5, 3, 4, Traits.DEFAULT);
    assertArrivesAtOnce(world, 1);
    World other = new World(world.scene());
    other.restore(world.snapshot());
    for (World each : new World[] {world, other}) {
      assertArrivesAtOnce(each, 100);
      assertThat(each.y(2)).isEqualTo(4 * 100 - 1e9);
    }
    world.remove(Kind.CIRCLE, 1);
    world.setShape(Kind.CIRCLE, 2, new Circle(world.x(2), world.y(2), 100));
    assertArrivesAtOnce(world, 101);
  }

  /** A ball that is parked high above, under gravity, in the world and in one restored from it. */
  @Test
  void whoIsParkedFarAwayDoesNotKeepARestoredWorldFromGoingOn() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 10, 10).filter(new Filter(2, 2));
    scene.gravity(0, -1).circle(5, 5, 0.5, 1, 0).circle(3, 5, 0.5, 0, 0).filter(new Filter(1, 1));
    World world = new World(scene.build());
    world.setPosition(1, 1, 1e9);
    assertArrivesAtOnce(world, 1);
    World other = new World(world.scene());
    other.restore(world.snapshot());
    for (World each : new World[] {world, other}) {
      assertArrivesAtOnce(each, 10);
      assertThat(each.y(1)).isEqualTo(1e9 - 50);
    }
  }

  @Test
  void twoThatFlyApartAndOneAloneArriveAtOnce() {
    SceneBuilder two = Scene.builder().circle(-1, 0, 0.5, -1, 0);
    World world = new World(two.circle(1, 0, 0.5, 1, 0.1).build());
    assertArrivesAtOnce(world, 1e7);
    assertArrivesAtOnce(world, 1e9);
    World alone = new World(Scene.builder().circle(1, 0, 0.5, 1, 0.1).build());
    assertArrivesAtOnce(alone, 1e9);
  }

  /** However long the way to each other is, and whether they have an area between them. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.25, 1})
  void twoThatComeFromAfarMeetAtOnce(double slope) {
    SceneBuilder scene = Scene.builder().circle(-1e9, -1e9 * slope, 0.5, 1, slope);
    World world = new World(scene.circle(1e9, 1e9 * slope, 0.5, -1, -slope).build());
    assertArrivesAtOnce(world, 1e9);
    assertThat(world.impacts().size()).isOne();
    assertThat(world.vx(0)).isNegative();
    assertArrivesAtOnce(world, 2e9);
  }

  /** A hundred balls that fell off the screen: each enters about 60 cells while time doubles. */
  @Test
  void whoFellOffTheScreenCostsNextToNothing() {
    Random random = new Random(1);
    SceneBuilder scene = Scene.builder().gravity(0, -1000);
    for (int i = 0; i < 100; i++) {
      double vx = 100 * random.nextGaussian();
      scene.circle(random.nextInt(800), random.nextInt(600), 10, vx, 100 * random.nextGaussian());
    }
    World world = new World(scene.build());
    world.advanceTo(5);
    long most = 60 * LITTLE;
    for (int minute = 1; minute <= 5; minute++) {
      long before = spent(world);
      for (int second = 60 * minute - 55; second < 60 * minute; second++) {
        world.advanceTo(second);
      }
      assertThat(spent(world) - before).isLessThan(most);
      most = 10 * LITTLE;
    }
  }

  /**
   * A gas that was moved to where cells are so wide that one holds it all. There a circle meets
   * others only; once it has cells of its size again, it leaves some between two collisions.
   */
  @Test
  void cellsFollowMostOfTheCircles() {
    double far = 0x1p20;
    SceneBuilder scene = RandomScenes.gas(new Random(1), 100);
    double right = far + 400;
    scene.line(far, 0, right, 0).line(far, 300, right, 300);
    scene.line(far, 0, far, 300).line(right, 0, right, 300);
    World world = new World(scene.circle(20, 20, 8, 0, 0).build());
    for (int i = 0; i < 100; i++) {
      world.setPosition(i, far + 20 + 36 * (i % 10), 20 + 28 * (i / 10));
    }
    double before = workPerImpact(world, 50);
    workPerImpact(world, 500);
    double after = workPerImpact(world, 550);
    assertThat(after).isGreaterThan(2 * before);
  }

  private static double workPerImpact(World world, double end) {
    double before = spent(world);
    int impacts = 0;
    while (world.now() < end) {
      world.step(1);
      impacts += world.impacts().size();
    }
    return (spent(world) - before) / impacts;
  }
}
