// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Random tracks of 2 to 70 lines, with shared and unshared ends, one-way, moving: no ball stops
 * where nothing holds it, none falls through, and no joint of collinear lines is felt. With {@code
 * -Dcarom.contacts=N} N thousand more are played.
 */
class ContactTracksTest {

  private static void assertTracks(int from, int to) {
    List<String> wrong = new ArrayList<>();
    for (int seed = from; seed < to; seed++) {
      PlainTrack track = new PlainTrack(seed);
      ContactRun run = new ContactRun(new World(track.scene()));
      (track.moves ? run.withMovers() : run.fromAbove()).play(600);
      String faults = run.faults();
      List<String> stopped = PlainTrack.restWithoutSupport(run.world);
      if (!faults.isEmpty() || !stopped.isEmpty() || !run.jammed.isEmpty()) {
        wrong.add("track " + seed + ": " + faults + stopped + " jammed " + run.jammed);
      }
    }
    assertThat(wrong).isEmpty();
  }

  /** In parts, so that a failure is found soon. */
  @ParameterizedTest
  @ValueSource(ints = {0, 50, 100, 150})
  void ballsOnTracks(int from) {
    assertTracks(from, from + 50);
  }

  @Test
  @Tag("long")
  void ballsOnManyTracks() {
    assertTracks(200, 400 + 1_000 * ContactRun.SEEDS);
  }

  /**
   * A straight track in exact pieces: at all times the ball is where it is on one long line, to
   * rounding.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5, 0.9})
  void jointsOfCollinearLinesAreNotFelt(double e) {
    for (int seed = 0; seed < 40; seed++) {
      Random random = new Random(seed);
      int pieces = 2 + random.nextInt(40);
      double dx = 1 + random.nextInt(12);
      double dy = random.nextInt(3) == 0 ? 0 : -1 - random.nextInt(9);
      double[] start = {20 * dx + random.nextDouble(), 25 + random.nextDouble(), 3, 0};
      SceneBuilder one = Scene.builder().gravity(0, -PlainTrack.G);
      one.line(0, 0, 40 * pieces * dx, 40 * pieces * dy);
      SceneBuilder many = Scene.builder().gravity(0, -PlainTrack.G);
      for (int k = 0; k < pieces; k++) {
        many.line(40 * k * dx, 40 * k * dy, 40 * (k + 1) * dx, 40 * (k + 1) * dy);
      }
      World right = world(one, start, e);
      World world = world(many, start, e);
      for (int t = 20; t <= 400; t += 20) {
        right.advanceTo(t);
        world.advanceTo(t);
        if (right.x(0) < 40 * pieces * dx - 40) {
          assertThat(world.x(0)).as("seed %s at %s", seed, t).isCloseTo(right.x(0), within(1e-8));
          assertThat(world.y(0)).as("seed %s at %s", seed, t).isCloseTo(right.y(0), within(1e-8));
        }
      }
    }
  }

  private static World world(SceneBuilder scene, double[] start, double e) {
    return new World(
        scene.circle(start[0], start[1], 10, start[2], start[3]).restitution(e).build());
  }

  /** Down one slope and up the next: a ball that has lost nothing rolls back and forth for ever. */
  @Test
  void aBallStopsNowhereOnASlope() {
    for (double slope : new double[] {0x1p-10, 0.01, 0.1, 1, 10}) {
      SceneBuilder scene = Scene.builder().gravity(0, -PlainTrack.G);
      scene.line(0, 0, -1000, 1000 * slope).line(0, 0, 2000, -2000 * slope);
      double s = Math.hypot(1, slope);
      double at = -5;
      double x = at + 10 * slope / s;
      double y = -at * slope + 10 / s + 1e-9;
      World world = new World(scene.circle(x, y, 10, 0, 0).restitution(0).build());
      world.advanceTo(100);
      double a = PlainTrack.G * slope / s;
      double way = a * 100 * 100 / 2 / s;
      assertThat(world.isResting(0)).isFalse();
      assertThat(world.x(0)).as("slope %s", slope).isCloseTo(x + way, within(1e-6 * (1 + way)));
    }
  }
}
