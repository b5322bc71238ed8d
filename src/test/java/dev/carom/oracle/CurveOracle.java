// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/**
 * The contract of contact for a circle with a constant acceleration, taken literally: the first
 * moment just after which the distance is at most the radius and falls. The other thing is a disk
 * or a line that moves evenly, or turns about a pivot.
 *
 * <p>Seen from the thing, which then rests, the centre is at {@code (x, y) / n}: {@code x + i y} is
 * its place from the pivot times the conjugate of c^2, and n is |c|^2; c and n are 1 for what does
 * not turn. In each Voronoi region {@code n^2} times the square of the distance, less that of the
 * radius, is a polynomial f in time; the distance falls where {@code f' n - 2 f n'} is below 0.
 * Every moment at which something can change is an isolated root, and what holds just after it
 * follows from the signs of the derivatives there, by {@link SturmPolynomial}.
 *
 * <p>A point (radius 0) hits at the first moment at which the distance is 0 and its derivative from
 * the left is negative: a side where it passes to the other one, an end where it comes with a
 * speed.
 *
 * <p>What was just hit counts from the start, whatever the rounded place says: the gap of the part
 * in whose region the centre is, or the height above the side. A speed towards it counts as none.
 * From the side the circle comes back when it is as high as at the start, if it is then between the
 * ends or exactly at one. Else it can hit from then on the end that it has passed, and of what
 * turns every part.
 */
final class CurveOracle {
  /** Bits of the time for a normal: of a point, whose velocity may nearly vanish, many more. */
  private static final int BITS = 160;

  private static final int BITS_OF_A_POINT = 320;

  /** The gap of a part, and its rate, each times a positive number. */
  private record Region(Part part, SturmPolynomial gap, SturmPolynomial rate) {}

  private final SturmPolynomial re;
  private final SturmPolynomial im;
  private final SturmPolynomial n;
  private final SturmPolynomial x;
  private final SturmPolynomial y;
  private final Vector start;
  private final Vector w;
  private final Dyadic r;
  private final double end;
  private final SturmPolynomial height;
  private final SturmPolynomial fromStart;
  private final SturmPolynomial fromEnd;
  private final List<Region> regions = new ArrayList<>();

  /** The one part that can be hit; null for all. */
  private Region only;

  /** Whether a rate counts also for a point, as that of what was just hit does. */
  private boolean ratesCount;

  /**
   * Takes the motion of a centre from a pivot, and a line.
   *
   * @param q1,q2 the line turns as {@code 1 + (q1 + i q2) t} does
   * @param start,w the start of the line from the pivot, and the end from that
   * @param first the start as a part, or the whole disk
   * @param end of the window
   */
  private CurveOracle(
      SturmPolynomial dx,
      SturmPolynomial dy,
      double q1,
      double q2,
      Vector start,
      Vector w,
      Part first,
      Dyadic r,
      double end) {
    SturmPolynomial c1 = new SturmPolynomial(Dyadic.ONE, Dyadic.of(q1));
    SturmPolynomial c2 = new SturmPolynomial(Dyadic.ZERO, Dyadic.of(q2));
    re = c1.times(c1).plus(c2.times(c2).negate());
    im = c1.times(c2).times(Dyadic.of(2));
    n = squared(c1, c2);
    x = dx.times(re).plus(dy.times(im));
    y = dy.times(re).plus(dx.times(im).negate());
    this.start = start;
    this.w = w;
    this.r = r;
    this.end = end;
    SturmPolynomial startX = offsetX(Part.START);
    SturmPolynomial startY = offsetY(Part.START);
    height = startY.times(w.x()).plus(startX.times(w.y()).negate());
    fromStart = startX.times(w.x()).plus(startY.times(w.y()));
    fromEnd = offsetX(Part.END).times(w.x()).plus(offsetY(Part.END).times(w.y()));
    add(first, squared(startX, startY), Dyadic.ONE);
    if (!w.isZero()) {
      add(Part.SIDE, height.times(height), w.squared());
      add(Part.END, squared(offsetX(Part.END), offsetY(Part.END)), Dyadic.ONE);
    }
  }

  /** A disk against a disk or a line that does not turn. */
  static CurveOracle of(ParabolaQuery query) {
    double[] n = query.numbers();
    boolean isLine = query.isOfLine();
    int u = isLine ? 11 : 10;
    SturmPolynomial dx = motion(n[0], n[7], n[3], n[u], n[5]);
    SturmPolynomial dy = motion(n[1], n[8], n[4], n[u + 1], n[6]);
    Vector zero = new Vector(Dyadic.ZERO, Dyadic.ZERO);
    Vector w = isLine ? Vector.of(n[9], n[10]).minus(Vector.of(n[7], n[8])) : zero;
    Dyadic r = isLine ? Dyadic.of(n[2]) : Dyadic.of(n[2]).plus(Dyadic.of(n[9]));
    Part first = isLine ? Part.START : Part.CIRCLE;
    return new CurveOracle(dx, dy, 0, 0, zero, w, first, r, query.end());
  }

  static CurveOracle of(TurningQuery q) {
    Vector start = Vector.of(q.ax(), q.ay());
    return new CurveOracle(
        motion(q.px(), q.pivotX(), q.vx(), 0, q.gx()),
        motion(q.py(), q.pivotY(), q.vy(), 0, q.gy()),
        q.q1(),
        q.q2(),
        start.minus(Vector.of(q.pivotX(), q.pivotY())),
        Vector.of(q.bx(), q.by()).minus(start),
        q.isLine() ? Part.START : Part.CIRCLE,
        Dyadic.of(q.r()).plus(Dyadic.of(q.radius())),
        q.end());
  }

  private static SturmPolynomial motion(double p, double q, double v, double u, double g) {
    return new SturmPolynomial(
        Dyadic.of(p).minus(Dyadic.of(q)), Dyadic.of(v).minus(Dyadic.of(u)), Dyadic.of(g).shift(-1));
  }

  private static SturmPolynomial squared(SturmPolynomial x, SturmPolynomial y) {
    return x.times(x).plus(y.times(y));
  }

  private Vector place(Part part) {
    return part == Part.END ? start.plus(w) : start;
  }

  /** The offset of the centre from an end, times n. */
  private SturmPolynomial offsetX(Part part) {
    return x.plus(n.times(place(part).x().negate()));
  }

  private SturmPolynomial offsetY(Part part) {
    return y.plus(n.times(place(part).y().negate()));
  }

  private void add(Part part, SturmPolynomial square, Dyadic scale) {
    Dyadic reach = r.square().times(scale);
    regions.add(region(part, square.plus(n.times(n).times(reach.negate())), 2));
  }

  /** A gap times n^k. */
  private Region region(Part part, SturmPolynomial gap, int k) {
    if (n.degree() == 0) {
      return new Region(part, gap, gap.derivative());
    }
    SturmPolynomial growth = gap.times(n.derivative()).times(Dyadic.of(-k));
    return new Region(part, gap, gap.derivative().times(n).plus(growth));
  }

  private boolean isPoint() {
    return r.signum() == 0;
  }

  // The answers.

  /** The first contact. */
  ParabolaContact first() {
    return within(firstFrom(null), end);
  }

  /**
   * The first contact with a rounded time above s that comes from outside: before it the distance
   * is above the radius, after it below. A point comes from outside whenever it arrives.
   */
  ParabolaContact entry(double s) {
    return within(
        first(event -> (isPoint() ? arrives(event) : enters(event)) && event.nearest() > s), end);
  }

  /** The next contact with what is touched at the start. */
  ParabolaContact back() {
    ratesCount = true;
    Part part = part(null);
    return within(part == Part.SIDE ? backToSide() : backToEnd(part), end);
  }

  /** The first contact from a moment on; null is the start. */
  private ParabolaContact firstFrom(SturmRoot from) {
    Predicate<SturmRoot> counts = isPoint() ? this::arrives : this::falls;
    boolean isNow = isPoint() ? from != null && arrives(from) : falls(from);
    return isNow
        ? contact(from)
        : first(event -> counts.test(event) && (from == null || from.isBefore(event)));
  }

  private ParabolaContact backToSide() {
    int side = side();
    if (side == 0) {
      return ParabolaContact.MISS;
    }
    SturmPolynomial rise = height.times(Dyadic.of(side));
    SturmPolynomial level = n.times(rise.value(Dyadic.ZERO).negate());
    ParabolaContact back = firstOf(region(Part.SIDE, rise.plus(level).fromZero(), 1));
    if (!back.hit()) {
      return back;
    }
    int start = sign(fromStart, back.moment());
    int end = sign(fromEnd, back.moment());
    Region region = region(start, end);
    if (start >= 0 && end <= 0) {
      return new ParabolaContact(region.part(), back.moment(), ofSide(side, back.moment()));
    }
    only = n.degree() == 0 ? region : null;
    return firstFrom(back.moment());
  }

  /** The side that is touched: of a point, or a centre on the line, the one to which it leaves. */
  private int side() {
    int place = sign(height, null);
    SturmPolynomial rise = height.plus(n.times(height.value(Dyadic.ZERO).negate()));
    int speed = sign(rise.derivative(), null);
    int leaving = speed != 0 ? speed : after(rise, null);
    return isPoint() && speed != 0 ? speed : place != 0 ? place : leaving;
  }

  private ParabolaContact backToEnd(Part part) {
    SturmPolynomial square = squared(offsetX(part), offsetY(part));
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
    regions.replaceAll(region -> region.part() == part ? counted : region);
    ParabolaContact next = falls(null) ? contact(null) : first(this::falls);
    return isSooner(other, next) ? other : next;
  }

  // Moments.

  /**
   * The first of all moments for which a condition holds. Those that are too late need not be
   * asked.
   */
  private ParabolaContact first(Predicate<SturmRoot> condition) {
    SturmRoot first = null;
    for (SturmRoot event : events()) {
      boolean isLate = first != null && event.isClearlyAfter(first);
      boolean isTooLate = event.narrow(3).low().near() > end;
      if (!isLate
          && !isTooLate
          && condition.test(event)
          && (first == null || event.isBefore(first))) {
        first = event;
      }
    }
    return first == null ? ParabolaContact.MISS : contact(first);
  }

  /** All moments at which the distance may begin to fall, or the region changes. */
  private List<SturmRoot> events() {
    List<SturmRoot> events = new ArrayList<>();
    for (Region region : regions) {
      events.addAll(region.gap().positiveRoots());
      if (!isPoint() || ratesCount) {
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

  /** Whether the distance is below the radius and falls just after a moment; null is 0. */
  private boolean falls(SturmRoot moment) {
    Region region = region(after(fromStart, moment), after(fromEnd, moment));
    return falls(only == null ? region : only, moment);
  }

  private static boolean falls(Region region, SturmRoot moment) {
    return after(region.gap(), moment) < 0 && after(region.rate(), moment) < 0;
  }

  /** Whether the distance is above the radius just before a moment, and below it just after. */
  private boolean enters(SturmRoot moment) {
    Region next = region(after(fromStart, moment), after(fromEnd, moment));
    return before(regionBefore(moment).gap(), moment) > 0 && after(next.gap(), moment) < 0;
  }

  /** Whether a point comes to a side that it passes, or with a speed to an end. */
  private boolean arrives(SturmRoot moment) {
    Part part = (only == null ? regionBefore(moment) : only).part();
    if (part == Part.SIDE) {
      return sign(height, moment) == 0 && before(height, moment) * after(height, moment) < 0;
    }
    SturmPolynomial dx = offsetX(part);
    SturmPolynomial dy = offsetY(part);
    boolean isThere = sign(dx, moment) == 0 && sign(dy, moment) == 0;
    return isThere && (sign(dx.derivative(), moment) != 0 || sign(dy.derivative(), moment) != 0);
  }

  /** The part of a line in whose region the centre is; the disk itself if there is no line. */
  private Part part(SturmRoot moment) {
    return region(sign(fromStart, moment), sign(fromEnd, moment)).part();
  }

  private Region regionBefore(SturmRoot moment) {
    return region(before(fromStart, moment), before(fromEnd, moment));
  }

  /** The region, by the signs of the projections beyond the two ends. */
  private Region region(int start, int end) {
    return regions.size() == 1 || start <= 0 ? regions.get(0) : regions.get(end >= 0 ? 2 : 1);
  }

  private static int sign(SturmPolynomial f, SturmRoot moment) {
    return moment == null ? f.value(Dyadic.ZERO).signum() : moment.sign(f);
  }

  /** The sign just after a moment: of the first derivative that does not vanish. */
  private static int after(SturmPolynomial f, SturmRoot moment) {
    return nextTo(f, moment, 1);
  }

  private static int before(SturmPolynomial f, SturmRoot moment) {
    return nextTo(f, moment, -1);
  }

  private static int nextTo(SturmPolynomial f, SturmRoot moment, int way) {
    SturmPolynomial derivative = f;
    int sign = 0;
    for (int turn = 1; sign == 0 && !derivative.isZero(); turn *= way) {
      sign = turn * sign(derivative, moment);
      derivative = derivative.derivative();
    }
    return sign;
  }

  private static ParabolaContact within(ParabolaContact contact, double end) {
    return contact.hit() && !contact.within(end) ? ParabolaContact.MISS : contact;
  }

  private static boolean isSooner(ParabolaContact one, ParabolaContact other) {
    if (!one.hit() || !other.hit()) {
      return one.hit();
    }
    if (one.moment() == null || other.moment() == null) {
      return one.moment() == null && other.moment() != null;
    }
    return one.moment().isBefore(other.moment());
  }

  /** The first moment just after which one gap is not above 0 and falls; it has no normal. */
  private static ParabolaContact firstOf(Region region) {
    List<SturmRoot> events = new ArrayList<>();
    events.add(null);
    events.addAll(region.gap().positiveRoots());
    events.addAll(region.rate().positiveRoots());
    ParabolaContact first = ParabolaContact.MISS;
    for (SturmRoot event : events) {
      ParabolaContact contact = new ParabolaContact(region.part(), event, null);
      first = isSooner(contact, first) && falls(region, event) ? contact : first;
    }
    return first;
  }

  // The contact.

  private ParabolaContact contact(SturmRoot moment) {
    Part part = part(moment);
    return new ParabolaContact(part, moment, normal(part, moment));
  }

  /** To so many digits that what cancels does not count. */
  private Normal normal(Part part, SturmRoot moment) {
    int side = moment == null ? after(height, null) : before(height, moment);
    SturmPolynomial dx = offsetX(part);
    SturmPolynomial dy = offsetY(part);
    if (part == Part.SIDE
        || (isPoint() && moment != null && regionBefore(moment).part() == Part.SIDE)) {
      return ofSide(side, moment);
    }
    return isPoint()
        ? turned(dx.derivative().negate(), dy.derivative().negate(), moment)
        : turned(dx, dy, moment);
  }

  private Normal ofSide(int side, SturmRoot moment) {
    SturmPolynomial nx = new SturmPolynomial(w.y().times(Dyadic.of(-side)));
    return turned(nx, new SturmPolynomial(w.x().times(Dyadic.of(side))), moment);
  }

  /** The direction of a vector of the thing at a moment. */
  private Normal turned(SturmPolynomial vx, SturmPolynomial vy, SturmRoot moment) {
    Dyadic t = moment == null ? Dyadic.ZERO : moment.narrow(bits(moment)).low();
    Vector c = new Vector(re.value(t), im.value(t));
    Vector v = new Vector(vx.value(t), vy.value(t).negate());
    Vector world = new Vector(v.dot(c), c.cross(v).negate());
    return world.isZero() ? new Normal(Dyadic.ZERO, Dyadic.ZERO) : Normal.along(world);
  }

  /** As many digits as cancel between the terms of an offset and the radius, and some more. */
  private int bits(SturmRoot moment) {
    Dyadic terms = x.terms(moment.high()).plus(y.terms(moment.high()));
    return isPoint() ? BITS_OF_A_POINT : BITS + Math.max(0, terms.magnitude() - r.magnitude());
  }

  // Walls.

  /** The first of four walls that is hit. */
  static ParabolaContact bounds(WallQuery q, double gx, double gy) {
    SturmPolynomial left = motion(q.px(), q.xmin(), q.vx(), 0, gx);
    SturmPolynomial right = motion(q.px(), q.xmax(), q.vx(), 0, gx).negate();
    SturmPolynomial bottom = motion(q.py(), q.ymin(), q.vy(), 0, gy);
    SturmPolynomial top = motion(q.py(), q.ymax(), q.vy(), 0, gy).negate();
    ParabolaContact first = ParabolaContact.MISS;
    for (ParabolaContact wall :
        List.of(
            wall(left, q, 1, 0),
            wall(right, q, -1, 0),
            wall(bottom, q, 0, 1),
            wall(top, q, 0, -1))) {
      first = isSooner(wall, first) ? wall : first;
    }
    return first;
  }

  private static ParabolaContact wall(SturmPolynomial distance, WallQuery q, int nx, int ny) {
    SturmPolynomial gap = distance.plus(new SturmPolynomial(Dyadic.of(q.r()).negate()));
    ParabolaContact fall = firstOf(new Region(Part.SIDE, gap, gap.derivative()));
    Normal normal = new Normal(Dyadic.of(nx), Dyadic.of(ny));
    return fall.hit()
        ? within(new ParabolaContact(Part.SIDE, fall.moment(), normal), q.end())
        : fall;
  }
}
