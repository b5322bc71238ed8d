// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * When do two moving spheres hit each other, within a window of time? The numbers are x, y, z, r,
 * vx, vy, vz of the first, the same of the second, and the end of the window.
 */
public final class SphereQuery {
  private final double[] numbers;

  public SphereQuery(double... numbers) {
    this.numbers = numbers.clone();
  }

  public double[] numbers() {
    return numbers.clone();
  }

  /** The correctly rounded time by the contract of contact, infinite for a miss. */
  public double truth() {
    double[] n = numbers;
    Dyadic dd = Dyadic.ZERO;
    Dyadic uu = Dyadic.ZERO;
    Dyadic ud = Dyadic.ZERO;
    for (int axis = 0; axis < 3; axis++) {
      Dyadic d = Dyadic.of(n[axis]).minus(Dyadic.of(n[axis + 7]));
      Dyadic u = Dyadic.of(n[axis + 4]).minus(Dyadic.of(n[axis + 11]));
      dd = dd.plus(d.square());
      uu = uu.plus(u.square());
      ud = ud.plus(u.times(d));
    }
    Dyadic r = Dyadic.of(n[3]).plus(Dyadic.of(n[10]));
    Dyadic gap = dd.minus(r.square());
    if (ud.signum() >= 0) {
      return Double.POSITIVE_INFINITY;
    }
    if (gap.signum() <= 0) {
      return 0;
    }
    Dyadic discriminant = ud.square().minus(uu.times(gap));
    int sign = discriminant.signum();
    if (sign < 0 || (sign == 0 && r.signum() > 0)) {
      return Double.POSITIVE_INFINITY;
    }
    Moment t = new Moment(new Surd(ud.negate(), Dyadic.ONE.negate(), discriminant), uu);
    return t.within(n[14]) ? t.nearest() : Double.POSITIVE_INFINITY;
  }

  /** Whether the distance of the centres is less than the sum of the radii. */
  public boolean overlaps() {
    Dyadic dd = Dyadic.ZERO;
    for (int axis = 0; axis < 3; axis++) {
      dd = dd.plus(Dyadic.of(numbers[axis]).minus(Dyadic.of(numbers[axis + 7])).square());
    }
    return dd.compareTo(Dyadic.of(numbers[3]).plus(Dyadic.of(numbers[10])).square()) < 0;
  }
}
