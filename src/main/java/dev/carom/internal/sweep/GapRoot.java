// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;
import static dev.carom.internal.exact.DoubleDouble.productTail;
import static dev.carom.internal.exact.DoubleDouble.sumTail;
import static dev.carom.internal.exact.Fma.fma;

/**
 * Rounds the time at which the gap f of a falling disk falls to 0. Newton's method corrects a time
 * near the root by {@code f / f'}. There f is computed as the <i>residue</i>: in double-double,
 * since nearly all of it cancels. The rounded time is certain if f has two signs halfway to its
 * neighbouring doubles.
 *
 * <p>The error of f is bounded by the size of its terms. With sizes m0, m1, m2 of the place, the
 * speed and half the acceleration, and {@code A(t) = (m0 + m1 t + m2 t^2)^2}, the absolute values of
 * all terms of f add up to A at most, before anything cancels. So do those of {@code t f' / 4} and
 * of {@code t^2 f'' / 12}. In the bounds {@code u = 2^-53}.
 */
final class GapRoot {

  static final double NEVER = Double.POSITIVE_INFINITY;

  /** Plain doubles leave the answer open. */
  static final double DOUBT = Double.NaN;

  /** Corrections of a time in double-double. */
  static final int CORRECTIONS = 3;

  /** How near, in proportion, a time must be to one that was found before. It costs time only. */
  static final double MARGIN = 0x1p-20;

  /** The latest time. */
  private static final double LATEST = 0x1p150;

  /** Above this, half an ulp of a time is a double. */
  static final double EARLIEST = 0x1p-1000;

  /**
   * The error of {@code f + f' step}, as a part of {@code x^2 A}. Here f is the residue at a time
   * t, and the step is x t at most. The residue errs by 510 u^2. In it, an offset errs by 40 u^2 of
   * its terms, and a distance from a line by 160 u^2. A square errs by twice that; the tails and
   * the sums of squares err by less than 190 u^2. The slope errs by 13 u of {@code 4 A / t}: that
   * of a line has 7 of the height, 5 of its change and 1 of their product. The rounding of the
   * residue, and the difference and the product with the step, take 3 u more: 64 u x in all. The
   * bend adds 6 x^2, as f'' is at most 12 A / t^2, and half of it counts; higher terms are far
   * below. A step is half an ulp at least, so u is at most 2 x, and all that is
   * {@code (4 * 510 + 2 * 64 + 6) x^2} at most.
   */
  private static final double STEP_BOUND = 2560;

  /** Underflow in a residue: 64 operations, factors up to {@link #LATEST} and {@link #MOST}. */
  private static final double RESIDUE_TINY = 0x1p-600;

  private static final double MOST = 0x1p300;

  private GapRoot() {}

  /** The rounded time of a root, DOUBT unless it is near a time that was found before. */
  static double beside(double first, double time) {
    return Math.abs(time - first) <= 0.5 * MARGIN * first ? time : DOUBT;
  }

  /** A time of impact, or NEVER if it is above the window's end T; DOUBT if it is T. */
  static double upTo(double T, double time) {
    return time < T ? time : time > T ? NEVER : DOUBT;
  }

  /**
   * The double nearest to the root beside t; DOUBT if this does not tell. It is {@code n = t - f /
   * f'} if f is certain to be positive at the middle between n and its lower neighbour, and
   * negative at that with its upper one: so no error of the slope counts that does not change the
   * signs.
   *
   * @param f the residue at t, in double-double
   * @param slope f' at t
   * @param size {@code m0 + m1 t + m2 t^2}
   */
  static double nearest(double t, double f, double slope, double size) {
    double n = t - f / slope;
    double step = n - t;
    double up = 0.5 * (next(n, 1) - n);
    double down = 0.5 * (n - next(n, -1));
    double error = errorBeside(t, Math.abs(step) + up, size);
    boolean isCertain =
        f + slope * (step - down) > error && f + slope * (step + up) < -error && n > 0;
    return isCertain ? n : DOUBT;
  }

  /** The neighbour above or below a positive number; less work than {@link Math#nextDown}. */
  private static double next(double positive, int direction) {
    return Double.longBitsToDouble(Double.doubleToRawLongBits(positive) + direction);
  }

  /**
   * A bound of the error of a step {@code c = -f / f'} from t to the root, if t is the double
   * nearest to that; NaN if the slope is out of range. So near to t, f by the residue and the slope
   * errs by no more than {@link #errorBeside}, and c by that over the slope. Twice that covers the
   * rounding of c.
   */
  static double stepError(double t, double c, double slope, double size) {
    double steepness = Math.abs(slope) < Double.POSITIVE_INFINITY ? Math.abs(slope) : DOUBT;
    return 2 * errorBeside(t, Math.abs(c) + halfUlp(t), size) / steepness;
  }

  /**
   * A bound of the error of f up to a step from t, from the residue and the slope at t. Infinite if
   * numbers are out of range.
   *
   * @param step half an ulp at least
   */
  private static double errorBeside(double t, double step, double size) {
    double x = step / t;
    double scale = size * size;
    return scale < MOST && t > EARLIEST && t < LATEST
        ? fma(scale, STEP_BOUND * (x * x), RESIDUE_TINY)
        : Double.POSITIVE_INFINITY;
  }

  private static double halfUlp(double t) {
    return 0.5 * Math.ulp(t);
  }

  // The gaps. Each answer is the double nearest to the root; DOUBT if some corrections do not tell.

  /** The gap beside a line. */
  static double nearestSide(Fall f, double start) {
    double t = start;
    double nearest = DOUBT;
    for (int i = 0; i < CORRECTIONS && Double.isNaN(nearest); i++) {
      double residue = residueOfSide(f, t);
      double height = f.wx * f.y(f.ay, t) - f.wy * f.x(f.ax, t);
      double slope = 2 * height * (f.wx * f.speedY(t) - f.wy * f.speedX(t));
      double size =
          Math.abs(f.wx) * (f.r + f.sizeY(f.ay, t)) + Math.abs(f.wy) * (f.r + f.sizeX(f.ax, t));
      nearest = nearest(t, residue, slope, size);
      t -= residue / slope;
    }
    return nearest;
  }

  /** {@code h^2 - r^2 w.w} at t. */
  private static double residueOfSide(Fall f, double t) {
    double wxl = differenceTail(f.bx, f.ax, f.wx);
    double wyl = differenceTail(f.by, f.ay, f.wy);
    double x = f.x(f.ax, t);
    double y = f.y(f.ay, t);
    double h0 = f.wx * y - f.wy * x;
    double h1 = crossTail(f.wx, wxl, f.wy, wyl, x, f.xTail(f.ax, t), y, f.yTail(f.ay, t), h0);
    double h = h0 + h1;
    return SideSweep.gap(h, sumTail(h0, h1, h), f.wx, wxl, f.wy, wyl, f.r);
  }

  /** The gap of an end q of a line, or of a disk there. */
  static double nearestEnd(Fall f, double qx, double qy, double start) {
    double t = start;
    double nearest = DOUBT;
    for (int i = 0; i < CORRECTIONS && Double.isNaN(nearest); i++) {
      double residue = residueOfEnd(f, qx, qy, t);
      double slope = slopeOfEnd(f, qx, qy, t);
      nearest = nearest(t, residue, slope, f.r + f.radius + f.sizeX(qx, t) + f.sizeY(qy, t));
      t -= residue / slope;
    }
    return nearest;
  }

  static double slopeOfEnd(Fall f, double qx, double qy, double t) {
    return 2 * (f.x(qx, t) * f.speedX(t) + f.y(qy, t) * f.speedY(t));
  }

  /** {@code d.d - r^2} at t. */
  static double residueOfEnd(Fall f, double qx, double qy, double t) {
    double r = f.r + f.radius;
    double rl = sumTail(f.r, f.radius, r);
    return TimeOfImpact.gap(f.x(qx, t), f.xTail(qx, t), f.y(qy, t), f.yTail(qy, t), r, rl);
  }

  /**
   * The distance from an end q, or from the centre of a disk, that counts from the start. Over time
   * its square is {@code e.(2 d + t e)} with {@code e = s + g t / 2}.
   */
  static double nearestReturn(Fall f, double qx, double qy, double start) {
    double dx = f.px - qx;
    double dy = f.py - qy;
    double c2 = (f.sx * f.sx + f.sy * f.sy) + (dx * f.gx + dy * f.gy);
    double c3 = f.sx * f.gx + f.sy * f.gy;
    double c4 = 0.25 * (f.gx * f.gx + f.gy * f.gy);
    double d = Math.abs(dx) + Math.abs(dy);
    double s = Math.abs(f.sx) + Math.abs(f.sy);
    double g = Math.abs(f.gx) + Math.abs(f.gy);
    // (m0 + m1 t + m2 t^2)^2 exceeds the terms 2 d s, s s + d g, s g and g g / 4 one by one.
    double m0 = Math.sqrt(2 * d * s);
    double m1 = (s * s + d * g) / (2 * m0);
    double m2 = s * g / (2 * m0);
    double t = start;
    double nearest = DOUBT;
    for (int i = 0; i < CORRECTIONS && Double.isNaN(nearest); i++) {
      double residue = residueOfReturn(f, qx, qy, t);
      double slope = c2 + (2 * c3 + 3 * c4 * t) * t;
      nearest = nearest(t, residue, slope, m0 + (m1 + m2 * t) * t);
      t -= residue / slope;
    }
    return nearest;
  }

  private static double residueOfReturn(Fall f, double qx, double qy, double t) {
    double ex = Offset.mean(f.vx, f.ux, f.gx, t);
    double ey = Offset.mean(f.vy, f.uy, f.gy, t);
    double exl = Offset.meanTail(f.vx, f.ux, f.gx, t);
    double eyl = Offset.meanTail(f.vy, f.uy, f.gy, t);
    double kx = 2 * (f.px - qx) + t * ex;
    double ky = 2 * (f.py - qy) + t * ey;
    double kxl = Offset.scaledTail(2, f.px, qx, t, ex, exl);
    double kyl = Offset.scaledTail(2, f.py, qy, t, ey, eyl);
    double px = ex * kx;
    double py = ey * ky;
    double sum = px + py;
    return sum
        + (sumTail(px, py, sum)
            + (productTail(ex, exl, kx, kxl, px) + productTail(ey, eyl, ky, kyl, py)));
  }
}
