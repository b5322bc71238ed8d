// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** Changes of magnitude of the numbers of a query, whose last one is the end of the window. */
final class Extremes {
  private Extremes() {}

  /** The same scene in a unit of length smaller by 2^exponent: exact until the range ends. */
  static void scale(double[] n, int exponent) {
    for (int i = 0; i < n.length - 1; i++) {
      n[i] = Math.scalb(n[i], exponent);
    }
  }

  /** Velocities times 2^-k, and as a rule the window times 2^k. */
  static void scaleTime(Draw d, double[] n, int... velocities) {
    int k = d.whole(-1000, 1075);
    for (int i : velocities) {
      n[i] = Math.scalb(n[i], -k);
    }
    double fitting = Math.min(Math.scalb(n[n.length - 1], k), Double.MAX_VALUE);
    double any = d.pick(1, 1e-300, Double.MAX_VALUE, Double.POSITIVE_INFINITY);
    n[n.length - 1] = d.chance(0.7) ? fitting : any;
  }

  /** Every number of its own magnitude, 1e-310..1e150. */
  static void mix(Draw d, double[] n) {
    double low = d.pick(1e-310, 1e-150, 1e-20);
    double high = d.pick(1e20, 1e150);
    for (int i = 0; i < n.length - 1; i++) {
      n[i] = d.chance(0.1) ? 0 : d.sign() * d.log(low, high);
    }
    n[n.length - 1] = d.pick(1, d.log(1e-300, 1e300), Double.POSITIVE_INFINITY);
  }

  /** A lattice of whole numbers, in units of the least double. */
  static double[] denormal(double[] n) {
    double[] small = n.clone();
    for (int i = 0; i < n.length - 1; i++) {
      small[i] = Math.rint(n[i]) * Double.MIN_VALUE;
    }
    return small;
  }
}
