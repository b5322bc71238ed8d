// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A call that spends its budget throws, unless it was given one; and no bit depends on that. */
class UnfinishedTest {

  /** Circle 3 needs more impacts than a call may make; the circles 1 to 4 are there. */
  private static World endless(boolean collide) {
    SceneBuilder scene = Scene.builder().collide(collide).bounds(0, 0, 100, 100);
    for (int i = 0; i < 5; i++) {
      scene.circle(50, 10 + 20 * i, 5, i == 3 ? 0x1p29 : 1, 0);
    }
    World world = new World(scene.build());
    world.remove(Kind.CIRCLE, 0);
    return world;
  }

  private static UnfinishedException unfinished(Runnable call) {
    return catchThrowableOfType(UnfinishedException.class, call::run);
  }

  @CollidingOrNot
  void anEndlessStepThrowsAndNamesTheCircle(boolean collide) {
    World world = endless(collide);
    UnfinishedException e = unfinished(() -> world.step(1));
    assertThat(e.circle()).isEqualTo(3);
    assertThat(world.now()).isBetween(0.1, 0.9);
    assertThat(e)
        .hasMessageContaining("at time " + world.now())
        .hasMessageContaining("until 1.0")
        .hasMessageContaining("circle 3")
        .hasMessageContaining("advanceTo(t, work)");
    assertThat(unfinished(() -> world.advanceTo(world.now() + 1)).circle()).isEqualTo(3);
  }

  private static long hash(long before, ImpactLog log) {
    long hash = before;
    for (int row = 0; row < log.size(); row++) {
      hash = 31 * (31 * hash + Double.doubleToLongBits(log.time(row))) + log.circle(row);
    }
    return hash;
  }

  /** The log holds what was done, and the second call goes on: bounded otherwise, the same bits. */
  @CollidingOrNot
  void afterTheExceptionTheWorldGoesOn(boolean collide) {
    World world = endless(collide);
    assertThat(unfinished(() -> world.advanceTo(1))).isNotNull();
    assertThat(world.impacts().size()).isGreaterThan(500_000);
    long hash = hash(0, world.impacts());
    double end = 1.25 * world.now();
    world.advanceTo(end);
    hash = hash(hash, world.impacts());
    World other = endless(collide);
    boolean done = false;
    long otherHash = 0;
    while (!done) {
      done = other.advanceTo(end, 300_000);
      otherHash = hash(otherHash, other.impacts());
    }
    assertThat(hash).isEqualTo(otherHash);
    assertThat(world.snapshot()).isEqualTo(other.snapshot());
  }

  /** Any work will do, 1 too: so many calls, the same rows and the same end. */
  @CollidingOrNot
  void noBitDependsOnTheWork(boolean collide) {
    Random random = new Random(5);
    for (int k = 0; k < 20; k++) {
      Scene scene = (collide ? RandomScenes.crowd(random, 8) : RandomScenes.mixed(random)).build();
      World world = new World(scene);
      List<Impact> rows = Run.finish(world, 12, Run.WORK);
      for (long work : new long[] {1, 2, 7, 100, Long.MAX_VALUE}) {
        World other = new World(scene);
        assertThat(Run.finish(other, 12, work)).hasSameElementsAs(rows).hasSameSizeAs(rows);
        assertThat(other.snapshot()).as("work of %s", work).isEqualTo(world.snapshot());
      }
    }
  }

  /** Under gravity the circles of a heap are in contact, and ticks are work, too. */
  @CollidingOrNot
  void noBitOfAHeapDependsOnTheWork(boolean collide) {
    SceneBuilder scene = Scene.builder().collide(collide).bounds(0, 0, 10, 20).gravity(0, -10);
    scene.line(0, 4, 10, 2);
    for (int i = 0; i < 6; i++) {
      scene.circle(3 + 0.3 * i, 6 + 2 * i, 0.9, 0.1, 0).restitution(0.5);
    }
    World world = new World(scene.build());
    List<Impact> rows = Run.finish(world, 6, Run.WORK);
    for (long work : new long[] {1, 10, 1_000}) {
      World other = new World(world.scene());
      assertThat(Run.finish(other, 6, work)).hasSameElementsAs(rows).hasSameSizeAs(rows);
      assertThat(other.snapshot()).as("work of %s", work).isEqualTo(world.snapshot());
    }
  }

  /** There are many circles, so that the budget of each is small. */
  @Test
  void anUnfinishedStepReportsItsOwnImpactsOnly() {
    SceneBuilder scene = Scene.builder().collide(false).bounds(0, 0, 10, 10).circle(5, 5, 1, 0, 8);
    for (int i = 0; i < 400; i++) {
      scene.circle(5, 5, 1, i == 0 ? 1 : 0, 0);
    }
    World world = new World(scene.build());
    world.step(1);
    world.setVelocity(1, 1e150, 0);
    assertThat(world.advanceTo(2, Run.work(world, 20))).isFalse();
    assertThat(world.impacts()).isNotEmpty().allMatch(impact -> impact.time() >= 1);
    assertThat(world.y(0)).isBetween(1.0, 9.0);
    world.setVelocity(1, 0, 0);
    World other = new World(world.scene());
    other.advanceTo(world.now());
    world.advanceTo(20);
    other.advanceTo(20);
    assertThat(ofTheFirst(world)).hasSizeGreaterThan(10).isEqualTo(ofTheFirst(other));
    assertThat(world.y(0)).as("the others go on as they would").isEqualTo(other.y(0));
  }

  private static List<Impact> ofTheFirst(World world) {
    return Run.rows(world.impacts()).stream().filter(row -> row.circle() == 0).toList();
  }

  @ParameterizedTest
  @ValueSource(longs = {0, -1, Long.MIN_VALUE})
  void lessThanOneIsNoWork(long work) {
    World world = endless(false);
    assertThatThrownBy(() -> world.advanceTo(1, work))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("work is " + work + ": expected at least 1");
    assertThat(world.now()).isZero();
  }

  /** Stands for much work in one call: without it a loop takes millions of calls. */
  private static void workHard(World world) {
    world.engine.spent += 100_000;
  }

  /** At each impact the circle is sent back at once: the clock stands, and the budget is shared. */
  @CollidingOrNot
  void aLoopOfImpactsAtOneTimeEnds(boolean collide) {
    SceneBuilder scene = Scene.builder().collide(collide).bounds(0, 0, 100, 100);
    World world = new World(scene.circle(50, 50, 5, 1, 0).build());
    int[] calls = new int[1];
    Runnable loop =
        () -> {
          while (world.advanceToImpact(100)) {
            calls[0]++;
            workHard(world);
            world.setVelocity(0, 1, 0);
          }
        };
    assertThat(unfinished(loop).circle()).isZero();
    assertThat(world.now()).isEqualTo(45);
    assertThat(calls[0]).isEqualTo(22);
    world.setVelocity(0, 1, 0);
    assertThat(world.advanceToImpact(100)).as("a new budget").isTrue();
    assertThat(world.advanceToImpact(100)).as("it flies away").isFalse();
  }

  /**
   * A restored world has a budget of its own: whoever tries out futures from one moment needs it.
   */
  @Test
  void aRestoredWorldHasANewBudget() {
    World world = new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 5, 1, 0).build());
    Snapshot start = world.snapshot();
    for (int i = 0; i < 50; i++) {
      world.restore(start);
      assertThat(world.advanceToImpact(100)).isTrue();
      workHard(world);
    }
  }
}
