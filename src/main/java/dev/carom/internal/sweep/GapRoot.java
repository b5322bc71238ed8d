// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.Fma.fma;

/**
 * The time at which the gap f of an accelerated disk first falls to 0. The gap is the square of a
 * distance less that of a radius, a polynomial of degree 4 in time.
 *
 * <p>The search takes the Bernstein coefficients of f on an interval. All above a bound of their
 * errors: no root. Those above it followed by those below its negative, with one in doubt between
 * them at most: exactly one root (Descartes' rule of signs). Otherwise the interval is halved;
 * after one without a root the next is twice as long.
 *
 * <p>The sizes m0, m1, m2 bound f: with {@code A(t) = (m0 + m1 t + m2 t^2)^2}, the absolute values
 * of all terms of f, before anything cancels, add up to A at most. So do those of {@code t f' / 4}
 * and of {@code t^2 f'' / 12}. In the bounds {@code u = 2^-53}.
 */
final class GapRoot {

  static final double NEVER = Double.POSITIVE_INFINITY;

  /** Plain doubles leave the answer open. */
  static final double DOUBT = Double.NaN;

  /** Intervals looked at before the search gives up. */
  private static final int INTERVALS = 64;

  /** Corrections of a time in double-double. */
  static final int CORRECTIONS = 3;

  /** Steps of Newton's method, or halvings, towards the root. More cost time only. */
  private static final int STEPS = 20;

  /**
   * After a step of this size, in proportion, Newton's method is near enough to be corrected. The
   * value costs time only: {@link #beside} refuses a time that is corrected to another root.
   */
  private static final double LAST_STEP = 0x1p-22;

  /**
   * How far, in proportion, the interval of a root must reach beyond the time that {@link #first}
   * tells. The value costs time only, as all that is taken for that root is nearer.
   */
  static final double MARGIN = 0x1p-20;

  /**
   * A Bernstein coefficient on the interval from low to high, of A(high): the coefficients of f err
   * by 10 u of their terms; the powers of low and of the width take 8 u, of which one each is the
   * rounding of the width itself; sums and products of the shift 8 u, of the conversion 8 u: 34 u
   * in all, and A is computed, too.
   */
  private static final double BERNSTEIN_BOUND = 48 * 0x1p-53;

  /** Underflow of fewer than 64 operations, times a power of high up to the fourth. */
  private static final double TINY = 0x1p-460;

  /** The latest end of an interval: its fourth power times 2^-1074 stays below {@link #TINY}. */
  static final double LATEST = 0x1p150;

  /** Above this, half an ulp of a time is a double. */
  static final double EARLIEST = 0x1p-1000;

  /** Above this, no product of a reach underflows if f is above {@link #TINY} at time 0. */
  private static final double LEAST_SAFE = 0x1p-600;

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

  /** T, or the first half of it, of that and so on, until which f rises; DOUBT if none is. */
  static double rise(
      double c1, double c2, double c3, double c4, double m0, double m1, double m2, double T) {
    double t = T <= LATEST && isFinite(0, c1, c2, c3, c4) ? T : DOUBT;
    for (int i = 0; i < INTERVALS && c1 > 0; i++) {
      if (rises(c1, c2, c3, c4, m0, m1, m2, t)) {
        return t;
      }
      t *= 0.5;
    }
    return DOUBT;
  }

  /**
   * The rounded time of a root if it is certain to be the one that {@link #first} found, else
   * DOUBT. Within the {@link #MARGIN} there is no other. Half of it is left for rounding.
   *
   * @param first what {@link #first} told
   * @param time the double nearest to any root, or NaN
   */
  static double beside(double first, double time) {
    return Math.abs(time - first) <= 0.5 * MARGIN * first ? time : DOUBT;
  }

  /**
   * A start from which {@link #first} finds roots just after a given time: it leaves those in doubt
   * that are within the {@link #MARGIN} of the start. Any earlier start is right, too.
   */
  static double before(double time) {
    return time * (1 - 2 * MARGIN);
  }

  /** A time of impact, or NEVER if it is above the window's end T; DOUBT if it is T. */
  static double upTo(double T, double time) {
    return time < T ? time : time > T ? NEVER : DOUBT;
  }

  /** Whether a residue at t, in double-double, is certain to be above 0. */
  static boolean isAbove(double t, double residue, double size) {
    return residue > errorBeside(t, halfUlp(t), size);
  }

  /** A bound of the error of a coefficient of f at time 0, of a given size. */
  static double error(double size) {
    return fma(BERNSTEIN_BOUND, size, TINY);
  }

  /**
   * Whether f falls from the start up to a time, at least half as fast as at the start. Its slope
   * is {@code c1 + 2 c2 t + 3 c3 t^2 + 4 c4 t^3}, where |c3| is at most 2 m1 m2, and c4 at most
   * m2^2. So the terms after c1 add up to less than {@code t bend}, in which c3 and c4 count twice.
   * A coefficient errs by less than a quarter of its {@link #error}: so does c1, by its sign, of
   * itself.
   */
  static boolean falls(double c1, double c2, double m0, double m1, double m2, double t) {
    double ofC2 = Math.max(0, c2 + error(m1 * m1 + 2 * m0 * m2));
    double bend = 2 * ofC2 + 12 * (m1 + m2 * t) * (m2 * t);
    return sign(c1, 2 * m0 * m1) < 0 && t * bend < 0.25 * -c1;
  }

  /** The sign of a coefficient of f at time 0, of a given size; 0 in doubt. */
  static int sign(double value, double size) {
    double bound = fma(BERNSTEIN_BOUND, size, TINY);
    return value > bound ? 1 : value < -bound ? -1 : 0;
  }

  /**
   * The end of the window in which f can reach 0, T at most: later {@code least t^2 > m1 t + m0}.
   *
   * @param least a size that the last term of a place, over t^2, has at least
   */
  static double reach(double m0, double m1, double least, double T) {
    if ((least * T - m1) * T < m0) {
      return T;
    }
    double reach = 1.001 * ((m1 + Math.sqrt(m1 * m1 + 4 * least * m0)) / (2 * least));
    return reach < T && least > LEAST_SAFE ? reach : T;
  }

  /**
   * About the root: f has it and no other in an interval that reaches {@link #MARGIN} beyond the
   * result, and none between that and the start. NEVER if f has none up to T, DOUBT if plain
   * doubles do not tell.
   *
   * @param start a time at which f is certain to be above 0
   */
  static double first(
      double c0, double c1, double c2, double c3, double c4, double m0, double m1, double m2,
      double start, double T) {
    return search(true, c0, c1, c2, c3, c4, m0, m1, m2, start, T);
  }

  /**
   * The search for the first root.
   *
   * @param root whether to return the root, or else a time after it, up to which there is no other
   */
  private static double search(
      boolean root, double c0, double c1, double c2, double c3, double c4, double m0, double m1,
      double m2, double start, double T) {
    if (!(T <= LATEST && isFinite(c0, c1, c2, c3, c4))) {
      return DOUBT;
    }
    double low = start;
    double width = T - start;
    for (int i = 0; i < INTERVALS && low < T; i++) {
      double high = Math.min(low + width, T);
      double w = high - low;
      double m = m0 + (m1 + m2 * high) * high;
      double bound = fma(BERNSTEIN_BOUND, m * m, TINY);
      // f(low + w x) = a0 + a1 x + ... + a4 x^4
      double s = c3 + c4 * low;
      double s2 = s + c4 * low;
      double q = c2 + s * low;
      double q2 = q + s2 * low;
      double l = c1 + q * low;
      double a0 = c0 + l * low;
      double a1 = (l + q2 * low) * w;
      double a2 = (q2 + (s2 + c4 * low) * low) * (w * w);
      double a3 = (s2 + 2 * c4 * low) * w * (w * w); // the cube of w may underflow
      double a4 = c4 * (w * w) * (w * w);
      double b1 = a0 + 0.25 * a1;
      double b2 = a0 + 0.5 * a1 + a2 / 6;
      double b3 = a0 + 0.75 * a1 + 0.5 * a2 + 0.25 * a3;
      double b4 = a0 + a1 + a2 + a3 + a4;
      if (b1 > bound && b2 > bound && b3 > bound && b4 > bound) {
        low = high;
        width = 2 * w;
      } else if (isOneRoot(b1, b2, b3, b4, bound)) {
        if (!root) {
          return high;
        }
        double ofQuadratic = 2 * a0 / (Math.sqrt(a1 * a1 - 4 * a0 * a2) - a1);
        double part = ofQuadratic > 0 && ofQuadratic < 1 ? ofQuadratic : a0 / (a0 - b4);
        double t = root(c0, c1, c2, c3, c4, low, high, low + w * part);
        return t - MARGIN * t > low && t + MARGIN * t < high ? t : DOUBT;
      } else {
        double largest =
            Math.max(Math.max(Math.abs(b1), Math.abs(b2)), Math.max(Math.abs(b3), Math.abs(b4)));
        if (!(largest > 4 * bound)) {
          return DOUBT;
        }
        width = 0.5 * w;
      }
    }
    return low < T ? DOUBT : NEVER;
  }

  /**
   * The root at which f next falls to 0 after a start: {@link #first} if f is above 0 there, else
   * that after f has come above 0.
   *
   * @param sign the sign of f at the start, and up to half an ulp after it; 0 in doubt
   */
  static double nextFall(
      int sign, double c0, double c1, double c2, double c3, double c4, double m0, double m1,
      double m2, double start, double T) {
    if (sign == 0) {
      return DOUBT;
    }
    double from = sign > 0 ? start : comesOut(c0, c1, c2, c3, c4, m0, m1, m2, start, T);
    return from < NEVER ? first(c0, c1, c2, c3, c4, m0, m1, m2, from, T) : from;
  }

  /**
   * A time just after the root at which f, below 0 at time 0, first comes above 0. NEVER if f stays
   * below 0 up to T, DOUBT if plain doubles do not tell.
   */
  static double exit(
      double c0, double c1, double c2, double c3, double c4, double m0, double m1, double m2,
      double T) {
    double t = first(-c0, -c1, -c2, -c3, -c4, m0, m1, m2, 0, T);
    double out = t + MARGIN * t;
    boolean isOut = t < NEVER && sign(c0, c1, c2, c3, c4, m0, m1, m2, out) > 0;
    return isOut ? out : t < NEVER ? DOUBT : t;
  }

  /**
   * A time at which f is certain to be above 0, with one root between it and a start at which f is
   * below 0. NEVER if f stays below 0 up to T, DOUBT if plain doubles do not tell.
   */
  static double comesOut(
      double c0, double c1, double c2, double c3, double c4, double m0, double m1, double m2,
      double start, double T) {
    return search(false, -c0, -c1, -c2, -c3, -c4, m0, m1, m2, start, T);
  }

  /**
   * The sign of f at a time and up to half an ulp beside it; 0 in doubt. The coefficients err by 10
   * u, the sums and products here by 8 u, and half an ulp of time changes f by 4 u: less than
   * {@link #BERNSTEIN_BOUND}.
   */
  static int sign(
      double c0, double c1, double c2, double c3, double c4, double m0, double m1, double m2,
      double t) {
    double m = m0 + (m1 + m2 * t) * t;
    boolean isSafe = t <= LATEST && isFinite(c0, c1, c2, c3, c4);
    return isSafe ? sign(c0 + (c1 + (c2 + (c3 + c4 * t) * t) * t) * t, m * m) : 0;
  }

  /**
   * The sign of f half an ulp after t; 0 in doubt.
   *
   * @param f the residue at t, in double-double
   * @param slope f' at t
   * @param size {@code m0 + m1 t + m2 t^2}
   */
  static int signAfter(double t, double f, double slope, double size) {
    double up = halfUlp(t);
    double value = f + slope * up;
    return Math.abs(value) > errorBeside(t, up, size) ? UnitVectors.sign(value) : 0;
  }

  /**
   * Whether f rises from 0 up to t: all Bernstein coefficients of f' are above a bound. Their terms
   * add up to A' = 2 (m0 + m1 t + m2 t^2) (m1 + 2 m2 t) at most.
   */
  static boolean rises(
      double c1, double c2, double c3, double c4, double m0, double m1, double m2, double t) {
    double m = m0 + (m1 + m2 * t) * t;
    double bound = fma(BERNSTEIN_BOUND, 2 * m * (m1 + 2 * m2 * t), TINY);
    double d1 = c1 + 2 * c2 / 3 * t;
    double d2 = c1 + (4 * c2 / 3 + c3 * t) * t;
    double d3 = c1 + (2 * c2 + (3 * c3 + 4 * c4 * t) * t) * t;
    return c1 > bound && d1 > bound && d2 > bound && d3 > bound;
  }

  /**
   * A time until which f rises from the start, and at which it is above 0. NEVER if it rises up to
   * T and is not certain to come above 0, DOUBT if plain doubles do not tell.
   */
  static double leaves(
      double c0, double c1, double c2, double c3, double c4, double m0, double m1, double m2,
      double T) {
    double t = rise(c1, c2, c3, c4, m0, m1, m2, T);
    if (Double.isNaN(t) || !isFinite(c0, c1, c2, c3, c4)) {
      return DOUBT;
    }
    return sign(c0, c1, c2, c3, c4, m0, m1, m2, t) > 0 ? t : t == T ? NEVER : DOUBT;
  }

  /** Whether no coefficient has overflowed, nor does a small multiple. */
  private static boolean isFinite(double c0, double c1, double c2, double c3, double c4) {
    double sum = Math.abs(c0) + Math.abs(c1) + Math.abs(c2) + Math.abs(c3) + Math.abs(c4);
    return sum < 0x1p1000;
  }

  /** Whether the signs change once, whatever one of them is; the first one, of a0, is positive. */
  private static boolean isOneRoot(double b1, double b2, double b3, double b4, double bound) {
    if (!(b4 < -bound)) {
      return false;
    }
    if (b3 < -bound) {
      return b2 < -bound || b1 > bound;
    }
    return b1 > bound && b2 > bound;
  }

  /** The root between low and high, where the sign changes from + to -, by safeguarded Newton. */
  private static double root(
      double c0, double c1, double c2, double c3, double c4, double low, double high,
      double start) {
    double before = low;
    double after = high;
    double t = start;
    for (int i = 0; i < STEPS; i++) {
      double f = fma(fma(fma(fma(c4, t, c3), t, c2), t, c1), t, c0);
      double slope = fma(fma(fma(4 * c4, t, 3 * c3), t, 2 * c2), t, c1);
      if (f > 0) {
        before = t;
      } else {
        after = t;
      }
      double next = t - f / slope;
      if (Math.abs(next - t) <= LAST_STEP * t) {
        return next;
      }
      t = next > before && next < after ? next : 0.5 * (before + after);
    }
    return t;
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
}
