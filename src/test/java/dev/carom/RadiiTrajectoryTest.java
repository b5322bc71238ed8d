// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * The accuracy that a trajectory can promise. Each impact rounds the state once, an error of 2^-53,
 * and the scene multiplies it; the conditioning of a place, the sum of |d place / d ln q| over the
 * start values q, says how much. The promise: an error of at most 4 x 2^-53 x conditioning.
 *
 * <p>Reference: the scene {@code radii} in arbitrary precision, places correctly rounded at each of
 * 600 frames.
 */
@Tag("long")
class RadiiTrajectoryTest {

  private static final int FRAMES = 600;
  private static final int CIRCLES = 100;

  /** Promised, in units of 2^-53 x conditioning. */
  private static final double PROMISE = 4;

  /** Beyond this conditioning, 10^12, nothing is promised. */
  private static final double MOST = 12;

  private static final double[][] LOG_CONDITION = new double[FRAMES + 1][CIRCLES];
  private static final double[][] X = new double[FRAMES + 1][CIRCLES];
  private static final double[][] Y = new double[FRAMES + 1][CIRCLES];

  @BeforeAll
  static void read() throws IOException {
    forEachRow(
        "radii-conditioning.csv.gz",
        row -> LOG_CONDITION[number(row[0])][number(row[1])] = Double.parseDouble(row[2]));
    forEachRow(
        "radii-positions.csv.gz",
        row -> {
          X[number(row[0])][number(row[1])] = Double.parseDouble(row[2]);
          Y[number(row[0])][number(row[1])] = Double.parseDouble(row[3]);
        });
  }

  private static int number(String field) {
    return Integer.parseInt(field);
  }

  private static void forEachRow(String file, Consumer<String[]> action) throws IOException {
    try (BufferedReader in = new BufferedReader(open(file))) {
      in.readLine(); // the header
      in.lines().map(line -> line.split(",")).forEach(action);
    }
  }

  private static Reader open(String file) {
    try {
      var in = Files.newInputStream(TestScenes.path(file));
      return new InputStreamReader(
          file.endsWith(".gz") ? new GZIPInputStream(in) : in, StandardCharsets.US_ASCII);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void errorsStayWithinThePromise() {
    World world = new World(TestScenes.read("radii.csv"));
    double[] ratios = new double[FRAMES * CIRCLES];
    int count = 0;
    for (int frame = 1; frame <= FRAMES; frame++) {
      world.step(1);
      for (int i = 0; i < CIRCLES; i++) {
        if (LOG_CONDITION[frame][i] < MOST) {
          ratios[count++] = error(world, frame, i) / unit(frame, i);
        }
      }
    }
    Arrays.sort(ratios, 0, count);
    double worst = ratios[count - 1];
    System.out.printf(
        "radii: error / (2^-53 x conditioning) at %d places: worst %.2f, p99 %.2f, median %.3f%n",
        count, worst, ratios[count * 99 / 100], ratios[count / 2]);
    assertThat(count).isGreaterThan(30_000);
    assertThat(worst).isLessThanOrEqualTo(PROMISE);
  }

  private static double error(World world, int frame, int i) {
    return Math.hypot(world.x(i) - X[frame][i], world.y(i) - Y[frame][i]);
  }

  private static double unit(int frame, int i) {
    return 0x1p-53 * Math.pow(10, LOG_CONDITION[frame][i]);
  }

  private static int column(Impact row) {
    if (row.kind() == Kind.WALL) {
      return 3;
    }
    return row.feature() == Feature.SIDE ? 0 : row.feature() == Feature.START ? 1 : 2;
  }

  /**
   * The impacts of each feature over all frames, of the circles whose last place is still known to
   * 1e-3: they made the same impacts as the reference.
   */
  @Test
  void impactsOfEachFeatureAreThoseOfTheReference() throws IOException {
    int[][] counts = new int[CIRCLES][4];
    World world = new World(TestScenes.read("radii.csv"));
    world.advanceTo(FRAMES);
    for (Impact row : Run.rows(world.impacts())) {
      counts[row.circle()][column(row)]++;
    }
    int[] compared = new int[1];
    forEachRow(
        "radii-impacts.csv",
        row -> {
          int i = number(row[0]);
          if (PROMISE * unit(FRAMES, i) < 1e-3) {
            int[] expected = {number(row[1]), number(row[2]), number(row[3]), number(row[4])};
            assertThat(counts[i]).as("side, start, end, wall of circle %s", i).isEqualTo(expected);
            compared[0]++;
          }
        });
    System.out.println("radii: impacts compared of " + compared[0] + " circles");
    assertThat(compared[0]).isGreaterThan(15);
  }

  /** The velocities of the same circles at the end, if their places are known. */
  @Test
  void velocitiesAreThoseOfTheReference() throws IOException {
    World world = new World(TestScenes.read("radii.csv"));
    world.advanceTo(FRAMES);
    forEachRow(
        "radii-impacts.csv",
        row -> {
          int i = number(row[0]);
          if (LOG_CONDITION[FRAMES][i] < MOST) {
            double error =
                Math.hypot(
                    world.vx(i) - Double.parseDouble(row[5]),
                    world.vy(i) - Double.parseDouble(row[6]));
            assertThat(error).as("circle %s", i).isLessThan(PROMISE * unit(FRAMES, i));
          }
        });
  }
}
