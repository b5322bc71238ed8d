// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;

import dev.carom.internal.exact.PrecisionCounter;

/**
 * The time at which a moving disk hits the flat side of a line, once {@link SegmentSweep#contact}
 * has found that it does: {@code |cross(w, d)| - |cross(w, v)| t = r |w|}, with {@code w = b - a},
 * {@code d = p - a}.
 *
 * <p>The numbers are arguments, not a value, for the reason that {@link SegmentSweep} gives.
 */
public final class SideSweep {

  /** The number of corrections before exact numbers take over. */
  private static final int STEPS = 3;

  /** Range within which underflow stays far below the bounds of a step. */
  private static final double LEAST_SAFE = 0x1p-250;

  private static final double MOST_SAFE = 0x1p250;

  /** Above this the square of a radius or of a length, and its tail, do not underflow. */
  private static final double LEAST_LENGTH = 0x1p-450;

  private SideSweep() {}

  /**
   * The correctly rounded time of impact with a line that moves with the velocity u: the plain
   * quotient, refined. It is {@code +infinity} if it is later than the window's end T.
   *
   * @param side +1 if the disk is left of the line, -1 if right
   */
  static double time(
      int side, double px, double py, double r, double vx, double vy, double ax, double ay,
      double bx, double by, double ux, double uy, double T) {
    double wx = bx - ax;
    double wy = by - ay;
    double scaledRadius = r * Math.sqrt(wx * wx + wy * wy);
    double c = side * (wx * (py - ay) - wy * (px - ax));
    double speed = -side * (wx * (vy - uy) - wy * (vx - ux));
    double rough = Math.max(0, (c - scaledRadius) / speed);
    double t = refined(side, px, py, r, vx, vy, ax, ay, bx, by, ux, uy, rough, T);
    return t == T && t < Double.POSITIVE_INFINITY
        ? settled(side, px, py, r, vx, vy, ax, ay, bx, by, ux, uy, T)
        : t > T ? Double.POSITIVE_INFINITY : t;
  }

  /**
   * Refines an approximate time of impact to the correctly rounded one. {@link #step} corrects it
   * until the correction is known well enough to round. If it never is (a gap lost to
   * cancellation), exact numbers decide.
   *
   * <p>The steps are made with s, the nearest double to v - u. The gap that they see, {@code h - r
   * |w|}, is linear in the velocity, so what s lacks adds {@code side cross(w, v - u - s) t}. That
   * is below u M, the terms of {@link #stepError}. It is computed to within 6 u of itself, and the
   * step from which it cancels to within 6 u, too: 12 u^2 M, of the 14 that are left there.
   *
   * @param rough any time from 0 on; the nearer to the impact, the fewer corrections are needed
   * @param T a time certainly after this is {@code +infinity}
   */
  public static double refined(
      int side, double px, double py, double r, double vx, double vy, double ax, double ay,
      double bx, double by, double ux, double uy, double rough, double T) {
    double sx = vx - ux;
    double sy = vy - uy;
    double wx = bx - ax;
    double wy = by - ay;
    double scaledRadius = r * Math.sqrt(wx * wx + wy * wy);
    double speed = -side * (wx * sy - wy * sx);
    double lag =
        ux == 0 && uy == 0
            ? 0
            : side * (wx * differenceTail(vy, uy, sy) - wy * differenceTail(vx, ux, sx)) / speed;
    double t = rough;
    PrecisionCounter.ROOTS.add();
    for (int i = 0; i < STEPS; i++) {
      double step =
          step(side, px, py, r, sx, sy, ax, ay, bx, by, t, scaledRadius, speed) + lag * t;
      double error = stepError(px - ax, py - ay, r, sx, sy, wx, wy, scaledRadius, speed, t, step);
      double low = t + (step - error);
      if (low > Math.max(T, LEAST_SAFE)) {
        return Double.POSITIVE_INFINITY;
      }
      if (low == t + (step + error) && low > LEAST_SAFE) {
        return low;
      }
      t = Math.max(0, t + step);
    }
    return settled(side, px, py, r, vx, vy, ax, ay, bx, by, ux, uy, Double.POSITIVE_INFINITY);
  }

  private static double settled(
      int side, double px, double py, double r, double vx, double vy, double ax, double ay,
      double bx, double by, double ux, double uy, double T) {
    Fall fall = new Fall().flight(px, py, r, vx, vy, 0, 0).line(ax, ay, bx, by, ux, uy);
    return FallSweep.settled(fall, side > 0 ? Contact.LEFT : Contact.RIGHT, T);
  }

  /**
   * The correction of a time t: the remaining gap over the speed, both times |w|:
   * {@code h - r |w| = (h^2 - r^2 w.w) / (h + r |w|)}, {@code h = side cross(w, e)},
   * {@code e = d + v t}. All that cancels is kept as head and tail; one division does for two. Its
   * divisor stays within the doubles: h and r |w| are below {@link #MOST_SAFE}, the speed below
   * MOST over a time from {@link #LEAST_SAFE} on, and where it underflows, the squares have done so
   * before, to nothing left. If h is below 0, {@code h + r |w|} cancels, but {@code h - r |w|} does
   * not.
   *
   * @param scaledRadius fl(r |w|)
   */
  private static double step(
      int side, double px, double py, double r, double vx, double vy, double ax, double ay,
      double bx, double by, double t, double scaledRadius, double speed) {
    // e = d + v t
    double dx = px - ax;
    double dy = py - ay;
    double mx = vx * t;
    double my = vy * t;
    double ex = dx + mx;
    double ey = dy + my;
    double exl = sumTail(dx, mx, ex) + (differenceTail(px, ax, dx) + productTail(vx, t, mx));
    double eyl = sumTail(dy, my, ey) + (differenceTail(py, ay, dy) + productTail(vy, t, my));
    // h = side cross(w, e)
    double wx = bx - ax;
    double wy = by - ay;
    double wxl = differenceTail(bx, ax, wx);
    double wyl = differenceTail(by, ay, wy);
    double h0 = wx * ey - wy * ex;
    double h1 = crossTail(wx, wxl, wy, wyl, ex, exl, ey, eyl, h0);
    double h = side * (h0 + h1);
    if (r == 0 || h < 0) {
      return (h - scaledRadius) / speed;
    }
    double hl = sumTail(side * h0, side * h1, h);
    return gap(h, hl, wx, wxl, wy, wyl, r) / ((h + scaledRadius) * speed);
  }

  /** h^2 - r^2 w.w. */
  static double gap(
      double h, double hl, double wx, double wxl, double wy, double wyl, double r) {
    double xx = wx * wx;
    double yy = wy * wy;
    double ww = xx + yy;
    double wwl =
        sumTail(xx, yy, ww)
            + (productTail(wx, wxl, wx, wxl, xx) + productTail(wy, wyl, wy, wyl, yy));
    double rr = r * r;
    double f = rr * ww;
    double fl = productTail(rr, productTail(r, r, rr), ww, wwl, f);
    double hh = h * h;
    double residue = hh - f;
    return residue + (differenceTail(hh, f, residue) + (productTail(h, hl, h, hl, hh) - fl));
  }

  /**
   * A bound of the error of a step in time; NaN where none is known.
   *
   * <p>With {@code X = |dx| + |vx t|}, Y likewise: e loses 6 u^2 X, 6 u^2 Y in its tails; so h
   * loses D = 6 + 64 u^2 of {@code M = |wx| Y + |wy| X}. {@code h^2 - r^2 w.w} loses 2 h D and 2 x
   * 32 u^2 of h^2 <= h M, divided by {@code h + r |w|} >= h; and that sum, D itself, in proportion
   * to the quotient, which is below h: 3 D + 32 u^2 M, less than 256 u^2 M. Two errors more are
   * in proportion to the step: that of the division by {@code h + r |w|}, 6 u, or of
   * {@code h - r |w|}, 4 u, and that of the speed, 3 u of its terms and 2 more. The least that the
   * speed can be divides.
   */
  private static double stepError(
      double dx, double dy, double r, double vx, double vy, double wx, double wy,
      double scaledRadius,
      double speed, double t, double step) {
    double x = Math.abs(dx) + Math.abs(vx * t);
    double y = Math.abs(dy) + Math.abs(vy * t);
    double m = Math.abs(wx) * y + Math.abs(wy) * x;
    double lean = 16 * 0x1p-53 * (Math.abs(wx * vy) + Math.abs(wy * vx));
    double least = speed - lean;
    if (!(m > LEAST_SAFE && m < MOST_SAFE && least > LEAST_SAFE && t < MOST_SAFE
        && scaledRadius < MOST_SAFE)) {
      return Double.NaN;
    }
    if (r != 0 && !(r > LEAST_LENGTH && Math.max(Math.abs(wx), Math.abs(wy)) > LEAST_LENGTH)) {
      return Double.NaN;
    }
    return (256 * 0x1p-106 * m + Math.abs(step) * lean) / least;
  }
}
