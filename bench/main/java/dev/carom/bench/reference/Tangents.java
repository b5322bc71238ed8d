// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.util.Arrays;

/**
 * How the state of one circle moves when the values move with which its scene starts: the
 * derivatives by ln q, for each start value q. At a given time: an impact that comes later by dt
 * leaves the place where it was, less {@code (v' - v) dt}.
 *
 * <p>In plain doubles, along the proved course: they are known to 1e-12 of themselves or so.
 */
final class Tangents {

  /** A state is x, y, vx, vy. */
  static final int STATE = 4;

  /** Above it, all are scaled down by it. */
  private static final int ROOM = 500;

  /** The derivatives of the state, one row a start value. */
  private final double[][] rows;

  private int exponent;

  private Tangents(int values) {
    rows = new double[values][STATE];
  }

  /** Derivatives of a circle whose own start values are the four from the given one on. */
  Tangents(int values, int first, double... state) {
    this(values);
    for (int i = 0; i < STATE; i++) {
      rows[first + i][i] = state[i];
    }
  }

  /** Derivatives of a thing at rest, which depends on no start value. */
  Tangents still() {
    return new Tangents(rows.length);
  }

  void fly(double dt) {
    for (double[] row : rows) {
      row[0] += row[2] * dt;
      row[1] += row[3] * dt;
    }
  }

  /**
   * The base-10 logarithm of the sum over the start values of the place's derivatives, dt ahead.
   */
  double log10(double dt) {
    double sum = 0;
    for (double[] row : rows) {
      sum += Math.hypot(row[0] + row[2] * dt, row[1] + row[3] * dt);
    }
    return Math.log10(sum) + exponent * Math.log10(2);
  }

  /**
   * An impact: {@code v -= share J n} with {@code J = (1 + e) (u.n) / (n.n)}, at the time at which
   * the offset along n is what it is at a contact.
   */
  static void impact(Impulse impulse, Tangents a, double shareA, Tangents b, double shareB) {
    align(a, b);
    for (int q = 0; q < a.rows.length; q++) {
      impulse.push(a.rows[q], shareA, b.rows[q], -shareB);
    }
    a.scale();
    b.scale();
  }

  private static void align(Tangents a, Tangents b) {
    int common = Math.max(a.exponent, b.exponent);
    a.scale(common - a.exponent);
    b.scale(common - b.exponent);
  }

  private void scale() {
    double most = 0;
    for (double[] row : rows) {
      most = Math.max(most, Arrays.stream(row).map(Math::abs).max().orElse(0));
    }
    if (most > Math.scalb(1.0, ROOM)) {
      scale(ROOM);
    }
  }

  private void scale(int bits) {
    if (bits == 0) {
      return;
    }
    exponent += bits;
    for (double[] row : rows) {
      for (int i = 0; i < STATE; i++) {
        row[i] = Math.scalb(row[i], -bits);
      }
    }
  }
}
