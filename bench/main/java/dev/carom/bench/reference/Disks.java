// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;

/** When a point that moves comes near another one. */
final class Disks {

  private Disks() {}

  /**
   * When the offset {@code d + v t} is first as short as the reach R while it gets shorter: at
   * {@code t = (d.d - R^2) / (-d.v + sqrt(v.v R^2 - (d x v)^2))}.
   *
   * @return null for never
   */
  static Touch contact(Vec d, Vec v, Ball reach, Feature feature, int bits) {
    Ball b = d.dot(v);
    if (b.sign() >= 0) {
      return null;
    }
    Ball squared = reach.times(reach);
    Ball gap = d.dot(d).minus(squared);
    if (gap.sign() <= 0) {
      return new Touch(Ball.of(0, bits), feature, true);
    }
    Ball cross = d.cross(v);
    Ball disc = v.dot(v).times(squared).minus(cross.times(cross));
    if (disc.sign() <= 0) {
      return null;
    }
    return new Touch(gap.over(disc.sqrt().minus(b)), feature, false);
  }

  /**
   * A lower bound of that time, in plain doubles; infinity for certainly never. Taken with a margin
   * far beyond rounding.
   */
  static double earliest(double dx, double dy, double vx, double vy, double reach, double extent) {
    double wide = reach + 0x1p-40 * (extent + reach);
    double vv = vx * vx + vy * vy;
    double b = dx * vx + dy * vy;
    double gap = dx * dx + dy * dy - wide * wide;
    double cross = dx * vy - dy * vx;
    double disc = vv * wide * wide - cross * cross;
    boolean judged = vv > 1e-200 && vv < 1e200 && extent < 1e100;
    if (!judged || gap <= 0) {
      return 0;
    }
    return b >= 0 || disc < 0 ? Double.POSITIVE_INFINITY : gap / (Math.sqrt(disc) - b);
  }
}
