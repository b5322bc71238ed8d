// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.BesidePlain;
import dev.carom.Impact;
import dev.carom.ImpactLog;
import dev.carom.PlainWorld;
import dev.carom.Run;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.World;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * A world passes over most pairs by bounds of rounding. Where pairs hardly meet, or hardly first,
 * it answers as the detector does.
 */
class CollisionPredictorTest {

  private static final int WORLDS = 300;

  private final Random random = new Random(5);

  /** x, y, r, vx, vy of each of some circles that start now. */
  private static ImpactLog step(double dt, double[]... circles) {
    SceneBuilder scene = Scene.builder();
    for (double[] c : circles) {
      scene.circle(c[0], c[1], c[2], c[3], c[4]);
    }
    World world = new World(scene.build());
    world.advanceTo(dt);
    return world.impacts();
  }

  private static double meeting(double[] a, double[] b) {
    return new SweptCircle(a[0], a[1], a[2], a[3], a[4])
        .timeToCircle(new SweptCircle(b[0], b[1], b[2], b[3], b[4]), Double.POSITIVE_INFINITY);
  }

  private static String text(double[]... circles) {
    return Arrays.deepToString(circles);
  }

  private static void assertTold(double dt, double[] a, double[] b) {
    assertThat(step(dt, a, b).size() > 0).as(text(a, b)).isEqualTo(meeting(a, b) <= dt);
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

  /** From near and far, some along an axis: they touch by next to nothing, or do not. */
  @Test
  void whoGrazesIsToldFromWhoPasses() {
    int hits = 0;
    for (int i = 0; i < WORLDS; i++) {
      boolean level = random.nextInt(3) == 0;
      double angle = level ? 0 : 9 * random.nextDouble();
      int size = random.nextInt(1 + random.nextInt(40));
      double far = Math.scalb(2 + random.nextDouble(), level ? size / 2 : 39 - size);
      double off = Math.scalb(random.nextDouble() - 0.5, -20 - random.nextInt(33));
      double[] a = grazing(angle, far, off);
      double[] b = {0, 0, 1, 0, 0};
      assertTold(9, a, b);
      hits += meeting(a, b) <= 9 ? 1 : 0;
    }
    assertThat(hits).isBetween(WORLDS / 5, 4 * WORLDS / 5);
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
   * Circle 0 is to meet one that flies before it and one at rest at the same time. A fourth one
   * takes the first one away before circle 0 has come so near that it finds the second one, and one
   * more at rest before that. What is met is met in the step that it belongs to.
   */
  @Test
  void aMeetingThatFellThroughHidesNoneAtTheSameTimeOrBefore() {
    int impacts = 0;
    for (int i = 0; i < 2 * WORLDS; i++) {
      Scene scene = meetingThree();
      List<Impact> plain = Run.rows(new PlainWorld(scene).advance(20, 50));
      World world = new World(scene);
      List<Impact> rows = new ArrayList<>();
      for (Impact row : plain) {
        world.advanceTo(row.time());
        rows.addAll(Run.rows(world.impacts()));
        assertThat(rows).as("world %s", i).contains(row);
      }
      world.advanceTo(20);
      rows.addAll(Run.rows(world.impacts()));
      assertThat(rows).as("world %s", i).isEqualTo(plain);
      impacts += rows.size();
    }
    assertThat(impacts).isGreaterThan(4 * WORLDS);
  }

  private Scene meetingThree() {
    double time = 4 + 6 * random.nextDouble();
    double[] a = {0, 0, 1, 1 + random.nextDouble(), 1 + random.nextDouble()};
    double slower = 0.7 + 0.3 * random.nextDouble();
    double[] b = met(a, time, slower * a[3], slower * a[4]);
    double vx = b[3] + 4 * random.nextGaussian();
    double vy = b[4] + 4 * random.nextGaussian();
    double[] c = met(b, time * random.nextDouble(), vx, vy);
    double[] d = met(a, time, 0, 0);
    double before = time * random.nextDouble() / 16;
    double[] e = {d[0] - a[3] * before, d[1] - a[4] * before, 1, 0, 0};
    SceneBuilder scene = Scene.builder();
    for (double[] n : List.of(a, b, c, e, d)) {
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

  /**
   * Two are met at nearly the same time: at once, or after long; one or both are hardly touched.
   */
  @Test
  void whoIsMetFirstIsToldFromWhoWouldBeNext() {
    int first = 0;
    for (int i = 0; i < WORLDS; i++) {
      double r = 0.5 + random.nextDouble();
      double[] a = {0, 0, r, 1 + random.nextDouble(), random.nextDouble() - 0.5};
      double time = Math.scalb(1 + random.nextDouble(), 10 - random.nextInt(60));
      double off = Math.scalb(random.nextDouble() - 0.5, -10 - random.nextInt(43));
      double[] b = touched(a, time, 1);
      double[] c = touched(a, time * (1 + off), -1);
      double withB = meeting(a, b);
      double withC = meeting(a, c);
      double dt = Math.min(withB, withC);
      if (dt < Double.POSITIVE_INFINITY) {
        ImpactLog log = step(dt, a, b, c);
        assertThat(log.id(0)).as(text(a, b, c)).isEqualTo(withB <= withC ? 1 : 2);
        assertThat(log.time(0)).isEqualTo(dt);
        first += withB <= withC ? 1 : 0;
      }
    }
    assertThat(first).isBetween(WORLDS / 5, 4 * WORLDS / 5);
  }

  /** A circle at rest that another one touches at about a time, to its left or right. */
  private double[] touched(double[] a, double time, int side) {
    double r = 0.5 + random.nextDouble();
    double slope = Math.scalb(random.nextDouble(), random.nextBoolean() ? 0 : -random.nextInt(26));
    double angle = side * (Math.PI / 2 - slope);
    double scale = (a[2] + r) / Math.hypot(a[3], a[4]);
    double along = time + scale * Math.cos(angle);
    double across = scale * Math.sin(angle);
    return new double[] {a[3] * along - a[4] * across, a[4] * along + a[3] * across, r, 0, 0};
  }

  /** Units so small, or so large ones and so slow, that products underflow. */
  @Test
  void whoGrazesIsToldFromWhoPassesWhereNumbersUnderflow() {
    int hits = 0;
    for (int i = 0; i < WORLDS; i++) {
      double off = Math.scalb(random.nextDouble() - 0.5, -4 - random.nextInt(33));
      double[] a = grazing(9 * random.nextDouble(), 2 + random.nextDouble(), off);
      boolean small = random.nextBoolean();
      int length = small ? -500 - random.nextInt(30) : random.nextInt(500) - 250;
      int time = small ? 0 : 500 + length + random.nextInt(40);
      double unit = Math.scalb(1.0, length);
      double speed = Math.scalb(1.0, length - time);
      double[] slow = {a[0] * unit, a[1] * unit, a[2] * unit, a[3] * speed, a[4] * speed};
      double[] b = {0, 0, unit, 0, 0};
      double dt = Math.scalb(9.0, time);
      assertTold(dt, slow, b);
      hits += meeting(slow, b) <= dt ? 1 : 0;
    }
    assertThat(hits).isBetween(WORLDS / 5, 4 * WORLDS / 5);
  }

  /** So late, of two that are met within some ulps of time the one found last may be the first. */
  @Test
  void whoIsFoundLaterMayBeMetFirst() {
    int impacts = 0;
    for (int i = 0; i < WORLDS; i++) {
      double start = Math.scalb(1.0, 30 + random.nextInt(20));
      double unit = Math.scalb(Math.ulp(start), random.nextInt(12));
      double[] a = {0, 0, 1, 1 + random.nextDouble(), 1 + random.nextDouble()};
      double time = 4 + 6 * random.nextDouble();
      SceneBuilder scene = Scene.builder().circle(0, 0, 1, 0, 0);
      for (int k = 0; k < 2; k++) {
        double[] b = met(a, time + k * (random.nextInt(9) - 4) * Math.ulp(start) / unit, 0, 0);
        scene.circle(b[0], b[1], 1, 0, 0);
      }
      BesidePlain both = BesidePlain.at(start, scene.build());
      both.setVelocity(0, a[3] / unit, a[4] / unit);
      impacts += both.advanceTo(start + 20 * unit);
    }
    assertThat(impacts).isGreaterThan(WORLDS);
  }
}
