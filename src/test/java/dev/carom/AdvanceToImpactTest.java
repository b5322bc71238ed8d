// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class AdvanceToImpactTest {

  private static SceneBuilder room(Random random, boolean collide) {
    return collide ? RandomScenes.crowd(random, 12) : RandomScenes.mixed(random);
  }

  private static List<String> rows(ImpactLog log) {
    List<String> rows = new ArrayList<>();
    for (int row = 0; row < log.size(); row++) {
      rows.add(
          log.time(row)
              + " "
              + log.circle(row)
              + " "
              + log.kind(row)
              + log.id(row)
              + " "
              + log.x(row)
              + " "
              + log.y(row)
              + " "
              + log.outcome(row));
    }
    return rows;
  }

  /** From impact to impact, the same rows and the same end as in one step. */
  @CollidingOrNot
  void stopsCutARunAsStepsDo(boolean collide) {
    Random random = new Random(3);
    int stops = 0;
    for (int k = 0; k < 40; k++) {
      Scene scene = room(random, collide).build();
      double end = 1 + random.nextInt(40);
      World whole = new World(scene);
      if (!whole.advanceTo(end, Run.WORK)) {
        continue;
      }
      World cut = new World(scene);
      List<String> rows = new ArrayList<>();
      while (cut.advanceToImpact(end)) {
        rows.addAll(rows(cut.impacts()));
        stops++;
      }
      assertThat(cut.now()).isEqualTo(end);
      assertThat(rows).containsExactlyInAnyOrderElementsOf(rows(whole.impacts()));
      assertThat(cut.snapshot()).isEqualTo(whole.snapshot());
    }
    assertThat(stops).isGreaterThan(200);
  }

  /** A world that stands just before the stop has had no impact: not one is passed by. */
  @CollidingOrNot
  void nothingIsPassedBy(boolean collide) {
    Random random = new Random(4);
    int stops = 0;
    for (int k = 0; k < 30; k++) {
      Scene scene = room(random, collide).build();
      World world = new World(scene);
      world.advanceTo(1);
      if (!world.advanceToImpact(50)) {
        continue;
      }
      double first = world.impacts().time(0);
      stops++;
      assertThat(world.now()).isBetween(first, Math.nextUp(first));
      World before = new World(scene);
      before.advanceTo(1);
      before.advanceTo(Math.nextDown(first));
      assertThat(before.impacts().size()).isZero();
    }
    assertThat(stops).isGreaterThan(20);
  }

  /** The log tells the nearest double; the world stands there, or at the next one after it. */
  @Test
  void itStopsAtTheFirstDoubleThatIsNotBefore() {
    World world =
        new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 7, 3).build());
    int later = 0;
    for (int k = 0; k < 500; k++) {
      double vx = world.vx(0);
      double vy = world.vy(0);
      assertThat(world.advanceToImpact(1e9)).isTrue();
      assertThat(world.vx(0) != vx || world.vy(0) != vy).isTrue();
      double time = world.impacts().time(0);
      assertThat(world.now()).isIn(time, Math.nextUp(time));
      later += world.now() > time ? 1 : 0;
    }
    assertThat(later).isBetween(100, 400);
  }

  /** 40 / 3 is above its nearest double by a tail, and a sensor is no flight's end. */
  @CollidingOrNot
  void sensorsCount(boolean collide) {
    SceneBuilder scene = Scene.builder().collide(collide);
    scene.line(60, 0, 60, 100).response(Response.SENSOR).circle(10, 50, 10, 3, 0);
    World world = new World(scene.build());
    assertThat(world.advanceToImpact(100)).isTrue();
    assertThat(world.impacts().outcome(0)).isEqualTo(Outcome.SENSED);
    assertThat(world.now()).isBetween(40 / 3.0, Math.nextUp(40 / 3.0));
    assertThat(world.advanceToImpact(100)).isFalse();
    assertThat(world.now()).isEqualTo(100);
    assertThat(world.advanceToImpact(100)).isFalse();
  }

  /** Blocks of circles are looked through for the first one that is due. */
  @Test
  void ofManyCirclesTheFirstOneStops() {
    Random random = new Random(6);
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 1e6, 1e6);
    for (int k = 0; k < 3_000; k++) {
      scene.circle(
          1e5 + 8e5 * random.nextDouble(),
          1e5 + 8e5 * random.nextDouble(),
          1,
          random.nextGaussian(),
          random.nextGaussian());
    }
    Scene built = scene.build();
    World whole = new World(built);
    World cut = new World(built);
    whole.advanceTo(3e5);
    double[] times = new double[200];
    for (int k = 0; k < times.length; k++) {
      assertThat(cut.advanceToImpact(3e5)).isTrue();
      times[k] = cut.impacts().time(0);
      assertThat(times[k]).isEqualTo(whole.impacts().time(k));
    }
  }

  @Test
  void aTimeThatIsNotLaterIsRefused() {
    World world = new World(Scene.builder().circle(0, 0, 1, 1, 0).build());
    world.advanceTo(5);
    for (double t : new double[] {4, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThatThrownBy(() -> world.advanceToImpact(t))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith("t is " + t + ": expected a finite time, at least now, 5.0");
    }
  }
}
