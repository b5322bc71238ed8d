// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static dev.carom.Falling.overlap;
import static dev.carom.Falling.rows;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Everyday scenes: no call is unfinished, nothing falls through, and what can rest does. */
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

  /** Plays frame by frame; returns how many calls were unfinished. */
  private static int unfinishedCalls(World world, double until) {
    int unfinished = 0;
    while (world.now() < until) {
      unfinished += world.advanceTo(world.now() + FRAME, Run.WORK) ? 0 : 1;
      assertThat(overlap(world)).as("at %s", world.now()).isLessThan(ROUNDING);
    }
    return unfinished;
  }
}
