// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/**
 * The next contact of a circle with a constant acceleration with a thing that it touches at the
 * start, whatever its rounded place says. The gap of the part that it touches, the one in whose
 * region it is, counts from the start, and a speed towards it counts as none. The other parts of a
 * line have their true gaps.
 *
 * <p>From the side it comes back to the height that it had, if it is then between the ends of the
 * line or exactly at one. Else it can hit the end that it has passed from then on.
 */
final class ParabolaReturnOracle {
  private ParabolaReturnOracle() {}

  static ParabolaContact answer(ParabolaQuery query) {
    if (query.gx() == 0 && query.gy() == 0) {
      return ParabolaContact.MISS;
    }
    ParabolaOracle oracle = ParabolaOracle.of(query);
    Part part = oracle.part(null);
    ParabolaContact next = part == Part.SIDE ? fromSide(oracle) : fromEnd(oracle, part);
    return ParabolaOracle.within(next, query.end());
  }

  /** From a disk, or an end of a line. */
  private static ParabolaContact fromEnd(ParabolaOracle oracle, Part part) {
    boolean isLine = oracle.wx.signum() != 0 || oracle.wy.signum() != 0;
    SturmPolynomial gap = oracle.gap(part).fromZero();
    ParabolaContact back = ParabolaOracle.firstFall(gap, part, null);
    if (!isLine || (back.hit() && back.moment() == null)) {
      return back;
    }
    ParabolaContact other =
        oracle.r.signum() == 0 ? oracle.firstOfPoint(part) : ParabolaContact.MISS;
    oracle.setGap(part, gap);
    ParabolaContact next = oracle.firstOfDisk();
    return ParabolaOracle.isSooner(other, next) ? other : next;
  }

  private static ParabolaContact fromSide(ParabolaOracle oracle) {
    SturmPolynomial height = oracle.y.times(oracle.wx).plus(oracle.x.times(oracle.wy).negate());
    int side = side(height, oracle.r.signum() == 0);
    if (side == 0) {
      return ParabolaContact.MISS;
    }
    Vector left = new Vector(oracle.wy.negate(), oracle.wx);
    Normal normal = Normal.along(left.times(Dyadic.of(side)));
    SturmPolynomial rise = height.times(Dyadic.of(side)).fromZero();
    ParabolaContact back = ParabolaOracle.firstFall(rise, Part.SIDE, normal);
    if (!back.hit()) {
      return back;
    }
    int start = ParabolaOracle.sign(oracle.alongStart, back.moment());
    int end = ParabolaOracle.sign(oracle.alongEnd, back.moment());
    Part part = oracle.part(back.moment());
    if (start >= 0 && end <= 0) {
      return new ParabolaContact(part, back.moment(), normal);
    }
    SturmRoot first = firstFrom(back.moment(), oracle.gap(part), oracle.r.signum() == 0);
    return first == null
        ? ParabolaContact.MISS
        : new ParabolaContact(oracle.part(first), first, normal);
  }

  /** The side that is touched: of a point, or a centre on the line, the one to which it leaves. */
  private static int side(SturmPolynomial height, boolean isPoint) {
    int place = ParabolaOracle.sign(height, null);
    int speed = ParabolaOracle.sign(height.derivative(), null);
    int leaving = speed != 0 ? speed : ParabolaOracle.after(height.derivative(), null);
    return isPoint && speed != 0 ? speed : place != 0 ? place : leaving;
  }

  /** The first moment from a given one on at which the gap of a disk is not above 0 and falls. */
  private static SturmRoot firstFrom(SturmRoot from, SturmPolynomial gap, boolean isPoint) {
    SturmRoot first = meets(gap, from, isPoint) ? from : null;
    for (SturmPolynomial f : new SturmPolynomial[] {gap, gap.derivative()}) {
      for (SturmRoot event : f.positiveRoots()) {
        boolean sooner = first == null || event.isBefore(first);
        if (sooner && !event.isBefore(from) && meets(gap, event, isPoint)) {
          first = event;
        }
      }
    }
    return first;
  }

  private static boolean meets(SturmPolynomial gap, SturmRoot moment, boolean isPoint) {
    SturmPolynomial slope = gap.derivative();
    return isPoint
        ? ParabolaOracle.sign(gap, moment) == 0
            && ParabolaOracle.sign(slope.derivative(), moment) != 0
        : ParabolaOracle.after(gap, moment) < 0 && ParabolaOracle.after(slope, moment) < 0;
  }
}
