// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

/**
 * The offset on one axis from a point that moves straight on to one with a constant acceleration g:
 * {@code d + t e}, where {@code d = p - q} is the offset at the start, {@code u = v - w} the
 * relative velocity, and {@code e = u + g t / 2} its mean up to t.
 *
 * <p>No power of time is formed, which would underflow long before the offset does.
 */
public final class Offset {

  private Offset() {}

  /** The offset at a time, with its rounding error added. */
  public static double at(double p, double q, double v, double w, double g, double t) {
    return head(p, q, v, w, g, t) + tail(p, q, v, w, g, t);
  }

  static double head(double p, double q, double v, double w, double g, double t) {
    return (p - q) + t * mean(v, w, g, t);
  }

  /** The rounding error of the head, which is below 6 u of the terms. */
  static double tail(double p, double q, double v, double w, double g, double t) {
    return scaledTail(1, p, q, t, mean(v, w, g, t), meanTail(v, w, g, t));
  }

  /**
   * The rounding error of {@code k (p - q) + t e}, for a small power of two k and e with its tail.
   */
  static double scaledTail(double k, double p, double q, double t, double e, double el) {
    double d = p - q;
    double m = t * e;
    return sumTail(k * d, m, k * d + m)
        + (k * differenceTail(p, q, d) + (productTail(t, e, m) + t * el));
  }

  public static double mean(double v, double w, double g, double t) {
    return (v - w) + 0.5 * g * t;
  }

  static double meanTail(double v, double w, double g, double t) {
    double u = v - w;
    double m = 0.5 * g * t;
    return sumTail(u, m, u + m) + (differenceTail(v, w, u) + productTail(0.5 * g, t, m));
  }

  /** The relative velocity at a time. */
  static double speed(double v, double w, double g, double t) {
    return (v - w) + g * t;
  }

  /** The sum of the absolute values of the terms of an offset. */
  static double size(double d, double u, double g, double t) {
    return Math.abs(d) + (Math.abs(u) + Math.abs(0.5 * g) * t) * t;
  }
}
