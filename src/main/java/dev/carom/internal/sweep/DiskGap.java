// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

import dev.carom.internal.exact.DoubleDoubleNumber;
import dev.carom.internal.exact.Expansion;

/**
 * The gap of {@link ParabolaDiskSweep}, {@code c0 + c1 t + c2 t^2 + c3 t^3 + c4 t^4}, with
 * coefficients from sums without rounding. Where one of them is all rounding error in doubles, as
 * the gap or the speed at the start of a contact, it has all its digits here.
 */
final class DiskGap {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  /** Corrections of a time by Newton's method, and doubles beside it that are tried. */
  private static final int CORRECTIONS = 6;

  /**
   * The gap at a time, of the sum of its absolute terms, in {@code u^2 = 2^-106}: its coefficients
   * err by 64, four products and four sums by 5 and 4 each: 100, and the sum is computed, too.
   */
  private static final double BOUND = 128 * 0x1p-106;

  /** Underflow of fewer than 64 operations, times a power of the time up to the fourth. */
  private static final double TINY = 0x1p-460;

  private static final double MOST = 0x1p400;

  private final Expansion dx;
  private final Expansion dy;
  private final Expansion ux;
  private final Expansion uy;
  private final Expansion gx;
  private final Expansion gy;

  DiskGap(
      double x1, double y1, double vx1, double vy1, double gx, double gy, double x2, double y2,
      double vx2, double vy2) {
    dx = Expansion.difference(x1, x2);
    dy = Expansion.difference(y1, y2);
    ux = Expansion.difference(vx1, vx2);
    uy = Expansion.difference(vy1, vy2);
    this.gx = Expansion.sum(gx, 0);
    this.gy = Expansion.sum(gy, 0);
  }

  /** d.d - r^2. */
  private Expansion c0(double r1, double r2) {
    Expansion r = Expansion.sum(r1, r2);
    return Expansion.dot(dx, dy, dx, dy).plus(-1, r, r);
  }

  /** Half of c1. */
  private Expansion dotSpeed() {
    return Expansion.dot(dx, dy, ux, uy);
  }

  private Expansion c2() {
    return Expansion.dot(ux, uy, ux, uy).plus(1, dx, gx).plus(1, dy, gy);
  }

  private Expansion c3() {
    return Expansion.dot(ux, uy, gx, gy);
  }

  /** Four times c4. */
  private Expansion dotAcceleration() {
    return Expansion.dot(gx, gy, gx, gy);
  }

  /**
   * Whether the disk certainly moves on one straight line, at a distance of r or more:
   * {@code u x g = 0} and {@code (d x g)^2 >= r^2 g.g}. At most the disk grazes the other. At
   * radius 0 the distance must be above 0, as a point that comes to another hits it.
   */
  boolean staysOutside(double r1, double r2) {
    Expansion turn = Expansion.cross(ux, uy, gx, gy);
    if (!turn.isExact() || turn.sign() != 0) {
      return false;
    }
    Expansion aside = Expansion.cross(dx, dy, gx, gy);
    Expansion r = Expansion.sum(r1, r2);
    Expansion rr = new Expansion().plus(1, r, r);
    Expansion clearance =
        new Expansion().plus(1, aside, aside).plus(-1, rr, dotAcceleration());
    int least = r.sign() > 0 ? 0 : 1;
    return clearance.isExact() && clearance.sign() >= least;
  }

  /**
   * The double nearest to a time at which the gap falls to 0, from a time near that; NaN if
   * double-double does not tell. It falls from above 0 halfway to the double before to below 0
   * halfway to the one after.
   */
  double nearest(double r1, double r2, double start) {
    Expansion[] exact = {c0(r1, r2), dotSpeed(), c2(), c3(), dotAcceleration()};
    DoubleDoubleNumber[] c = new DoubleDoubleNumber[exact.length];
    for (int i = 0; i < c.length; i++) {
      if (!exact[i].isExact()) {
        return GapRoot.DOUBT;
      }
      c[i] = exact[i].value();
    }
    c[1] = c[1].scaled(2);
    c[4] = c[4].scaled(0.25);
    double t = start;
    double step = NEVER;
    for (int i = 0; i < CORRECTIONS && Math.abs(step) > 0x1p-40 * t; i++) {
      step = at(c, new DoubleDoubleNumber(t, 0)).head() / slope(c, t);
      t -= step;
    }
    for (int i = 0; i < CORRECTIONS && t > 0 && t < GapRoot.LATEST; i++) {
      int before = sign(c, t, 0.5 * (Math.nextDown(t) - t));
      int after = sign(c, t, 0.5 * Math.ulp(t));
      if (before > 0 && after < 0) {
        return t;
      }
      if (before * after <= 0) {
        return GapRoot.DOUBT;
      }
      t = before > 0 ? Math.nextUp(t) : Math.nextDown(t);
    }
    return GapRoot.DOUBT;
  }

  private static DoubleDoubleNumber at(DoubleDoubleNumber[] c, DoubleDoubleNumber t) {
    DoubleDoubleNumber value = c[4];
    for (int i = 3; i >= 0; i--) {
      value = value.times(t).plus(c[i]);
    }
    return value;
  }

  private static double slope(DoubleDoubleNumber[] c, double t) {
    return c[1].head() + (2 * c[2].head() + (3 * c[3].head() + 4 * c[4].head() * t) * t) * t;
  }

  /** The sign of the gap at a time t + rest; 0 in doubt. */
  private static int sign(DoubleDoubleNumber[] c, double t, double rest) {
    double terms = Math.abs(c[4].head());
    for (int i = 3; i >= 0; i--) {
      terms = terms * t + Math.abs(c[i].head());
    }
    double value = at(c, DoubleDoubleNumber.of(t, rest)).head();
    boolean isCertain = Math.abs(value) > fma(BOUND, terms, TINY) && terms < MOST;
    return isCertain ? UnitVectors.sign(value) : 0;
  }

  /**
   * The time of the return of a disk that counts as touching at the start without normal speed, up
   * to T: the gap over the square of time is {@code c2 + c3 t + c4 t^2}. NaN if double-double does
   * not tell.
   */
  double returnWithoutSpeed(double T) {
    Expansion c2 = c2();
    Expansion c3 = c3();
    Expansion gg = dotAcceleration();
    if (!(c2.isExact() && c3.isExact() && gg.isExact())) {
      return GapRoot.DOUBT;
    }
    if (c2.sign() <= 0) {
      return c2.sign() < 0 || c3.sign() < 0 ? 0 : NEVER;
    }
    DoubleDoubleNumber k0 = c2.value();
    DoubleDoubleNumber k1 = c3.value();
    DoubleDoubleNumber k2 = gg.value().scaled(0.25);
    if (!(QuadraticRoot.isSafe(k0) && QuadraticRoot.isSafe(k1) && QuadraticRoot.isSafe(k2))) {
      return GapRoot.DOUBT;
    }
    double time = QuadraticRoot.fall(k0, k1, k2);
    return time == NEVER ? NEVER : GapRoot.upTo(T, time);
  }
}
