// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.Arrays;

/** The roots of a polynomial with doubles as coefficients, in exact numbers. */
public final class Roots {
  private Roots() {}

  /**
   * The correctly rounded positive roots at which a polynomial falls with a slope, in ascending
   * order.
   *
   * @param c the coefficients, the constant one first
   */
  public static double[] falls(double... c) {
    SturmPolynomial f =
        new SturmPolynomial(Arrays.stream(c).mapToObj(Dyadic::of).toArray(Dyadic[]::new));
    return f.positiveRoots().stream()
        .filter(root -> root.sign(f.derivative()) < 0)
        .mapToDouble(SturmRoot::nearest)
        .toArray();
  }
}
