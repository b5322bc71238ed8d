// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import java.util.Arrays;

/**
 * A set of errors of place and velocity: all sums of some vectors, each times a number from -1 to
 * 1. A linear map moves the vectors, and new errors add some. {@link #enclose} replaces them by the
 * edges of a box with right angles that holds them all.
 *
 * <p>Its axes follow the longest vector, then what the next one has at right angles to it, and so
 * on. So directions that grow fast do not blow up those that do not: a box with fixed axes would
 * grow at each turn of the velocity.
 *
 * <p>Source: R. J. Lohner, Enclosing the solutions of ordinary initial and boundary value problems,
 * in: Computerarithmetic, Teubner 1987, the QR method.
 */
final class ErrorBox {

  private static final int SIZE = FallingMap.SIZE;

  /** The edges of the box, and at most so many vectors that one impact adds. */
  private static final int MOST = SIZE + 10;

  /** A direction that keeps less than this part of a vector is one of its rounding. */
  private static final double LOST = 0x1p-40;

  private final double[] vectors = new double[MOST * SIZE];
  private int count;

  private final double[] axes = new double[SIZE * SIZE];
  private final double[] axis = new double[SIZE];
  private final double[] lengths = new double[SIZE];

  /** Adds an error of at most this vector, either way. */
  void add(double x, double y, double vx, double vy) {
    int k = next();
    vectors[k] = x;
    vectors[k + 1] = y;
    vectors[k + 2] = vx;
    vectors[k + 3] = vy;
  }

  private int next() {
    int k = count * SIZE;
    Arrays.fill(vectors, k, k + SIZE, 0);
    count++;
    return k;
  }

  void addLate(FallingMap map, double time) {
    map.late(vectors, next(), time);
  }

  void addDelay(FallingMap map, double time) {
    map.delay(vectors, next(), time);
  }

  void addTurn(FallingMap map, double angle) {
    map.turn(vectors, next(), angle);
  }

  void fly(double dt) {
    for (int k = 0; k < count * SIZE; k += SIZE) {
      vectors[k] += vectors[k + 2] * dt;
      vectors[k + 1] += vectors[k + 3] * dt;
    }
  }

  void bounce(FallingMap map) {
    for (int k = 0; k < count * SIZE; k += SIZE) {
      map.apply(vectors, k);
    }
  }

  /** The bound of the delay of an impact. */
  double delay(FallingMap map) {
    double sum = 0;
    for (int k = 0; k < count * SIZE; k += SIZE) {
      sum += Math.abs(map.delay(vectors, k));
    }
    return sum;
  }

  /** The bound of the distance from the true place after a time. */
  double place(double dt) {
    double sum = 0;
    for (int k = 0; k < count * SIZE; k += SIZE) {
      sum +=
          PathError.length(vectors[k] + vectors[k + 2] * dt, vectors[k + 1] + vectors[k + 3] * dt);
    }
    return sum;
  }

  /** The bound of the error of the place in a direction. */
  double place(double x, double y) {
    return extent(0, x, y);
  }

  /** The bound of the error of the velocity in a direction. */
  double velocity(double x, double y) {
    return extent(2, x, y);
  }

  private double extent(int part, double x, double y) {
    double sum = 0;
    for (int k = part; k < count * SIZE; k += SIZE) {
      sum += Math.abs(x * vectors[k] + y * vectors[k + 1]);
    }
    return sum;
  }

  /**
   * Replaces all vectors by the edges of a box that holds their sums.
   *
   * @param time how long a velocity takes to become as important as a place: what right angles are
   *     depends on it, but not whether the box holds all
   * @return whether the box is in the range of doubles
   */
  boolean enclose(double time) {
    double unit = time > 0 ? time : 1;
    scale(unit);
    findAxes();
    for (int i = 0; i < SIZE; i++) {
      double sum = 0;
      for (int k = 0; k < count * SIZE; k += SIZE) {
        sum += Math.abs(dot(axes, i * SIZE, vectors, k));
      }
      lengths[i] = sum;
    }
    double size = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
      vectors[i] = axes[i] * lengths[i / SIZE];
      size += Math.abs(vectors[i]);
    }
    count = SIZE;
    scale(1 / unit);
    return size <= Double.MAX_VALUE;
  }

  private void scale(double unit) {
    for (int k = 0; k < count * SIZE; k += SIZE) {
      vectors[k + 2] *= unit;
      vectors[k + 3] *= unit;
    }
  }

  /** The vectors in the order of their lengths, each made orthogonal to those before; then any. */
  private void findAxes() {
    int found = 0;
    while (found < SIZE) {
      int longest = longest(found);
      if (longest < 0) {
        complete(found);
        return;
      }
      System.arraycopy(axis, 0, axes, found * SIZE, SIZE);
      found++;
    }
  }

  /**
   * Finds, of all vectors, the one that has most left at right angles to the axes so far; puts its
   * direction into {@link #axis}.
   *
   * @return its index, or -1 if nothing but rounding is left
   */
  private int longest(int found) {
    int longest = -1;
    double most = 0;
    double[] rest = new double[SIZE];
    for (int k = 0; k < count * SIZE; k += SIZE) {
      System.arraycopy(vectors, k, rest, 0, SIZE);
      double length = Math.sqrt(dot(rest, 0, rest, 0));
      double left = orthogonalize(rest, found);
      if (left > LOST * length && left > most) {
        most = left;
        longest = k;
        for (int i = 0; i < SIZE; i++) {
          axis[i] = rest[i] / left;
        }
      }
    }
    return longest;
  }

  /** Fills up with axes at right angles to those found. */
  private void complete(int first) {
    int found = first;
    for (int unit = 0; unit < SIZE && found < SIZE; unit++) {
      Arrays.fill(axis, 0);
      axis[unit] = 1;
      double left = orthogonalize(axis, found);
      if (left > 0.25) {
        for (int i = 0; i < SIZE; i++) {
          axes[found * SIZE + i] = axis[i] / left;
        }
        found++;
      }
    }
  }

  /** Takes the axes found so far out of a vector, twice for rounding; returns the length left. */
  private double orthogonalize(double[] vector, int found) {
    for (int round = 0; round < 2; round++) {
      for (int i = 0; i < found; i++) {
        double part = dot(axes, i * SIZE, vector, 0);
        for (int j = 0; j < SIZE; j++) {
          vector[j] -= part * axes[i * SIZE + j];
        }
      }
    }
    return Math.sqrt(dot(vector, 0, vector, 0));
  }

  private static double dot(double[] a, int i, double[] b, int k) {
    return a[i] * b[k] + a[i + 1] * b[k + 1] + a[i + 2] * b[k + 2] + a[i + 3] * b[k + 3];
  }
}
