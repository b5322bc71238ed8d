// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Heaps at the edges of the law: heavy on light, large on small, rows without clearance, arches.
 */
class ContactExtremesTest {

  private static SceneBuilder falling() {
    return Scene.builder().gravity(0, -0.05);
  }

  private static ContactRun play(SceneBuilder scene, double frames) {
    ContactRun run = new ContactRun(new World(scene.build())).play(frames);
    assertThat(run.faults()).isEmpty();
    assertThat(run.jammed).isEmpty();
    return run;
  }

  /** Each third ball is heavy. */
  @ParameterizedTest
  @CsvSource({
    "5, 100, 0",
    "5, 1e4, 0.5",
    "5, 1e6, 0",
    "5, 1e6, 0.5",
    "5, 1e9, 0.5",
    "5, 1e12, 0",
    "5, 1e12, 0.5",
    "1114, 120, 0.9",
    "1219, 150, 0.9",
    "268, 1e5, 0.7",
    "519, 1e8, 0.9",
    "974, 1e7, 0.9",
    "3217, 1e6, 0.5"
  })
  void heavyBallsAmongLightOnes(long seed, double mass, double e) {
    SceneBuilder scene = falling().bounds(0, 0, 167, 400).restitution(e > 0 ? Math.sqrt(e) : 1);
    Random random = new Random(seed);
    for (int i = 0; i < 30; i++) {
      double x = 20 + 24 * (i % 6) + random.nextDouble();
      scene.circle(x, 20 + 30 * (i / 6) + random.nextDouble(), 10, 0, 0).restitution(Math.sqrt(e));
      scene.mass(i % 3 == 0 ? mass : 1);
    }
    play(scene, 600);
  }

  /** The balls are spread over a higher and narrower place than they will be. */
  @ParameterizedTest
  @CsvSource({"3, 60, 0", "4, 60, 0.5", "4, 30.67, 0.7", "8, 60, 0.9"})
  void ballsInASteepWedge(int balls, double slope, double e) {
    for (int seed = 0; seed < 10; seed++) {
      SceneBuilder scene = falling().line(0, 0, 400, 400 * slope).line(0, 0, -400, 400 * slope);
      Random random = new Random(seed);
      double bottom = 40 + 10 * slope + 12 * Math.sqrt(1 + slope * slope);
      for (int i = 0; i < balls; i++) {
        scene.circle(2 * random.nextDouble() - 1, bottom + 22 * i, 10, 0, 0);
        scene.restitution(Math.sqrt(e));
      }
      play(scene, 300);
    }
  }

  /** Large balls and small ones, of equal density. */
  @ParameterizedTest
  @CsvSource({"3, 0", "10, 0.5", "100, 0", "100, 0.5", "1000, 0", "1000, 0.5"})
  void largeBallsAmongSmallOnes(double ratio, double e) {
    SceneBuilder scene = falling().bounds(0, 0, 167, 400).restitution(e > 0 ? Math.sqrt(e) : 1);
    Random random = new Random(5);
    for (int i = 0; i < 12; i++) {
      double r = i % 2 == 0 ? 14 : 14 / ratio;
      double x = 30 + 34 * (i % 4) + random.nextDouble();
      scene.circle(x, 30 + 50 * (i / 4), r, 0, 0).restitution(Math.sqrt(e)).mass(r * r);
    }
    play(scene, 600);
  }

  /** Radii of 4 to 16 in one heap: it comes to rest, or rolls. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void aHeapOfManySizes(double e) {
    SceneBuilder scene = falling().bounds(0, 0, 200, 700).restitution(e > 0 ? Math.sqrt(e) : 1);
    Random random = new Random(8);
    for (int i = 0; i < 40; i++) {
      double r = 4 + 12 * random.nextDouble();
      scene.circle(20 + 33 * (i % 6), 20 + 33 * (i / 6), r, 0, 0).restitution(Math.sqrt(e));
      scene.mass(r * r);
    }
    ContactRun run = play(scene, 2_500);
    assertThat(run.moving()).isZero();
  }

  /** Rows of N diameters, exactly, and by 1e-7 more or less, five high: odd ones one shorter. */
  @ParameterizedTest
  @CsvSource({
    "2, 0, 0.7",
    "3, 0, 0",
    "3, 0, 0.5",
    "3, 1e-7, 0.5",
    "3, -1e-7, 0.5",
    "10, 0, 0",
    "10, 0, 0.5",
    "10, 1e-7, 0",
    "10, -1e-7, 0.9",
    "40, 0, 0",
    "40, 1e-7, 0.5"
  })
  void fullRows(int across, double clearance, double e) {
    SceneBuilder scene = falling();
    double w = 20 * across + clearance;
    scene.bounds(0, 0, w, 900).restitution(e > 0 ? Math.sqrt(e) : 1);
    for (int row = 0; row < 5; row++) {
      int count = row % 2 == 0 && clearance >= 0 ? across : across - 1;
      for (int i = 0; i < count; i++) {
        double x = (row % 2 == 0 ? 10 : 20) + (20 + Math.max(0, clearance) / across) * i;
        scene.circle(x, 20 + 23 * row, 10, 0, 0).restitution(Math.sqrt(e));
      }
    }
    play(scene, 600);
  }

  /**
   * Close-packed and square crystals, and a column, whose balls touch from the start: they stay.
   */
  @ParameterizedTest
  @CsvSource({"5, true", "10, true", "5, false", "10, false"})
  void crystalsInTouch(int across, boolean isHexagonal) {
    SceneBuilder scene = falling().bounds(0, 0, 20 * across, 800);
    double high = isHexagonal ? Math.sqrt(300) : 20;
    for (int row = 0; row < across; row++) {
      boolean isShort = isHexagonal && row % 2 == 1;
      for (int i = 0; i < across - (isShort ? 1 : 0); i++) {
        scene.circle((isShort ? 20 : 10) + 20 * i, 10 + high * row, 10, 0, 0).restitution(0);
      }
    }
    ContactRun run = play(scene, 300);
    assertThat(run.resting()).isEqualTo(run.world.count(Kind.CIRCLE));
    assertThat(run.world.y(run.world.count(Kind.CIRCLE) - 1))
        .isBetween(9.9 + high * (across - 1), 10.1 + high * (across - 1) + across * 0.08);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "0.5, 0", "0.5, 1"})
  void aColumnOfFiftyStands(double e, double gap) {
    SceneBuilder scene = falling().bounds(-100, 0, 100, 2_000).restitution(1);
    for (int i = 0; i < 50; i++) {
      scene.circle(0, 10 + (20 + gap) * i, 10, 0, 0).restitution(Math.sqrt(e));
    }
    ContactRun run = play(scene, 600);
    assertThat(run.resting()).isEqualTo(50);
    for (int i = 0; i < 50; i++) {
      assertThat(run.world.y(i)).isBetween(9.99 + 20 * i, 10 + 20 * i + 0.08 * (i + 1));
    }
  }

  /** An opening of 1.2 and of 1.9 diameters: balls that wedge there carry all that is above. */
  @ParameterizedTest
  @CsvSource({"24, 1", "24, 2", "38, 1", "38, 2"})
  void anArchInAFunnel(double opening, long seed) {
    SceneBuilder scene = falling().bounds(0, 0, 250, 900).restitution(Math.sqrt(0.5));
    scene.line(0, 350, 125 - opening / 2, 200).line(250, 350, 125 + opening / 2, 200);
    Random random = new Random(seed);
    for (int i = 0; i < 80; i++) {
      double x = 20 + 22 * (i % 10) + random.nextDouble();
      scene.circle(x, 380 + 23 * (i / 10), 10, 0, 0).restitution(0.7);
    }
    play(scene, 1_500);
  }

  /** A ball of mass 100 and radius 40 falls fast on eighty others. */
  @ParameterizedTest
  @ValueSource(doubles = {10, 100, 1000})
  void aHeavyBallFallsOnAHeap(double mass) {
    SceneBuilder scene = falling().bounds(0, 0, 267, 1_500).restitution(0.7);
    Random random = new Random(3);
    for (int i = 0; i < 80; i++) {
      double x = 20 + 22.5 * (i % 11) + random.nextDouble();
      scene.circle(x, 20 + 24 * (i / 11), 10, 0, 0).restitution(0.7);
    }
    play(scene.circle(133, 1_400, 40, 0, -3).mass(mass).restitution(0.7), 900);
  }

  /**
   * Balls from above stay on the first one-way line, balls from below come up through the second.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.5})
  void oneWayLines(double e) {
    SceneBuilder scene = falling().bounds(0, 0, 167, 900).restitution(e > 0 ? Math.sqrt(e) : 1);
    scene.line(0, 200, 167, 200).oneWay();
    Random random = new Random(3);
    for (int i = 0; i < 18; i++) {
      double x = 20 + 24 * (i % 6) + random.nextDouble();
      double y = i < 6 ? 100 : 300 + 30 * (i / 6);
      scene.circle(x, y, 10, 0, i < 6 ? 7 : 0).restitution(Math.sqrt(e));
    }
    ContactRun run = play(scene, 2_000);
    for (int i = 0; i < 18; i++) {
      assertThat(run.world.y(i)).as("ball %s", i).isGreaterThan(210 - 1e-8);
    }
  }

  @Test
  @Tag("long")
  void aThousandBallsInABox() {
    SceneBuilder scene = falling().bounds(0, 0, 667, 1_500).restitution(Math.sqrt(0.5));
    Random random = new Random(3);
    for (int i = 0; i < 1_000; i++) {
      double x = 22 + 22 * (i % 28) + random.nextDouble();
      scene.circle(x, 60 + 30 * (i / 28), 10, random.nextDouble() - 0.5, 0);
      scene.restitution(Math.sqrt(0.5));
    }
    play(scene, 300);
  }
}
