// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import java.util.Arrays;

/**
 * The sum of a box and of new errors. The axes of the box that {@link #enclose encloses} it follow
 * the longest edge of the box before, then what the next one has at right angles to it, and so on.
 * So directions that grow fast do not blow up those that do not: a box with fixed axes would grow
 * at each turn of the velocity.
 *
 * <p>Source: R. J. Lohner, Enclosing the solutions of ordinary initial and boundary value problems,
 * in: Computerarithmetic, Teubner 1987, the QR method. Here the decomposition is made by
 * reflections, which keep right angles whatever the edges are (A. S. Householder, J. ACM 5, 1958).
 *
 * <p>One object serves many circles in turn: theirs would not fit in the nearest cache.
 */
public final class ErrorSum {

  private static final int SIZE = ImpactMap.SIZE;

  /** The edges of the box, and at most so many vectors that one impact adds. */
  private static final int MOST = SIZE + 6;

  private final double[] vectors = new double[MOST * SIZE];
  private int count;

  /** Errors along the axes of place and velocity. */
  private final double[] parts = new double[SIZE];

  /** The edges while they are reflected. */
  private final double[] reflected = new double[SIZE * SIZE];

  /** The product of the reflections; its columns are the axes of the new box. */
  private final double[] axes = new double[SIZE * SIZE];

  /** The normal of a reflection. */
  private final double[] w = new double[SIZE];

  /** Begins with the errors of a box. */
  void of(ErrorBox box) {
    System.arraycopy(box.edges, 0, vectors, 0, SIZE * SIZE);
    count = SIZE;
    Arrays.fill(parts, 0);
  }

  /** Adds an error of at most this vector, either way. */
  void add(double x, double y, double vx, double vy) {
    int k = next();
    vectors[k] = x;
    vectors[k + 1] = y;
    vectors[k + 2] = vx;
    vectors[k + 3] = vy;
  }

  /** Adds errors of at most these numbers along the axes of place and velocity. */
  void addParts(double x, double y, double vx, double vy) {
    parts[0] += Math.abs(x);
    parts[1] += Math.abs(y);
    parts[2] += Math.abs(vx);
    parts[3] += Math.abs(vy);
  }

  void addLate(ImpactMap map, double time) {
    map.late(vectors, next(), time);
  }

  void addDelay(ImpactMap map, double time) {
    map.delay(vectors, next(), time);
  }

  void addTurn(ImpactMap map, double angle) {
    map.turn(vectors, next(), angle);
  }

  private int next() {
    int k = count * SIZE;
    Arrays.fill(vectors, k, k + SIZE, 0);
    count++;
    return k;
  }

  void bounce(ImpactMap map) {
    for (int k = 0; k < count * SIZE; k += SIZE) {
      map.apply(vectors, k);
    }
  }

  /**
   * Makes a box that holds the sum.
   *
   * @param time how long a velocity takes to become as important as a place: what right angles are
   *     depends on it, but not whether the box holds all
   * @return whether the box is in the range of doubles
   */
  boolean enclose(ErrorBox box, double time) {
    double unit = time > 0 ? time : 1;
    scale(vectors, count, unit);
    findAxes();
    double size = 0;
    for (int i = 0; i < SIZE; i++) {
      double length = length(i, unit);
      size += length;
      for (int j = 0; j < SIZE; j++) {
        box.edges[i * SIZE + j] = axes[j * SIZE + i] * length;
      }
    }
    scale(box.edges, SIZE, 1 / unit);
    return size <= Double.MAX_VALUE;
  }

  /** The length of the box along an axis. */
  private double length(int i, double unit) {
    double x = axes[i];
    double y = axes[SIZE + i];
    double vx = axes[2 * SIZE + i];
    double vy = axes[3 * SIZE + i];
    double sum =
        Math.abs(x) * parts[0]
            + Math.abs(y) * parts[1]
            + (Math.abs(vx) * parts[2] + Math.abs(vy) * parts[3]) * unit;
    for (int k = 0; k < count * SIZE; k += SIZE) {
      sum +=
          Math.abs(x * vectors[k] + y * vectors[k + 1] + vx * vectors[k + 2] + vy * vectors[k + 3]);
    }
    return sum;
  }

  private static void scale(double[] vectors, int count, double unit) {
    for (int k = 0; k < count * SIZE; k += SIZE) {
      vectors[k + 2] *= unit;
      vectors[k + 3] *= unit;
    }
  }

  /**
   * Reflects space until the longest edge lies along the first axis, the longest rest of the others
   * in the plane of the first two, and so on. The reflections in reverse order map the unit vectors
   * to the axes.
   */
  private void findAxes() {
    System.arraycopy(vectors, 0, reflected, 0, SIZE * SIZE);
    Arrays.fill(axes, 0);
    for (int i = 0; i < SIZE; i++) {
      axes[i * SIZE + i] = 1;
    }
    for (int first = 0; first < SIZE - 1; first++) {
      reflect(longest(first), first);
    }
  }

  /** The edge that has most left at right angles to the first so many axes. */
  private int longest(int first) {
    int longest = 0;
    double most = 0;
    for (int k = 0; k < SIZE * SIZE; k += SIZE) {
      double rest = rest(k, first);
      longest = rest > most ? k : longest;
      most = Math.max(most, rest);
    }
    return longest;
  }

  /** The square of what an edge has left at right angles to the first so many axes. */
  private double rest(int k, int first) {
    double square = 0;
    for (int j = first; j < SIZE; j++) {
      square += reflected[k + j] * reflected[k + j];
    }
    return square;
  }

  /**
   * Reflects what the edge at k has left at right angles to the first so many axes onto the next
   * one, e: with the length r of this rest and {@code w = rest +- r e}, a vector x becomes {@code x
   * - 2 (w.x) / (w.w) w}, where {@code w.w = 2 r |w.e|}.
   */
  private void reflect(int k, int first) {
    double length = Math.sqrt(rest(k, first));
    for (int j = 0; j < SIZE; j++) {
      w[j] = j < first ? 0 : reflected[k + j];
    }
    w[first] += w[first] < 0 ? -length : length;
    double factor = 1 / (length * Math.abs(w[first]));
    if (factor <= Double.MAX_VALUE) { // else nothing is left
      for (int i = 0; i < SIZE * SIZE; i += SIZE) {
        mirror(reflected, i, factor);
        mirror(axes, i, factor);
      }
    }
  }

  private void mirror(double[] x, int i, double factor) {
    double part = factor * (w[0] * x[i] + w[1] * x[i + 1] + w[2] * x[i + 2] + w[3] * x[i + 3]);
    for (int j = 0; j < SIZE; j++) {
      x[i + j] -= part * w[j];
    }
  }
}
