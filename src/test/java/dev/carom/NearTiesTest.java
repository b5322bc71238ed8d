// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Circles that meet at one time, or some ulps apart, and steps that end there: what happens is what
 * the plain way gives, which asks everyone before each event.
 */
class NearTiesTest {

  private static final int LATE_WORLDS = 300;

  private static final int SEEDS = 250;
  private static final int[][] DIRECTIONS = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

  /** Circles that come from four sides into the middle, and lines that some of them meet before. */
  private static final class Cross {

    final Random random;
    final double way;
    final double speed;
    final SceneBuilder builder = Scene.builder();
    private final boolean sensors;

    Cross(long seed) {
      random = new Random(seed);
      sensors = random.nextInt(3) == 0;
      way = 3 + random.nextInt(8) + some();
      speed = 1 + random.nextInt(3) + some();
      if (random.nextBoolean()) {
        builder.bounds(-20, -20, 20, 20);
      }
      if (random.nextBoolean()) {
        builder.circle(0, 0, 1, 0, 0);
        sense();
      }
      for (int[] d : DIRECTIONS) {
        add(d[0], d[1]);
      }
    }

    private double some() {
      return random.nextBoolean() ? random.nextDouble() : 0;
    }

    private void sense() {
      if (sensors && random.nextInt(3) == 0) {
        builder.response(Response.SENSOR);
      }
    }

    private void add(int x, int y) {
      if (random.nextInt(5) > 0) {
        double far = near(way);
        double fast = near(speed);
        builder.circle(x * far, y * far, 1, -x * fast, -y * fast);
        sense();
      }
      if (random.nextInt(4) == 0) {
        double at = way - 1 - speed * random.nextInt(3);
        builder.line(x * at + y * 3, y * at + x * 3, x * at - y * 3, y * at - x * 3);
        sense();
      }
    }

    /** The same, or up to two ulps off. */
    private double near(double value) {
      double near = value;
      for (int k = random.nextInt(3); k > 0; k--) {
        near = random.nextBoolean() ? Math.nextUp(near) : Math.nextDown(near);
      }
      return near;
    }

    /** Ends of steps at moments when much happens, and an ulp before and after these. */
    double[] times() {
      double meeting = (way - 2) / speed;
      double[] times = new double[8];
      for (int k = 0; k < times.length; k++) {
        double t = meeting * (1 + k / 2);
        times[k] = k % 2 == 0 ? Math.nextDown(t) : t;
      }
      return times;
    }
  }

  @Test
  void thePlainWayGivesTheSameImpacts() {
    int impacts = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      Cross cross = new Cross(seed);
      Scene scene = cross.builder.build();
      BesidePlain both = new BesidePlain(scene);
      for (double time : cross.times()) {
        impacts += both.advanceTo(time);
      }
    }
    assertThat(impacts).isGreaterThan(4 * SEEDS);
  }

  private static double draw(Random random, boolean whole, int least, int range) {
    return least + (whole ? random.nextInt(range) : range * random.nextDouble());
  }

  /**
   * More circles, and lines, as late. Of some thousand drawn, these two tell whether what comes
   * first of a meeting and a line is asked again once the meeting's time is known, and whether a
   * meeting that does not hold any more is let go.
   */
  @ParameterizedTest
  @ValueSource(ints = {366, 459})
  void soDoManyThatAreLate(int seed) {
    Random random = new Random(seed);
    boolean whole = random.nextBoolean();
    SceneBuilder builder = Scene.builder();
    if (random.nextInt(4) > 0) {
      builder.bounds(0, 0, 40, 40);
    }
    int circles = 2 + random.nextInt(8);
    for (int i = 0; i < random.nextInt(3); i++) {
      double ax = draw(random, whole, 0, 40);
      double ay = draw(random, whole, 0, 40);
      builder.line(ax, ay, draw(random, whole, 0, 40), draw(random, whole, 0, 40));
    }
    for (int i = 0; i < circles; i++) {
      double x = draw(random, whole, 2, 36);
      double y = draw(random, whole, 2, 36);
      builder.circle(x, y, random.nextInt(3) == 0 ? 2 : 1, 0, 0);
    }
    Scene scene = builder.build();
    double end = Math.scalb(1.0, 30 + random.nextInt(20));
    double speed = Math.scalb(1.0, random.nextInt(36));
    BesidePlain both = BesidePlain.at(end, scene);
    for (int i = 0; i < circles; i++) {
      double vx = speed * (whole ? random.nextInt(9) - 4 : random.nextGaussian());
      double vy = speed * (whole ? random.nextInt(9) - 4 : random.nextGaussian());
      double slower = random.nextInt(4) == 0 ? 0 : 1;
      slower *= random.nextInt(5) == 0 ? 0x1p-20 : 1;
      both.setVelocity(i, slower * vx, slower * vy);
    }
    for (int k = 0; k < 4; k++) {
      end = random.nextBoolean() ? Math.nextUp(end) : end + 20 / speed;
      both.advanceTo(end);
    }
  }

  /**
   * Two circles so late that a double tells no times apart in which one crosses the box: what comes
   * first shows only in the tails of the times.
   */
  @Test
  void soDoesAllThatHappensWithinAnUlpOfTime() {
    int impacts = 0;
    for (int seed = 0; seed < SEEDS; seed++) {
      Random random = new Random(seed);
      SceneBuilder builder = Scene.builder();
      if (random.nextInt(4) > 0) {
        builder.bounds(0, 0, 40, 40);
      }
      for (int i = 0; i < 2; i++) {
        builder.circle(2 + random.nextInt(36), 2 + random.nextInt(36), 1 + i, 0, 0);
      }
      Scene scene = builder.build();
      double end = Math.scalb(1.0, 30 + random.nextInt(20));
      BesidePlain both = BesidePlain.at(end, scene);
      double speed = Math.scalb(1.0, 15 + random.nextInt(15));
      for (int i = 0; i < 2; i++) {
        double vx = speed * (random.nextInt(9) - 4);
        double vy = speed * (random.nextInt(9) - 4);
        both.setVelocity(i, vx, vy);
      }
      for (int k = 0; k < 3 && impacts < 40 * (seed + 1); k++) {
        end = Math.nextUp(end);
        impacts += both.advanceTo(end);
      }
    }
    assertThat(impacts).isGreaterThan(SEEDS);
  }

  /** Small worlds in bounds or none, some with lines, so late as above: with up to nine circles. */
  @Test
  void soDoManyCirclesThatCrossCellsWithinAnUlpOfTime() {
    int impacts = 0;
    for (int seed = 0; seed < LATE_WORLDS; seed++) {
      Random random = new Random(seed);
      Scene scene = small(random);
      double start = Math.scalb(1.0, 30 + random.nextInt(20));
      BesidePlain both = BesidePlain.at(start, scene);
      double speed = Math.scalb(1 / Math.ulp(start), random.nextInt(6) - 1);
      for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
        double vx = speed * (random.nextInt(9) - 4);
        double vy = speed * (random.nextInt(9) - 4);
        both.setVelocity(i, vx, vy);
      }
      for (double end : List.of(Math.nextUp(start), Math.nextUp(Math.nextUp(start)))) {
        impacts += both.advanceTo(end);
      }
    }
    assertThat(impacts).isGreaterThan(3 * LATE_WORLDS);
  }

  private static Scene small(Random random) {
    SceneBuilder builder = Scene.builder();
    if (random.nextInt(4) > 0) {
      builder.bounds(0, 0, 40, 40);
    }
    for (int k = random.nextInt(3); k > 0; k--) {
      builder.line(random.nextInt(40), random.nextInt(40), random.nextInt(40), random.nextInt(40));
    }
    for (int k = 2 + random.nextInt(8); k > 0; k--) {
      int radius = random.nextInt(3) == 0 ? 2 : 1;
      builder.circle(2 + random.nextInt(36), 2 + random.nextInt(36), radius, 0, 0);
    }
    return builder.build();
  }
}
