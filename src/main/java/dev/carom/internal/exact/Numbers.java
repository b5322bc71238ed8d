// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.exact;

/** Makes the polynomials of a question on one rung of precision. */
public interface Numbers<P> {

  /** {@code (p - q) + (v - u) t + g / 2 t^2}. */
  P motion(double p, double q, double v, double u, double g);

  /** {@code (p - q) + v t}. */
  P line(double p, double q, double v);

  /** The constant p - q. */
  P difference(double p, double q);
}
