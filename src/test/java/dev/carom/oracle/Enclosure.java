// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * Bounds of the values of a polynomial in plain doubles. Each operation is rounded outward, to the
 * next double, so the bounds hold whatever cancels, underflows or overflows. They tell most signs.
 */
final class Enclosure {
  private final double[] low;
  private final double[] high;

  /** Of a positive multiple: the largest coefficient is brought to about 1. */
  Enclosure(Dyadic... c) {
    int largest = Integer.MIN_VALUE;
    for (Dyadic x : c) {
      largest = x.signum() == 0 ? largest : Math.max(largest, x.magnitude());
    }
    low = new double[c.length];
    high = new double[c.length];
    for (int i = 0; i < c.length; i++) {
      double near = c[i].signum() == 0 ? 0 : c[i].shift(-largest).near();
      low[i] = c[i].signum() == 0 ? 0 : Math.nextDown(near);
      high[i] = c[i].signum() == 0 ? 0 : Math.nextUp(near);
    }
  }

  /** The sign at a number >= 0; 0 if it stays open. */
  int sign(Dyadic t) {
    double near = t.near();
    return sign(near, near);
  }

  /** The sign that the polynomial has from one number >= 0 to another; 0 if that stays open. */
  int sign(Dyadic from, Dyadic to) {
    return sign(from.near(), to.near());
  }

  /** The doubles are next to the numbers. */
  private int sign(double from, double to) {
    double below = Math.max(0, Math.nextDown(from));
    double above = Math.nextUp(to);
    double least = 0;
    double most = 0;
    for (int i = low.length - 1; i >= 0; i--) {
      least = Math.nextDown(least * (least > 0 ? below : above));
      most = Math.nextUp(most * (most > 0 ? above : below));
      least = Math.nextDown(least + low[i]);
      most = Math.nextUp(most + high[i]);
    }
    return least > 0 ? 1 : most < 0 ? -1 : 0;
  }
}
