// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/**
 * The contract of contact with a thing that turns, taken literally. Seen from the thing, which then
 * rests, the centre is at {@code (X, Y) / n}: {@code X + i Y} is its place from the pivot times the
 * conjugate of c^2, and n is |c|^2. So {@code n^2} times the square of a distance is a polynomial;
 * the distance falls where {@code f' n - 2 f n'} of that polynomial f is below 0.
 *
 * <p>What was just hit counts from the start: the gap of the part in whose region the centre is, or
 * the height above the side. A speed towards it counts as none. From the side the circle comes back
 * when it is as high as at the start, if it is then between the ends or exactly at one. Else every
 * part can be hit from then on.
 *
 * <p>A point hits a side where it passes to the other one, and an end where the distance falls to 0
 * with a speed.
 */
final class TurningOracle {
  private static final int BITS = 160;
  private static final int BITS_OF_A_POINT = 320;

  /** The gap of a part, and its rate, each times a positive number. */
  private record Region(Part part, SturmPolynomial gap, SturmPolynomial rate) {}

  private final TurningQuery q;
  private final SturmPolynomial re;
  private final SturmPolynomial im;
  private final SturmPolynomial n;
  private final SturmPolynomial x;
  private final SturmPolynomial y;
  private final Vector w;
  private final Dyadic r;
  private final SturmPolynomial height;
  private final SturmPolynomial fromStart;
  private final SturmPolynomial fromEnd;
  private final List<Region> regions = new ArrayList<>();

  private TurningOracle(TurningQuery q) {
    this.q = q;
    SturmPolynomial c1 = new SturmPolynomial(Dyadic.ONE, Dyadic.of(q.q1()));
    SturmPolynomial c2 = new SturmPolynomial(Dyadic.ZERO, Dyadic.of(q.q2()));
    re = c1.times(c1).plus(c2.times(c2).negate());
    im = c1.times(c2).times(Dyadic.of(2));
    n = ParabolaOracle.squared(c1, c2);
    SturmPolynomial dx = place(q.px(), q.pivotX(), q.vx(), q.gx());
    SturmPolynomial dy = place(q.py(), q.pivotY(), q.vy(), q.gy());
    x = dx.times(re).plus(dy.times(im));
    y = dy.times(re).plus(dx.times(im).negate());
    w = end(Part.END).minus(end(Part.START));
    r = Dyadic.of(q.r()).plus(Dyadic.of(q.radius()));
    SturmPolynomial startX = offsetX(Part.START);
    SturmPolynomial startY = offsetY(Part.START);
    height = startY.times(w.x()).plus(startX.times(w.y()).negate());
    fromStart = startX.times(w.x()).plus(startY.times(w.y()));
    fromEnd = offsetX(Part.END).times(w.x()).plus(offsetY(Part.END).times(w.y()));
    if (w.isZero()) {
      add(Part.CIRCLE);
    } else {
      add(Part.START);
      add(Part.SIDE);
      add(Part.END);
    }
  }

  private static SturmPolynomial place(double p, double pivot, double v, double g) {
    Dyadic from = Dyadic.of(p).minus(Dyadic.of(pivot));
    return new SturmPolynomial(from, Dyadic.of(v), Dyadic.of(g).shift(-1));
  }

  /** The end of a part, seen from the pivot. */
  private Vector end(Part part) {
    Vector pivot = Vector.of(q.pivotX(), q.pivotY());
    return (part == Part.END ? Vector.of(q.bx(), q.by()) : Vector.of(q.ax(), q.ay())).minus(pivot);
  }

  private SturmPolynomial offsetX(Part part) {
    return x.plus(n.times(end(part).x().negate()));
  }

  private SturmPolynomial offsetY(Part part) {
    return y.plus(n.times(end(part).y().negate()));
  }

  private void add(Part part) {
    SturmPolynomial square =
        part == Part.SIDE
            ? height.times(height)
            : ParabolaOracle.squared(offsetX(part), offsetY(part));
    Dyadic reach = r.square().times(part == Part.SIDE ? w.squared() : Dyadic.ONE);
    SturmPolynomial gap = square.plus(n.times(n).times(reach.negate()));
    regions.add(region(part, gap, 2));
  }

  /** A gap times n^k. */
  private Region region(Part part, SturmPolynomial gap, int k) {
    SturmPolynomial growth = gap.times(n.derivative()).times(Dyadic.of(-k));
    return new Region(part, gap, gap.derivative().times(n).plus(growth));
  }

  static ParabolaContact answer(TurningQuery query) {
    TurningOracle oracle = new TurningOracle(query);
    ParabolaContact contact =
        switch (query.kind()) {
          case FIRST -> oracle.firstFrom(null);
          case RETURN -> oracle.back();
          case ENTRY -> oracle.entry(query.after());
        };
    return ParabolaOracle.within(contact, query.end());
  }

  private boolean isPoint() {
    return r.signum() == 0;
  }

  /** The first contact from a moment on; null is the start. */
  private ParabolaContact firstFrom(SturmRoot from) {
    Predicate<SturmRoot> counts = isPoint() ? this::arrives : this::falls;
    boolean isNow = isPoint() ? from != null && arrives(from) : falls(from);
    return isNow
        ? contact(from)
        : first(event -> counts.test(event) && (from == null || from.isBefore(event)));
  }

  private ParabolaContact entry(double after) {
    return first(event -> (isPoint() ? arrives(event) : enters(event)) && event.nearest() > after);
  }

  // What was just hit.

  private ParabolaContact back() {
    Part part = part(null);
    return part == Part.SIDE ? backToSide() : backToEnd(part);
  }

  private ParabolaContact backToSide() {
    int side = side();
    if (side == 0) {
      return ParabolaContact.MISS;
    }
    SturmPolynomial rise = height.times(Dyadic.of(side));
    SturmPolynomial level = n.times(rise.value(Dyadic.ZERO).negate());
    Region above = region(Part.SIDE, rise.plus(level).fromZero(), 1);
    ParabolaContact back = firstOf(above);
    if (!back.hit()) {
      return back;
    }
    boolean isBeside = sign(fromStart, back.moment()) >= 0 && sign(fromEnd, back.moment()) <= 0;
    if (!isBeside) {
      return firstFrom(back.moment());
    }
    Part part = part(back.moment());
    return new ParabolaContact(part, back.moment(), ofSide(side, back.moment()));
  }

  /** The side that is touched: of a point, or a centre on the line, the one to which it leaves. */
  private int side() {
    int place = sign(height, null);
    SturmPolynomial rise = height.plus(n.times(height.value(Dyadic.ZERO).negate()));
    int speed = sign(rise.derivative(), null);
    int leaving = speed != 0 ? speed : ParabolaOracle.after(rise, null);
    return isPoint() && speed != 0 ? speed : place != 0 ? place : leaving;
  }

  private ParabolaContact backToEnd(Part part) {
    int number = regions.size() == 1 || part == Part.START ? 0 : 2;
    SturmPolynomial square = ParabolaOracle.squared(offsetX(part), offsetY(part));
    SturmPolynomial gap = square.plus(n.times(n).times(square.value(Dyadic.ZERO).negate()));
    Dyadic speed = gap.derivative().value(Dyadic.ZERO);
    if (speed.signum() < 0) {
      gap = gap.plus(n.times(new SturmPolynomial(Dyadic.ZERO, speed.negate())));
    }
    Region counted = region(part, gap, 2);
    ParabolaContact back = firstOf(counted);
    if (regions.size() == 1 || (back.hit() && back.moment() == null)) {
      return back.hit() ? contact(back.moment()) : back;
    }
    ParabolaContact other =
        isPoint() ? first(event -> arrives(event) && part(event) != part) : ParabolaContact.MISS;
    regions.set(number, counted);
    ParabolaContact next = falls(null) ? contact(null) : first(this::falls);
    return ParabolaOracle.isSooner(other, next) ? other : next;
  }

  /** The first moment just after which one gap is not above 0 and falls. */
  private static ParabolaContact firstOf(Region region) {
    return ParabolaOracle.firstFall(region.gap(), region.rate(), region.part(), null);
  }

  // Moments.

  private ParabolaContact first(Predicate<SturmRoot> condition) {
    SturmRoot first = null;
    for (SturmRoot event : events()) {
      boolean isLate = first != null && event.isClearlyAfter(first);
      boolean isTooLate = event.narrow(3).low().near() > q.end();
      if (!isLate
          && !isTooLate
          && condition.test(event)
          && (first == null || event.isBefore(first))) {
        first = event;
      }
    }
    return first == null ? ParabolaContact.MISS : contact(first);
  }

  private List<SturmRoot> events() {
    List<SturmRoot> events = new ArrayList<>();
    for (Region region : regions) {
      events.addAll(region.gap().positiveRoots());
      if (!isPoint() || q.kind() == TurningQuery.Kind.RETURN) {
        events.addAll(region.rate().positiveRoots());
      }
    }
    if (isPoint()) {
      events.addAll(height.positiveRoots());
    }
    events.addAll(fromStart.positiveRoots());
    events.addAll(fromEnd.positiveRoots());
    events.sort(Comparator.comparing(event -> event.narrow(3).low()));
    return events;
  }

  private boolean falls(SturmRoot moment) {
    Region region = region(after(fromStart, moment), after(fromEnd, moment));
    return after(region.gap(), moment) < 0 && after(region.rate(), moment) < 0;
  }

  private boolean enters(SturmRoot moment) {
    Region last = region(before(fromStart, moment), before(fromEnd, moment));
    Region next = region(after(fromStart, moment), after(fromEnd, moment));
    return before(last.gap(), moment) > 0 && after(next.gap(), moment) < 0;
  }

  /** Whether a point comes to a side that it passes, or with a speed to an end. */
  private boolean arrives(SturmRoot moment) {
    Part part = part(moment);
    if (part == Part.SIDE) {
      return sign(height, moment) == 0 && before(height, moment) * after(height, moment) < 0;
    }
    SturmPolynomial dx = offsetX(part);
    SturmPolynomial dy = offsetY(part);
    boolean isThere = sign(dx, moment) == 0 && sign(dy, moment) == 0;
    return isThere && (sign(dx.derivative(), moment) != 0 || sign(dy.derivative(), moment) != 0);
  }

  private Part part(SturmRoot moment) {
    return region(sign(fromStart, moment), sign(fromEnd, moment)).part();
  }

  private Region region(int start, int end) {
    return regions.size() == 1 || start <= 0 ? regions.get(0) : regions.get(end >= 0 ? 2 : 1);
  }

  private static int sign(SturmPolynomial f, SturmRoot moment) {
    return ParabolaOracle.sign(f, moment);
  }

  private static int after(SturmPolynomial f, SturmRoot moment) {
    return ParabolaOracle.after(f, moment);
  }

  private static int before(SturmPolynomial f, SturmRoot moment) {
    return ParabolaOracle.before(f, moment);
  }

  // The contact.

  private ParabolaContact contact(SturmRoot moment) {
    Part part = part(moment);
    return new ParabolaContact(part, moment, normal(part, moment));
  }

  private Normal normal(Part part, SturmRoot moment) {
    int side = moment == null ? after(height, null) : before(height, moment);
    if (part == Part.SIDE) {
      return ofSide(side, moment);
    }
    SturmPolynomial dx = offsetX(part);
    SturmPolynomial dy = offsetY(part);
    if (isPoint()) {
      boolean isBeside =
          regions.size() > 1
              && moment != null
              && region(before(fromStart, moment), before(fromEnd, moment)).part() == Part.SIDE;
      return isBeside
          ? ofSide(side, moment)
          : turned(dx.derivative().negate(), dy.derivative().negate(), moment);
    }
    return turned(dx, dy, moment);
  }

  private Normal ofSide(int side, SturmRoot moment) {
    return turned(
        ParabolaOracle.constant(w.y().times(Dyadic.of(-side))),
        ParabolaOracle.constant(w.x().times(Dyadic.of(side))),
        moment);
  }

  /** The direction of a vector of the thing at a moment. */
  private Normal turned(SturmPolynomial vx, SturmPolynomial vy, SturmRoot moment) {
    Dyadic t = moment == null ? Dyadic.ZERO : moment.narrow(bits(moment)).low();
    Vector c = new Vector(re.value(t), im.value(t));
    Vector v = new Vector(vx.value(t), vy.value(t));
    Vector world =
        new Vector(
            v.x().times(c.x()).minus(v.y().times(c.y())),
            v.x().times(c.y()).plus(v.y().times(c.x())));
    return world.isZero() ? new Normal(Dyadic.ZERO, Dyadic.ZERO) : Normal.along(world);
  }

  private int bits(SturmRoot moment) {
    Dyadic terms = x.terms(moment.high()).plus(y.terms(moment.high()));
    return isPoint() ? BITS_OF_A_POINT : BITS + Math.max(0, terms.magnitude() - r.magnitude());
  }
}
