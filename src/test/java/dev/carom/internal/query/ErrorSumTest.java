// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A box that encloses errors holds all their sums, and little else. */
class ErrorSumTest {

  private static final int SIZE = ImpactMap.SIZE;

  private final Random random = new Random(3);
  private final ErrorSum sum = new ErrorSum();

  private double[] vector(double size) {
    return random.doubles(SIZE, -size, size).toArray();
  }

  private void add(double[] v) {
    sum.add(v[0], v[1], v[2], v[3]);
  }

  /** The product of two edges where a velocity counts as so much of a place. */
  private static double dot(double[] edges, int i, double[] v, int k, double unit) {
    double places = edges[i] * v[k] + edges[i + 1] * v[k + 1];
    return places + (edges[i + 2] * v[k + 2] + edges[i + 3] * v[k + 3]) * unit * unit;
  }

  private static void assertBox(double[] edges, double unit) {
    for (int i = 0; i < SIZE; i++) {
      for (int k = 0; k < i; k++) {
        double lengths =
            Math.sqrt(
                dot(edges, i * SIZE, edges, i * SIZE, unit)
                    * dot(edges, k * SIZE, edges, k * SIZE, unit));
        assertThat(dot(edges, i * SIZE, edges, k * SIZE, unit))
            .isCloseTo(0, within(1e-14 * lengths));
      }
    }
  }

  /** Whether the extent of a box along each of its edges is that of all the vectors. */
  private static void assertTight(double[] edges, double[][] vectors, double unit) {
    for (int i = 0; i < SIZE; i++) {
      double extent = 0;
      for (double[] v : vectors) {
        extent += Math.abs(dot(edges, i * SIZE, v, 0, unit));
      }
      double square = dot(edges, i * SIZE, edges, i * SIZE, unit);
      assertThat(square).isCloseTo(extent, within(1e-13 * extent));
    }
  }

  @Test
  void theBoxHasRightAnglesAndTouchesTheSum() {
    for (int n = 0; n < 200; n++) {
      double unit = n % 4 == 0 ? 0 : 0.1 + 3 * random.nextDouble();
      double counted = unit == 0 ? 1 : unit;
      ErrorBox box = new ErrorBox();
      for (int k = 0; k < SIZE * SIZE; k++) {
        box.edges[k] = Math.scalb(random.nextDouble() - 0.5, -random.nextInt(n % 2 == 0 ? 1 : 30));
      }
      double[] parts = vector(1);
      double[][] vectors = new double[2 * SIZE + 2][];
      for (int i = 0; i < SIZE; i++) {
        vectors[i] = Arrays.copyOfRange(box.edges, i * SIZE, (i + 1) * SIZE);
        vectors[SIZE + i] = new double[SIZE];
        vectors[SIZE + i][i] = parts[i];
      }
      vectors[2 * SIZE] = vector(1);
      vectors[2 * SIZE + 1] = vector(0.01);
      sum.of(box);
      sum.addParts(0.25 * parts[0], parts[1], parts[2], 0.5 * parts[3]);
      sum.addParts(-0.75 * parts[0], 0, 0, -0.5 * parts[3]);
      add(vectors[2 * SIZE]);
      add(vectors[2 * SIZE + 1]);
      assertThat(sum.enclose(box, unit)).isTrue();
      assertBox(box.edges, counted);
      assertTight(box.edges, vectors, counted);
    }
  }

  /** Nothing new: the axes follow the edges in the order of their lengths, and nothing grows. */
  @Test
  void theAxesFollowTheLongestEdges() {
    ErrorBox box = new ErrorBox();
    double[] longest = {3, 4, 0, 12};
    double[] second = {0.03, 0.04, 0, 0.12 + 1e-9}; // all but parallel
    System.arraycopy(second, 0, box.edges, 0, SIZE);
    System.arraycopy(longest, 0, box.edges, 2 * SIZE, SIZE);
    sum.of(box);
    sum.enclose(box, 1);
    assertBox(box.edges, 1);
    double[] first = Arrays.copyOf(box.edges, SIZE);
    double sign = Math.signum(first[0]);
    for (int j = 0; j < SIZE; j++) {
      assertThat(sign * first[j]).isCloseTo(longest[j] * 1.01, within(1e-8));
    }
    double rest = Math.sqrt(dot(box.edges, SIZE, box.edges, SIZE, 1));
    assertThat(rest).isCloseTo(1e-9 * 5 / 13, within(1e-14));
    assertThat(Arrays.copyOfRange(box.edges, 2 * SIZE, 4 * SIZE))
        .containsOnly(new double[] {0}, within(1e-14));
  }

  @Test
  void noErrorIsAnEmptyBox() {
    ErrorBox box = new ErrorBox();
    sum.of(box);
    assertThat(sum.enclose(box, 1)).isTrue();
    assertThat(box.edges).containsOnly(0);
    assertThat(box.place(7)).isZero();
  }

  @Test
  void aBoxBeyondTheRangeOfDoublesIsTold() {
    for (double large : new double[] {Double.MAX_VALUE, Double.POSITIVE_INFINITY, Double.NaN}) {
      ErrorBox box = new ErrorBox();
      sum.of(box);
      sum.addParts(large, large, 0, 0);
      assertThat(sum.enclose(box, 1)).isFalse();
    }
  }

  /** Each extent of a box is the sum of those of its edges. */
  @Test
  void aBoxFliesAndIsMeasuredByItsEdges() {
    ErrorBox box = new ErrorBox();
    double[] edges = {3, 4, 1, -1, 0.5, -0.25, 2, 3, 1, 1, -4, 5, 0, 2, 3, 0};
    System.arraycopy(edges, 0, box.edges, 0, edges.length);
    double t = 2;
    double places = 0;
    double along = 0;
    double speed = 0;
    double delay = 0;
    for (int k = 0; k < edges.length; k += SIZE) {
      places += Math.hypot(edges[k] + t * edges[k + 2], edges[k + 1] + t * edges[k + 3]);
      along += Math.abs(0.6 * edges[k] - 0.8 * edges[k + 1]);
      speed += Math.abs(0.6 * edges[k + 2] - 0.8 * edges[k + 3]);
      delay += Math.abs(edges[k + 1]) / 2;
    }
    ImpactMap floor = new ImpactMap(1, -2, 0, 0, 0, 1, Double.POSITIVE_INFINITY, 1);
    assertThat(box.delay(floor)).isCloseTo(delay, within(1e-14));
    assertThat(box.place(t)).isCloseTo(places, within(1e-14));
    assertThat(box.place(0.6, -0.8)).isCloseTo(along, within(1e-14));
    assertThat(box.velocity(0.6, -0.8)).isCloseTo(speed, within(1e-14));
    box.fly(t);
    assertThat(box.place(0)).isCloseTo(places, within(1e-14));
  }
}
