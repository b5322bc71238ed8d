// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

/**
 * A set of errors of place and velocity: all sums of the edges of a box with right angles, each
 * times a number from -1 to 1. A linear map moves the edges. {@link ErrorSum} then adds new errors,
 * and encloses all in another box.
 */
final class ErrorBox {

  private static final int SIZE = ImpactMap.SIZE;

  final double[] edges = new double[SIZE * SIZE];

  void fly(double dt) {
    for (int k = 0; k < SIZE * SIZE; k += SIZE) {
      edges[k] += edges[k + 2] * dt;
      edges[k + 1] += edges[k + 3] * dt;
    }
  }

  /** The bound of the delay of an impact. */
  double delay(ImpactMap map) {
    double sum = 0;
    for (int k = 0; k < SIZE * SIZE; k += SIZE) {
      sum += Math.abs(map.delay(edges, k));
    }
    return sum;
  }

  /** The bound of the distance from the true place after a time. */
  double place(double dt) {
    double sum = 0;
    for (int k = 0; k < SIZE * SIZE; k += SIZE) {
      sum += PathError.length(edges[k] + edges[k + 2] * dt, edges[k + 1] + edges[k + 3] * dt);
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
    for (int k = part; k < SIZE * SIZE; k += SIZE) {
      sum += Math.abs(x * edges[k] + y * edges[k + 1]);
    }
    return sum;
  }
}
