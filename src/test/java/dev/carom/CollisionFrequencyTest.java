// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * How often circles hit what, by integral geometry (L. A. Santalo; N. Chernov, Entropy, Lyapunov
 * exponents, and mean free path for billiards, 1997): the centre moves in the free area Q with the
 * boundary dQ. Started uniformly in Q, in a uniform direction, a circle of speed v makes T v |dQ| /
 * (pi |Q|) impacts in a time T on average, exactly, and each piece of the boundary takes its share
 * of length.
 *
 * <p>A cross of half-length a, grown by r <= a, takes the area 2 (4 a r + pi r^2) - 4 r^2; its
 * boundary is 8 (a - r) flat and 4 pi r round. In the canonical scene 50 of them stand apart from
 * each other and from the bounds even when grown.
 *
 * <pre>
 *          _
 *         | |
 *       __| |__
 *      (__   __)
 *         | |
 *         |_|
 * </pre>
 */
@Tag("long")
class CollisionFrequencyTest {

  private static final int CIRCLES = 4_000;
  private static final double SPEED = 5;
  private static final double TIME = 600;
  private static final double WIDTH = 800;
  private static final double HEIGHT = 600;
  private static final double HALF = 10;
  private static final int CROSSES = 50;

  /** Standard errors that a right count may be off: by chance once in 16,000 counts. */
  private static final double SIGMAS = 4;

  // Impacts with walls, sides and endpoints.
  private static final int KINDS = 3;

  @ParameterizedTest
  @CsvSource({"base-1.csv,10", "base-2.csv,5", "base-3.csv,1", "base-1.csv,9"})
  void impactsAreAsOftenAsTheoryHasIt(String file, double r) {
    double area =
        (WIDTH - 2 * r) * (HEIGHT - 2 * r)
            - CROSSES * (2 * (4 * HALF * r + Math.PI * r * r) - 4 * r * r);
    double[] lengths = {
      2 * (WIDTH - 2 * r) + 2 * (HEIGHT - 2 * r),
      CROSSES * 8 * (HALF - r),
      CROSSES * 4 * Math.PI * r
    };
    double boundary = lengths[0] + lengths[1] + lengths[2];
    if (r == 10) {
      // The figures of the literature.
      assertThat(area).isCloseTo(400984.0735, within(1e-4));
      assertThat(boundary).isCloseTo(9003.18531, within(1e-5));
    }
    int[][] counts = counts(TestScenes.read(file), r);

    double expected = TIME * SPEED * boundary / (Math.PI * area);
    double[] all = new double[CIRCLES];
    for (int i = 0; i < CIRCLES; i++) {
      all[i] = counts[i][0] + counts[i][1] + counts[i][2];
    }
    double mean = mean(all);
    double error = standardError(all);
    System.out.printf(
        "%s, radius %s: %.3f +- %.3f impacts a circle, expected %.3f%n",
        file, r, mean, error, expected);
    assertThat(mean).isCloseTo(expected, within(SIGMAS * error));
    assertThat(error).as("the test is sharp").isLessThan(0.01 * expected);

    for (int kind = 0; kind < KINDS; kind++) {
      assertShare(counts, all, mean, kind, lengths[kind] / boundary);
    }
  }

  /**
   * The share of a kind is a quotient of sums; its error that of the mean of count - share x all.
   */
  private static void assertShare(
      int[][] counts, double[] all, double mean, int kind, double expected) {
    double[] excess = new double[CIRCLES];
    for (int i = 0; i < CIRCLES; i++) {
      excess[i] = counts[i][kind] - expected * all[i];
    }
    double share = expected + mean(excess) / mean;
    double error = standardError(excess) / mean;
    System.out.printf(
        "  %s: %.3f +- %.3f %%, expected %.3f %%%n",
        new String[] {"walls", "sides", "endpoints"}[kind],
        100 * share,
        100 * error,
        100 * expected);
    assertThat(share).isCloseTo(expected, within(SIGMAS * error));
  }

  /** Impacts of each circle with walls, sides and endpoints. */
  private static int[][] counts(Scene crosses, double r) {
    World world = new World(uniform(crosses, r));
    assertThat(world.advanceTo(TIME)).isTrue();
    ImpactLog log = world.impacts();
    int[][] counts = new int[CIRCLES][KINDS];
    for (int row = 0; row < log.size(); row++) {
      boolean wall = log.kind(row) == ObstacleKind.WALL;
      int kind = wall ? 0 : log.feature(row) == Feature.SIDE ? 1 : 2;
      counts[log.circle(row)][kind]++;
    }
    return counts;
  }

  /**
   * The crosses of a scene, with circles that stand anywhere in the free area, in any direction.
   */
  private static Scene uniform(Scene crosses, double r) {
    assertThat(crosses.lineCount()).isEqualTo(2 * CROSSES);
    SceneBuilder builder = Scene.builder().bounds(0, 0, WIDTH, HEIGHT);
    for (int i = 0; i < crosses.lineCount(); i++) {
      Line l = crosses.line(i);
      builder.line(l.ax(), l.ay(), l.bx(), l.by());
    }
    Random random = new Random(1997);
    for (int i = 0; i < CIRCLES; ) {
      Vec2 p =
          new Vec2(
              r + random.nextDouble() * (WIDTH - 2 * r),
              r + random.nextDouble() * (HEIGHT - 2 * r));
      if (isFree(crosses, p, r)) {
        double angle = 2 * Math.PI * random.nextDouble();
        builder.circle(p.x(), p.y(), r, SPEED * Math.cos(angle), SPEED * Math.sin(angle));
        i++;
      }
    }
    return builder.build();
  }

  private static boolean isFree(Scene scene, Vec2 p, double r) {
    for (int i = 0; i < scene.lineCount(); i++) {
      Vec2 q = scene.line(i).closestPoint(p);
      double dx = p.x() - q.x();
      double dy = p.y() - q.y();
      if (dx * dx + dy * dy < r * r) {
        return false;
      }
    }
    return true;
  }

  private static double mean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value;
    }
    return sum / values.length;
  }

  private static double standardError(double[] values) {
    double mean = mean(values);
    double sum = 0;
    for (double value : values) {
      sum += (value - mean) * (value - mean);
    }
    return Math.sqrt(sum / (values.length - 1) / values.length);
  }
}
