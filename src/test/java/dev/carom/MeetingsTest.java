// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Who hardly meets, or hardly first: a world, which passes over most pairs by bounds of rounding,
 * tells what the detector tells of each pair.
 */
class MeetingsTest {

  private static final int GRAZES = 600;

  private final Random random = new Random(5);

  /** x, y, r, vx, vy of each of some circles that start now. */
  private static ImpactLog step(double dt, double[]... circles) {
    SceneBuilder scene = Scene.builder().collide(true);
    for (double[] c : circles) {
      scene.circle(c[0], c[1], c[2], c[3], c[4]);
    }
    World world = new World(scene.build());
    world.step(dt);
    return world.impacts();
  }

  private static double meeting(double[] a, double[] b) {
    return SweptCircle.pair(
        a[0], a[1], a[2], a[3], a[4], b[0], b[1], b[2], b[3], b[4], Double.POSITIVE_INFINITY);
  }

  private static void assertTold(double dt, double[] a, double[] b) {
    assertThat(step(dt, a, b).size() > 0)
        .as(() -> Arrays.toString(a) + Arrays.toString(b))
        .isEqualTo(meeting(a, b) <= dt);
  }

  /** Overlapping, and moving across the line between them as far as doubles can: now, or never. */
  @Test
  void whoApproachesIsToldFromWhoDoesNot() {
    int hits = 0;
    for (int i = 0; i < 3_000; i++) {
      double x = 0.5 + random.nextDouble();
      double y = 0.5 + random.nextDouble();
      double vx = random.nextDouble();
      double[] b = {random.nextDouble(), random.nextDouble(), 9, 0, 0};
      double[] a = {b[0] + x, b[1] + y, 9, vx, -(vx * x) / y};
      assertTold(0, a, b);
      hits += meeting(a, b) == 0 ? 1 : 0;
    }
    assertThat(hits).isBetween(500, 2_500);
  }

  /** From near and far, and level as often as not: they touch by next to nothing, or do not. */
  @Test
  void whoGrazesIsToldFromWhoPasses() {
    int hits = 0;
    for (int i = 0; i < GRAZES; i++) {
      double angle = random.nextInt(3) == 0 ? 0 : 9 * random.nextDouble();
      double far = Math.scalb(2 + random.nextDouble(), random.nextInt(20));
      double off = Math.scalb(random.nextDouble() - 0.5, -20 - random.nextInt(33));
      double[] a = grazing(angle, far, off);
      double[] b = {0, 0, 1, 0, 0};
      assertTold(9, a, b);
      hits += meeting(a, b) <= 9 ? 1 : 0;
    }
    assertThat(hits).isBetween(GRAZES / 5, 4 * GRAZES / 5);
  }

  /** A circle that passes a unit circle at the origin, nearer or further than a graze. */
  private double[] grazing(double angle, double far, double off) {
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    double speed = far * (0.5 + random.nextDouble());
    double r = 0.5 + random.nextDouble();
    double beside = (r + 1) * (random.nextInt(3) == 0 ? 1 : 1 + off);
    return new double[] {
      beside * sin - far * cos, -far * sin - beside * cos, r, speed * cos, speed * sin
    };
  }

  /**
   * Circle 0 is to meet two others at one time. A fourth one takes one of them away, as often as
   * not before circle 0 has come so near that it finds the other one.
   */
  @Test
  void aMeetingThatFellThroughHidesNoneAtTheSameTime() {
    int impacts = 0;
    for (int seed = 0; seed < 400; seed++) {
      Scene scene = meetingTwo();
      World world = new World(scene);
      world.step(20);
      List<Run.Row> rows = Run.rows(world.impacts());
      assertThat(rows)
          .as("scene %s", seed)
          .isEqualTo(Run.rows(new PlainWorld(scene).advance(20, rows.size() + 1)));
      impacts += rows.size();
    }
    assertThat(impacts).isGreaterThan(800);
  }

  private Scene meetingTwo() {
    double time = 4 + 6 * random.nextDouble();
    double[] a = {0, 0, 1, 1 + random.nextDouble(), 1 + random.nextDouble()};
    double[] b = met(a, time, 0, 0);
    double[] c = met(a, time, 4 * random.nextDouble() - 2, 4 * random.nextDouble() - 2);
    double vx = c[3] + 4 * random.nextGaussian();
    double vy = c[4] + 4 * random.nextGaussian();
    double[] d = met(c, time * random.nextDouble(), vx, vy);
    SceneBuilder scene = Scene.builder().collide(true);
    for (double[] n : List.of(a, b, c, d)) {
      scene.circle(n[0], n[1], n[2], n[3], n[4]);
    }
    return scene.build();
  }

  /** A unit circle that touches another one, where that moves to, at a time. */
  private double[] met(double[] other, double time, double vx, double vy) {
    double angle = 2 * Math.PI * random.nextDouble();
    return new double[] {
      other[0] + (other[3] - vx) * time + 2 * Math.cos(angle),
      other[1] + (other[4] - vy) * time + 2 * Math.sin(angle),
      1,
      vx,
      vy
    };
  }
}
