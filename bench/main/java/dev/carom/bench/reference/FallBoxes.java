// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

/**
 * Boxes around pieces of a circle's path, in plain doubles: what meets none of them is not touched.
 */
final class FallBoxes {

  private static final int PIECES = 64;

  /** Covers what plain doubles may have got wrong, many times over. */
  private static final double MARGIN = 1e-9;

  private final double[][] boxes = new double[PIECES][];

  FallBoxes(Fall path, Ball radius, double end) {
    double[] x = {path.p().x().head(), path.v().x().head(), path.a().x().head()};
    double[] y = {path.p().y().head(), path.v().y().head(), path.a().y().head()};
    double piece = end / PIECES;
    for (int i = 0; i < PIECES; i++) {
      double[] acrossX = interval(x, i * piece, piece, radius.head());
      double[] acrossY = interval(y, i * piece, piece, radius.head());
      boxes[i] = new double[] {acrossX[0], acrossY[0], acrossX[1], acrossY[1]};
    }
  }

  /** A parabola leaves its chord by at most {@code |a| d^2 / 8} in a duration d. */
  private static double[] interval(double[] axis, double from, double duration, double radius) {
    double start = place(axis, from);
    double end = place(axis, from + duration);
    double reach = Math.abs(axis[0]) + Math.abs(axis[1] * from) + Math.abs(axis[2]) * from * from;
    double wide =
        radius + Math.abs(axis[2]) * duration * duration / 8 + MARGIN * (reach + radius + 1);
    return new double[] {Math.min(start, end) - wide, Math.max(start, end) + wide};
  }

  private static double place(double[] axis, double t) {
    return axis[0] + (axis[1] + 0.5 * axis[2] * t) * t;
  }

  /** Whether the circle may touch what is in a box. */
  boolean meet(double[] box) {
    for (double[] piece : boxes) {
      if (box[0] <= piece[2] && box[2] >= piece[0] && box[1] <= piece[3] && box[3] >= piece[1]) {
        return true;
      }
    }
    return false;
  }
}
