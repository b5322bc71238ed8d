// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles that lie on each other rest if their contacts can hold them, until something changes. */
class HeapTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private static SceneBuilder open() {
    return Scene.builder().gravity(0, -10);
  }

  /** Two balls side by side between walls, and one that comes down between them. */
  private static World three(double width, double e) {
    SceneBuilder builder = open().bounds(0, 0, width, 100);
    builder.circle(1, 1, 1, 0, 0).restitution(e).circle(width - 1, 1, 1, 0, 0).restitution(e);
    return new World(builder.circle(width / 2, 3, 1, 0, 0).restitution(e).build());
  }

  private static World threeAtRest() {
    World world = three(4.2, 0.5);
    rows(world, 10);
    assertThat(resting(world)).containsExactly(0, 1, 2);
    return world;
  }

  private static int[] resting(World world) {
    return IntStream.range(0, world.idLimit(Kind.CIRCLE))
        .filter(i -> world.contains(Kind.CIRCLE, i) && world.isResting(i))
        .toArray();
  }

  /** Also where the lower two fill the floor, and have no room for hops. */
  @ParameterizedTest
  @CsvSource({"4, 0", "4, 0.5", "4, 0.9", "4.001, 0.8", "4.2, 0", "4.2, 0.5", "4.2, 0.9"})
  void aBallRestsOnTwoBetweenWalls(double width, double e) {
    World world = three(width, e);
    int settled = 0;
    while (world.now() < 20) {
      world.step(0.25);
      for (int row = 0; row < world.impacts().size(); row++) {
        boolean isOf2 = world.impacts().kind(row) == Kind.CIRCLE;
        boolean rests = world.impacts().outcome(row) == Outcome.SETTLED;
        settled += isOf2 && rests ? 1 : 0;
      }
    }
    assertThat(resting(world)).containsExactly(0, 1, 2);
    if (e > 0) {
      assertThat(settled).as("rows that tell of it").isPositive();
    }
    assertThat(rows(world, 1e6)).isZero();
  }

  /** Nothing holds the lower two: they slide aside, without friction. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aBallDoesNotRestOnTwoThatCanMoveAside(double e) {
    SceneBuilder builder = open().bounds(0, 0, 40, 100);
    builder.circle(19, 1, 1, 0, 0).restitution(e).circle(21, 1, 1, 0, 0).restitution(e);
    World world = new World(builder.circle(20, 2.8, 1, 0, 0).restitution(e).build());
    rows(world, 10);
    assertThat(world.y(2)).isLessThan(1.01);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aBallRestsOnTopOfAnInfinitelyHeavyOne(double e) {
    SceneBuilder builder = open().circle(0, 0, 2, 0, 0).mass(INFINITE).restitution(e);
    World world = new World(builder.circle(0, 3.5, 1, 0, 0).restitution(e).build());
    rows(world, 30);
    assertThat(world.isResting(1)).isTrue();
    assertThat(world.y(1)).isBetween(3.0, 3 + 3 * 0x1p-7);
    assertThat(rows(world, 1e6)).isZero();
    world.setVelocity(0, 0, -1);
    rows(world, 1e6 + 1);
    assertThat(world.y(1)).as("it follows what sinks").isLessThan(2.1);
  }

  @Test
  void elasticBallsDoNotRest() {
    World world = three(4.5, 1);
    rows(world, 20);
    assertThat(resting(world)).doesNotContain(2);
    assertThat(rows(world, 21)).isPositive();
  }

  @Test
  void aSlowBallLandsOnAHeapThatRests() {
    World world = threeAtRest();
    int id = world.addCircle(world.x(2), world.y(2) + 2 + 1e-5, 1, 0, 0, Traits.DEFAULT);
    world.setTraits(Kind.CIRCLE, id, world.traits(Kind.CIRCLE, id).withRestitution(0.5));
    world.advanceTo(world.now() + 0.01);
    assertThat(world.impacts().size()).isPositive();
    assertThat(resting(world)).containsExactly(0, 1, 2);
  }

  @Test
  void aFastBallFreesTheHeap() {
    World world = threeAtRest();
    world.addCircle(world.x(2), world.y(2) + 3, 1, 0, -1, Traits.DEFAULT);
    assertThat(world.advanceToImpact(20)).isTrue();
    assertThat(world.impacts().kind(0)).isEqualTo(Kind.CIRCLE);
    world.step(0.1); // it wakes at the next tick
    assertThat(resting(world)).doesNotContain(2);
  }

  @Test
  void aRemovedCircleFreesThoseOnIt() {
    World world = threeAtRest();
    world.remove(Kind.CIRCLE, 0);
    assertThat(resting(world)).as("who touched it").doesNotContain(2);
    rows(world, 20);
    assertThat(world.y(2)).isBetween(1.0, 1 + 0x1p-7);
  }

  @Test
  void aMovedCircleFreesThoseOnIt() {
    World world = threeAtRest();
    world.setPosition(0, 3, 50);
    assertThat(resting(world)).as("who touched it").doesNotContain(0, 2);
  }

  /** Balls pass through a sensor. */
  @Test
  void aCircleThatBecomesASensorFreesThoseOnIt() {
    World world = threeAtRest();
    world.setTraits(Kind.CIRCLE, 0, world.traits(Kind.CIRCLE, 0).withResponse(Response.SENSOR));
    assertThat(resting(world)).as("who touched it").doesNotContain(2);
    rows(world, 20);
    assertThat(world.y(2)).isBetween(1.0, 1 + 0x1p-7);
  }

  /** Also the circle itself falls, whose supports may move aside under another weight. */
  @Test
  void anotherMassFreesTheHeap() {
    World world = threeAtRest();
    world.setTraits(Kind.CIRCLE, 2, world.traits(Kind.CIRCLE, 2).withMass(1000));
    assertThat(resting(world)).isEmpty();
    rows(world, 20);
    assertThat(resting(world)).containsExactly(0, 1, 2);
  }

  @Test
  void anInfinitelyHeavyCircleThatALinePushesFreesThoseOnIt() {
    SceneBuilder builder = open().circle(0, 0, 2, 0, 0).mass(INFINITE).restitution(0.5);
    builder.circle(0, 3.5, 1, 0, 0).restitution(0.5);
    World world = new World(builder.line(40, 0, 42, 0).velocity(-1, 0).build());
    rows(world, 37);
    assertThat(world.isResting(1)).isTrue();
    rows(world, 50);
    assertThat(world.y(1)).isLessThan(-100);
  }

  @Test
  void aMovedLineFreesTheHeapOnIt() {
    SceneBuilder builder = open().bounds(0, 0, 4, 100).line(-1, 10, 5, 10);
    builder.circle(1, 11, 1, 0, 0).restitution(0).circle(3, 11, 1, 0, 0).restitution(0);
    World world = new World(builder.circle(2, 13, 1, 0, 0).restitution(0).build());
    rows(world, 10);
    assertThat(resting(world)).containsExactly(0, 1, 2);
    world.setShape(Kind.LINE, 0, new Line(-1, 9, 5, 9));
    assertThat(resting(world)).isEmpty();
    rows(world, 20);
    assertThat(world.y(0)).isBetween(10.0, 10 + 0x1p-7);
    assertThat(resting(world)).containsExactly(0, 1, 2);
  }

  @Test
  void anotherGravityFreesTheHeap() {
    World world = threeAtRest();
    world.setGravity(0, 1);
    rows(world, 20);
    assertThat(world.y(2)).isGreaterThan(10);
  }

  /** Also the count of calm contacts is saved, and played again. */
  @Test
  void savedHeapsGoOnAlike() {
    World world = three(4.2, 0.5);
    Timeline timeline = world.record(100_000);
    for (int i = 1; i <= 100; i++) {
      world.advanceTo(i / 10.0);
    }
    for (double t : new double[] {0.7, 1.1, 1.3, 1.5, 2}) {
      World again = new World(world.scene());
      again.restore(timeline.snapshot(t));
      again.advanceTo(10);
      assertThat(again.snapshot()).as("from %s", t).isEqualTo(world.snapshot());
    }
  }
}
