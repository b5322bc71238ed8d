// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.energy;
import static dev.carom.Falling.overlap;
import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Everyday scenes: no call is unfinished, nothing falls through, and what can rest does. */
@Tag("long")
class EverydayGravityTest {

  private static final double FRAME = 1 / 60.0;

  /** Coordinates here are below 128: some ulps of that. */
  private static final double ROUNDING = 1e-13;

  private static SceneBuilder open() {
    return Scene.builder().gravity(0, -10);
  }

  private static SceneBuilder restingPlace(String name) {
    return switch (name) {
      case "two pegs" -> open().bounds(-4, -9, 7, 50).peg(0, 0, 1).peg(3, 0, 1);
      case "peg and wall" -> open().bounds(0, -9, 50, 100).peg(2, 0, 1);
      case "wedge" -> open().line(-50, 50, 0, 0).line(0, 0, 60, 40);
      case "end of a line" -> open().bounds(-4, -9, 14, 50).line(0, 0, 10, 0);
      case "joint" -> open().bounds(-1, -9, 21, 50).line(0, 5, 10, 0).line(10, 0, 20, 5);
      default -> throw new IllegalArgumentException(name);
    };
  }

  /** The lower half of a regular polygon of 40 sides. */
  private static SceneBuilder bowl() {
    SceneBuilder builder = open();
    for (int i = 20; i < 40; i++) {
      double a = Math.PI * i / 20;
      double b = Math.PI * (i + 1) / 20;
      builder.line(20 * Math.cos(a), 20 * Math.sin(a), 20 * Math.cos(b), 20 * Math.sin(b));
    }
    return builder;
  }

  private static Stream<Arguments> placesOfABall() {
    return Stream.of(
            "two pegs, 1.4", "peg and wall, 1.3", "wedge, -10", "end of a line, 0", "joint, 10.3")
        .map(place -> place.split(", "))
        .flatMap(
            place ->
                DoubleStream.of(0, 0.5, 0.9)
                    .mapToObj(e -> Arguments.of(place[0], Double.parseDouble(place[1]), e)));
  }

  /** At the end it rests, or it bounced out of the place and rolls on the floor for ever. */
  @ParameterizedTest
  @MethodSource("placesOfABall")
  void ballsInPlaces(String place, double x, double e) {
    double y = place.equals("wedge") ? 30 : 8;
    World world = new World(restingPlace(place).circle(x, y, 1, 0, 0).restitution(e).build());
    assertThat(unfinishedCalls(world, 150)).isZero();
    boolean bouncesOut =
        place.equals("two pegs") ? e == 0.9 : place.equals("peg and wall") && e > 0;
    assertThat(world.y(0) == -8).isEqualTo(bouncesOut);
    if (!bouncesOut) {
      assertThat(world.isResting(0)).isTrue();
      assertThat(rows(world, 1e5)).isZero();
    }
  }

  /** Only the joints of its sides slow it down, the slower it is the less often. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aBowl(double e) {
    World world = new World(bowl().circle(-11, 3, 1, 0, 0).restitution(e).build());
    assertThat(unfinishedCalls(world, 600)).isZero();
    rows(world, 2_000); // at 0.9 so many rows at the end that a call may be unfinished
    assertThat(world.isResting(0)).isTrue();
    assertThat(overlap(world)).isLessThan(ROUNDING);
    assertThat(rows(world, 1e5)).isZero();
  }

  @Test
  void withoutBounceAGapOfPegsEndsAHundredRowsAtMost() {
    World world =
        new World(restingPlace("two pegs").circle(1.4, 8, 1, 0, 0).restitution(0).build());
    assertThat(rows(world, 60)).isLessThanOrEqualTo(100);
    assertThat(world.isResting(0)).isTrue();
    assertThat(world.y(0)).isCloseTo(Math.sqrt(4 - 1.5 * 1.5), within(2 * 0x1p-9));
  }

  /** Fifty balls; those that come to no rest between a peg and a wall fall out below. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void plinko(double e) {
    SceneBuilder builder = open().collide(true).line(0, -2, 0, 99).line(40, -2, 40, 99);
    for (int row = 0; row < 14; row++) {
      for (int i = 0; i < 14 + row % 2; i++) {
        builder.peg((i + (row % 2 == 0 ? 1 : 0.5)) * 40 / 15, 4 + row * 2.6, 0.3);
      }
    }
    Random random = new Random(1);
    for (int i = 0; i < 50; i++) {
      double x = 2 + 4 * (i % 10) + 0.4 * random.nextDouble();
      int row = i / 10;
      builder.circle(x, 45 + 2.5 * row, 0.5, 0, 0).restitution(e);
    }
    World world = new World(builder.build());
    int rows = 0;
    int frames = 0;
    while (!isOver(world) && frames < 4_000) {
      assertThat(world.step(FRAME)).as("at %s", world.now()).isTrue();
      assertThat(overlap(world)).isLessThan(ROUNDING);
      rows += world.impacts().size();
      frames++;
    }
    assertThat(isOver(world)).isTrue();
    assertThat(rows).isLessThan(50 * frames / 2);
  }

  private static boolean isOver(World world) {
    for (int i = 0; i < world.circleCount(); i++) {
      if (world.y(i) > -3 && !world.isResting(i)) {
        return false;
      }
    }
    return true;
  }

  private static double[] heights(World world) {
    double[] heights = new double[world.circleCount()];
    for (int i = 0; i < heights.length; i++) {
      heights[i] = world.y(i);
    }
    return heights;
  }

  /** Each ball lies as high above the floor as the hops below it could lift. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aColumnOfTenStands(double e) {
    SceneBuilder builder = open().bounds(0, 0, 40, 100).collide(true);
    for (int i = 0; i < 10; i++) {
      builder.circle(20, 2 + 3 * i, 1, 0, 0).restitution(e);
    }
    World world = new World(builder.build());
    assertThat(unfinishedCalls(world, 20)).isZero();
    for (int i = 0; i < 10; i++) {
      assertThat(world.y(i)).isBetween(2 * i + 1 - ROUNDING, 2 * i + 1 + 0.02);
    }
    assertThat(resting(world)).isEqualTo(10);
    assertThat(rows(world, 1e5)).isZero();
  }

  private static Scene heap(SceneBuilder builder, double e, double left, double bottom) {
    Random random = new Random(1);
    builder.collide(true);
    for (int i = 0; i < 30; i++) {
      double x = left + 2.4 * (i % 5) + 0.3 * random.nextDouble();
      builder.circle(x, bottom + 3 * (i / 5), 1, 0, 0).restitution(e);
    }
    return builder.build();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aHeapOfThirtyInABoxRests(double e) {
    World world = new World(heap(open().bounds(0, 0, 12.7, 100), e, 1.2, 2));
    assertThat(unfinishedCalls(world, 10)).isZero();
    assertThat(DoubleStream.of(heights(world)).max().orElseThrow()).isLessThan(12);
    assertThat(resting(world)).isEqualTo(30);
    assertThat(rows(world, 1e5)).isZero();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void aHeapOfThirtyInAVRests(double e) {
    Scene scene = heap(open().line(0, 0, -30, 40).line(0, 0, 30, 40), e, -5, 12);
    World world = new World(scene);
    assertThat(unfinishedCalls(world, 15)).isZero();
    assertThat(DoubleStream.of(heights(world)).max().orElseThrow()).isLessThan(16);
    assertThat(resting(world)).isEqualTo(30);
    assertThat(rows(world, 1e5)).isZero();
  }

  /** Plays frame by frame; returns how many calls were unfinished. */
  private static int unfinishedCalls(World world, double until) {
    int unfinished = 0;
    while (world.now() < until) {
      unfinished += world.step(FRAME) ? 0 : 1;
      assertThat(overlap(world)).as("at %s", world.now()).isLessThan(ROUNDING);
    }
    return unfinished;
  }

  @Test
  void framesDoNotMatterToAHeap() {
    Scene scene = heap(open().bounds(0, 0, 12.7, 100), 0.5, 1.2, 2);
    World once = new World(scene);
    assertThat(once.advanceTo(2)).isTrue();
    for (int frames : new int[] {7, 120, 2_000}) {
      World often = new World(scene);
      for (int i = 1; i <= frames; i++) {
        assertThat(often.advanceTo(2.0 * i / frames)).isTrue();
      }
      assertThat(often.snapshot()).as("%d frames", frames).isEqualTo(once.snapshot());
    }
  }

  /** Balls of diameter 16, side by side: also where they have no clearance at all. */
  @ParameterizedTest
  @CsvSource({"801, 0", "801, 0.5", "800.001, 0", "800.001, 0.9", "800, 0", "800, 0.5", "800, 0.9"})
  void aRowWithLittleClearanceRests(double width, double e) {
    SceneBuilder builder = open().bounds(0, 0, width, 600).collide(true);
    Random random = new Random(1);
    for (int i = 0; i < 50; i++) {
      builder.circle(8 + (width - 800) / 100 + width / 50 * i, 8, 8, random.nextGaussian(), 0);
      builder.restitution(e);
    }
    World world = new World(builder.build());
    assertThat(world.advanceTo(20)).isTrue();
    assertThat(world.impacts().size()).isLessThan(1_000);
    assertThat(resting(world)).isEqualTo(50);
    assertThat(overlap(world)).isLessThan(1e-12);
    assertThat(rows(world, 1e5)).isZero();
  }

  /** Fifty balls of diameter 1 under pegs, more than the floor has room for side by side. */
  @ParameterizedTest
  @CsvSource({
    "40, 0",
    "40, 0.5",
    "33, 0.5",
    "45, 0.5",
    "25, 0.5",
    "40.3, 0",
    "40.3, 0.5",
    "25.3, 0",
    "25.3, 0.9"
  })
  void aFloorThatBallsFill(double width, double e) {
    SceneBuilder builder = open().bounds(0, 0, width, 200).collide(true);
    int across = (int) (width / (40.0 / 15)) - 1;
    for (int row = 0; row < 14; row++) {
      for (int i = 0; i < across + row % 2; i++) {
        double x = (i + (row % 2 == 0 ? 1 : 0.5)) * width / (across + 1);
        builder.peg(x, 4 + row * 2.6, 0.3).restitution(e);
      }
    }
    Random random = new Random(1);
    for (int i = 0; i < 50; i++) {
      double x = width / 20 + width / 10 * (i % 10) + 0.4 * random.nextDouble();
      int row = i / 10;
      builder.circle(x, 45 + 2.5 * row, 0.5, 0, 0).restitution(e);
    }
    World world = new World(builder.build());
    assertThat(unfinishedCalls(world, 30)).isZero();
    assertThat(resting(world)).isEqualTo(50);
    assertThat(rows(world, 1e5)).isZero();
  }

  private static int resting(World world) {
    int resting = 0;
    for (int i = 0; i < world.circleCount(); i++) {
      resting += world.isResting(i) ? 1 : 0;
    }
    return resting;
  }

  /** An impact adds at most m g 2^-12 R; for two circles m is the reduced mass, here 1/2. */
  @Test
  void anImpactAddsNoMoreEnergyThanALeastHop() {
    int hops = 0;
    for (int seed = 0; seed < 8; seed++) {
      World world = new World(GravitySymmetryTest.random(seed));
      for (double before = total(world); world.now() < 6; before = total(world)) {
        world.advanceToImpact(6);
        double most = 0;
        for (int row = 0; row < world.impacts().size(); row++) {
          most += 10 * 0x1p-12 * mostHop(world, row);
        }
        double gain = total(world) - before;
        assertThat(gain).as("seed %d at %s", seed, world.now()).isLessThan(most + 1e-10);
        hops += gain > 1e-10 ? 1 : 0;
      }
    }
    assertThat(hops).as("impacts that added energy").isPositive();
  }

  /** The combined radius, times the reduced mass of two circles. */
  private static double mostHop(World world, int row) {
    ImpactLog log = world.impacts();
    double r = world.scene().circle(log.circle(row)).radius();
    return switch (log.kind(row)) {
      case CIRCLE -> (r + world.scene().circle(log.id(row)).radius()) / 2;
      case PEG -> r + world.scene().peg(log.id(row)).radius();
      default -> r;
    };
  }

  private static double total(World world) {
    double sum = 0;
    for (int i = 0; i < world.circleCount(); i++) {
      sum += energy(world, i);
    }
    return sum;
  }
}
