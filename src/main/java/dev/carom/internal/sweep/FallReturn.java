// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import static dev.carom.internal.exact.DoubleDouble.crossTail;
import static dev.carom.internal.exact.DoubleDouble.differenceTail;

import dev.carom.internal.exact.ExactParabola;
import dev.carom.internal.exact.ExactReturn;
import dev.carom.internal.exact.GapPolynomial;
import dev.carom.internal.exact.Gaps;
import dev.carom.internal.exact.Polynomial;
import dev.carom.internal.exact.PrecisionCounter;
import dev.carom.internal.exact.Predicates;
import dev.carom.internal.exact.RealRoot;

/**
 * When a disk with a constant acceleration comes back to the obstacle that it has just hit.
 *
 * <p>At the start the disk touches the obstacle by definition, but its rounded place may be some
 * ulps beside. So its gap counts from the start: the value there is subtracted, and the root at
 * time 0 is divided out, both exactly. A negative speed along the normal counts as 0: it is a
 * rounding error of the response. Without a speed the acceleration decides. If it points to the
 * obstacle, the disk is supported, and the answer is 0. Otherwise the disk leaves.
 *
 * <p>A line has three parts, its side and its ends. The disk touches the part in whose region its
 * centre is at the start, and the gap of this part counts from there. Those of the others are what
 * the given numbers say. So the disk comes back
 *
 * <ul>
 *   <li>from the side: when its height above the line is again that at the start, if its centre is
 *       beside the line then; otherwise at the first impact from then on with the end that it has
 *       passed. Until then it is above the line and its ends.
 *   <li>from an end: when its distance from this end is again that at the start while its centre is
 *       beyond it; or at an impact with the side, or with the other end; whichever is first.
 * </ul>
 */
public final class FallReturn {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static final double LEAST_SAFE = 0x1p-400;

  private static final double MOST_SAFE = 0x1p400;

  private FallReturn() {}

  /**
   * The correctly rounded time of the return to a wall, {@code -2 v / g}; {@code +infinity} for
   * none up to the window's end T.
   *
   * @param inward +1 if the disk is above the wall, -1 if below
   */
  public static double toWall(double v, double g, int inward, double T) {
    if (!(inward * g < 0)) {
      return NEVER;
    }
    if (!(inward * v > 0)) {
      return 0;
    }
    double t = 2 * v / -g;
    // A rounded time of T itself may be that of a later one.
    if (t > LEAST_SAFE && t < MOST_SAFE && t != T) {
      return t < T ? t : NEVER;
    }
    double speed = inward * v;
    double pull = inward * g;
    double time = GapPolynomial.EXACT.motion(0, 0, speed, 0, pull).overTime().fallOfConvex(T);
    return Double.isNaN(time)
        ? ExactParabola.ofGap(Polynomial.EXACT.motion(0, 0, speed, 0, pull)).time(T)
        : time;
  }

  /**
   * The correctly rounded time of the next hit on a line or a disk that is touched at the start;
   * {@code +infinity} for none up to the window's end T.
   *
   * <p>Of a disk, or an end of a line, it is the first time at which the distance falls below that
   * at the start. The acceleration along the normal has a part by the curvature: its sign is that
   * of {@code s.s + d.g}.
   */
  public static double time(Fall f, double T) {
    if (f.turns()) {
      return TurningSweep.timeOfReturn(f, T);
    }
    if (f.isStraight()) {
      return NEVER;
    }
    PrecisionCounter.PARABOLAS.add();
    int region = region(f);
    double time = region == Gaps.BESIDE ? fromSide(f, T) : toEnd(f, region, T);
    return Double.isNaN(time) ? exact(f).time(T) : time;
  }

  /** The question in algebraic numbers. */
  static ExactReturn exact(Fall f) {
    int region = region(f);
    int side = region == Gaps.BESIDE ? side(f) : 0;
    return new ExactReturn(f.gaps(Polynomial.EXACT), f.isLine, region, side);
  }

  /** The region in which the disk touches the obstacle. */
  static int region(Fall f) {
    if (!f.isLine || Predicates.dot(f.px, f.py, f.ax, f.ay, f.bx, f.by, f.ax, f.ay) <= 0) {
      return Gaps.BEFORE;
    }
    return Predicates.dot(f.px, f.py, f.bx, f.by, f.bx, f.by, f.ax, f.ay) >= 0
        ? Gaps.BEYOND
        : Gaps.BESIDE;
  }

  private static double toEnd(Fall f, int region, double T) {
    double end = FallSweep.windowEnd(f, T);
    double time = (f.isLine ? f.end(region) : f).filter.timeOfReturn(end);
    boolean isOne = !f.isLine || f.filter.staysBeside(region == Gaps.BEYOND, Math.min(time, end));
    time = isOne ? time : GapRoot.DOUBT;
    return Double.isNaN(time) ? FallSweep.searched(f, GapSearch.RETURN, region, T) : time;
  }

  private static double fromSide(Fall f, double T) {
    int side = side(f);
    double back = toSide(f, side, T);
    if (back == 0 || back == NEVER) {
      return back;
    }
    int region = f.region(back);
    if (region == Gaps.BESIDE || region == Gaps.UNKNOWN) {
      return region == Gaps.BESIDE || isAtEnd(f, side, back) ? back : GapRoot.DOUBT;
    }
    Fall end = f.end(region);
    double time = end.filter.time(back, FallSweep.windowEnd(end, T));
    if (!(time > back)) {
      double start = Fall.LESS * back;
      time = FallSweep.searched(end, GapSearch.FIRST_AFTER, start, T);
    }
    return time > back ? time : GapRoot.DOUBT;
  }

  /** Whether a disk that is back at its height above a side, at t, is exactly at an end of it. */
  static boolean isAtEnd(Fall f, int side, double t) {
    Gaps<GapPolynomial> gaps = f.gaps(GapPolynomial.EXACT);
    boolean isAtEnd = gaps.fromStart().signAt(t, 0) == 0 || gaps.fromEnd().signAt(t, 0) == 0;
    return isAtEnd && rise(f, side).fallsAt(t);
  }

  /** The height above that at the start, times the length of the line. */
  private static GapPolynomial rise(Fall f, int side) {
    Gaps<GapPolynomial> gaps = f.gaps(GapPolynomial.EXACT);
    return gaps.aboveStart(gaps.height().signed(side), GapPolynomial::constant).counted();
  }

  /**
   * The correctly rounded time of the return to the height above the infinite line at which the
   * disk starts, {@code -2 w x s / w x g}; {@code +infinity} for none up to the window's end T. The
   * centre may then be beyond an end.
   *
   * @param side +1 if the disk is left of the line, -1 if right
   */
  static double toSide(Fall f, int side, double T) {
    if (side * Predicates.cross(f.bx, f.by, f.ax, f.ay, f.gx, f.gy, 0, 0) >= 0) {
      return NEVER;
    }
    if (side * Predicates.cross(f.bx, f.by, f.ax, f.ay, f.vx, f.vy, f.ux, f.uy) <= 0) {
      return 0;
    }
    double quick = GapRoot.upTo(T, quickly(f, side));
    if (!Double.isNaN(quick)) {
      return quick;
    }
    double time = rise(f, side).overTime().fallOfConvex(T);
    return Double.isNaN(time)
        ? ExactParabola.ofGap(f.gaps(Polynomial.EXACT).height().signed(side).fromStart()).time(T)
        : time;
  }

  /** The same for ever, in double-double: the root of {@code w x (s + g t / 2)}; NaN in doubt. */
  private static double quickly(Fall f, int side) {
    double slope = 0.5 * (f.wx * f.gy - f.wy * f.gx);
    double t = -(f.wx * f.sy - f.wy * f.sx) / slope;
    double x = Offset.mean(f.vx, f.ux, f.gx, t);
    double y = Offset.mean(f.vy, f.uy, f.gy, t);
    double xl = Offset.meanTail(f.vx, f.ux, f.gx, t);
    double yl = Offset.meanTail(f.vy, f.uy, f.gy, t);
    double wxl = differenceTail(f.bx, f.ax, f.wx);
    double wyl = differenceTail(f.by, f.ay, f.wy);
    double rise = f.wx * y - f.wy * x;
    double tail = crossTail(f.wx, wxl, f.wy, wyl, x, xl, y, yl, rise);
    double terms =
        Math.abs(f.wx) * Offset.size(f.sy, 0.5 * f.gy, 0, t)
            + Math.abs(f.wy) * Offset.size(f.sx, 0.5 * f.gx, 0, t);
    return GapRoot.nearest(t, side * (rise + tail), side * slope, Math.sqrt(terms));
  }

  /**
   * The side of the line that a disk touches at the start: by its place. That of a point, or of a
   * centre on the line, is the one to which it leaves; without a speed the acceleration pulls it
   * off.
   */
  static int side(Fall f) {
    int place = Predicates.cross(f.bx, f.by, f.ax, f.ay, f.px, f.py, f.ax, f.ay);
    if (f.r > 0 && place != 0) {
      return place;
    }
    if (f.turns()) {
      return TurningSweep.leavesTo(f, place);
    }
    int speed = Predicates.cross(f.bx, f.by, f.ax, f.ay, f.vx, f.vy, f.ux, f.uy);
    if (speed != 0 || place != 0) {
      return speed != 0 ? speed : place;
    }
    return Predicates.cross(f.bx, f.by, f.ax, f.ay, f.gx, f.gy, 0, 0);
  }

  /**
   * The {@link Contact} of the next hit on a line that the disk touches at the start.
   *
   * @param t its time, from {@link #time}
   */
  public static int contact(Fall f, double t) {
    int now = t == 0 ? Contact.NOW : 0;
    if (!f.isLine) {
      return Contact.START | now;
    }
    int from = region(f);
    int side = from != Gaps.BESIDE ? f.side(t) : f.turns() ? TurningSweep.side(f, t) : side(f);
    int region = f.region(t);
    if (region == Gaps.UNKNOWN) {
      GapSearch search = f.search().exactly();
      region =
          from == Gaps.BESIDE
              ? search.regionAt(t, rise(f, side(f)))
              : search.from(from).regionAt(t);
    }
    int contact = FallSweep.contact(region, side);
    if (contact == Contact.DOUBT) {
      ExactReturn exact = exact(f);
      RealRoot root = exact.first(Math.nextUp(t));
      contact = FallSweep.contact(exact.region(root), exact.side(root));
    }
    return contact | now;
  }
}
