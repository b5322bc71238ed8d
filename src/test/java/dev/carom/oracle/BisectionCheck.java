// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * The second method, which checks the oracle: it solves no quadratic and takes no root to decide.
 * The distance of a moving point to a segment is convex in time; its minimum over t >= 0 is at 0,
 * at the closest approach to an end, or where the paths cross, all rational. So, exactly:
 *
 * <ul>
 *   <li>the distance falls at 0 if its minimum is below its value at 0;
 *   <li>a circle that starts apart hits if the minimum is below the radius (a point: if it is 0),
 *       and then the distance passes the radius once between 0 and the minimum, where bisection
 *       finds the time, relatively to 2^-200;
 *   <li>the feature follows from the distance at the two rational times at which the projection of
 *       the centre passes an end of the line.
 * </ul>
 *
 * <p>Two circles are a point and a segment of zero length.
 */
final class BisectionCheck {
  private static final MathContext DIGITS = new MathContext(100);
  private static final int BITS = 200;

  /** The answer: the feature, times with low < t <= high (or all equal), and a normal. */
  record Verdict(Part part, Instant low, Instant high, BigDecimal nx, BigDecimal ny) {
    static final Verdict MISS = new Verdict(Part.NONE, null, null, null, null);
  }

  private final Approach approach;
  private final Dyadic r;
  private final double end;

  private BisectionCheck(Approach approach, Dyadic r, double end) {
    this.approach = approach;
    this.r = r;
    this.end = end;
  }

  static Verdict of(SegmentQuery q) {
    Vector a = Vector.of(q.ax(), q.ay());
    Vector e = Vector.of(q.px(), q.py()).minus(a);
    Vector w = Vector.of(q.bx(), q.by()).minus(a);
    Approach approach = new Approach(e, w, Vector.of(q.vx(), q.vy()));
    return new BisectionCheck(approach, Dyadic.of(q.r()), q.end()).verdict();
  }

  static Verdict of(PairQuery q) {
    Vector e = Vector.of(q.x1(), q.y1()).minus(Vector.of(q.x2(), q.y2()));
    Vector v = Vector.of(q.vx1(), q.vy1()).minus(Vector.of(q.vx2(), q.vy2()));
    Approach approach = new Approach(e, new Vector(Dyadic.ZERO, Dyadic.ZERO), v);
    Dyadic radius = Dyadic.of(q.r1()).plus(Dyadic.of(q.r2()));
    return new BisectionCheck(approach, radius, q.end()).verdict();
  }

  private Verdict verdict() {
    Instant closest = approach.closest();
    if (compareDistance(Instant.ZERO) <= 0) {
      boolean falls = distance(closest).compareTo(distance(Instant.ZERO)) < 0;
      Part part = approach.nearest(Instant.ZERO);
      return falls ? hit(part, Instant.ZERO, Instant.ZERO, Instant.ZERO) : Verdict.MISS;
    }
    int side = compareDistance(closest);
    if (side > 0 || (side == 0 && r.signum() > 0)) {
      return Verdict.MISS;
    }
    return side == 0 ? point(closest) : bisect(closest);
  }

  private Approach.Fraction distance(Instant t) {
    return approach.squaredDistance(t);
  }

  /** The sign of distance - r at a time. */
  private int compareDistance(Instant t) {
    return distance(t).compareTo(new Approach.Fraction(r.square(), Dyadic.ONE));
  }

  /** A point meets the segment at an exact time; its normal is the one of just before. */
  private Verdict point(Instant t) {
    Instant last = Instant.ZERO;
    for (Instant passage : approach.passages(t)) {
      last = passage;
    }
    return hit(approach.nearest(t), t, t, last.between(t));
  }

  /** The distance is above r at 0 and below at the given time: halves the interval between. */
  private Verdict bisect(Instant below) {
    Dyadic m = below.m();
    Dyadic low = Dyadic.ZERO;
    Dyadic high = below.n();
    while (isWide(low, high, m)) {
      Dyadic middle = middle(low, high);
      if (compareDistance(new Instant(middle, m)) > 0) {
        low = middle;
      } else {
        high = middle;
      }
    }
    Instant after = new Instant(high, m);
    return hit(partBefore(below), new Instant(low, m), after, after);
  }

  /** Whether an interval is wide, beside its place or, as a way, beside the radius. */
  private boolean isWide(Dyadic low, Dyadic high, Dyadic m) {
    int width = high.minus(low).magnitude();
    int way = width + approach.v().squared().magnitude() / 2 + 1 - m.magnitude();
    return low.signum() == 0 || width > low.magnitude() - BITS || way > r.magnitude() - BITS / 2;
  }

  /** Half way, or half way between the exponents while these differ. */
  private static Dyadic middle(Dyadic low, Dyadic high) {
    int top = high.magnitude();
    int bottom = low.signum() == 0 ? top - 1000 : low.magnitude();
    return top - bottom > 2 ? Dyadic.powerOfTwo((top + bottom) >> 1) : low.plus(high).shift(-1);
  }

  /** The feature where the distance comes down to r, once, before the given time. */
  private Part partBefore(Instant below) {
    Instant last = Instant.ZERO;
    for (Instant passage : approach.passages(below)) {
      int side = compareDistance(passage);
      if (side <= 0) {
        return approach.nearest(side == 0 ? passage : last.between(passage));
      }
      last = passage;
    }
    return approach.nearest(last.between(below));
  }

  /** A hit if it is in the window, with the normal at a given time. */
  private Verdict hit(Part part, Instant low, Instant high, Instant direction) {
    if (!inWindow(high)) {
      return Verdict.MISS;
    }
    Vector offset = approach.offset(direction);
    BigDecimal x = offset.x().toBigDecimal(DIGITS);
    BigDecimal y = offset.y().toBigDecimal(DIGITS);
    BigDecimal length = x.multiply(x).add(y.multiply(y)).sqrt(DIGITS);
    return new Verdict(part, low, high, x.divide(length, DIGITS), y.divide(length, DIGITS));
  }

  /**
   * Whether the impact is in the window: if its upper bound is, or else if the distance at the end
   * of the window, before which it only falls, is at most r.
   */
  private boolean inWindow(Instant high) {
    if (end == Double.POSITIVE_INFINITY) {
      return Double.isFinite(high.digits(DIGITS).doubleValue());
    }
    Instant last = new Instant(Dyadic.of(end), Dyadic.ONE);
    return high.compareTo(last) <= 0 || compareDistance(last) <= 0;
  }
}
