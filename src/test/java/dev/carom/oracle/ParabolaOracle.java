// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/**
 * The contract of contact for a circle with a constant acceleration, taken literally: the first
 * moment just after which the distance is at most the radius and falls. In each Voronoi region the
 * square of the distance is a polynomial in time. Every moment at which something can change is an
 * isolated root, and what holds just after it follows from the signs of the derivatives there, by
 * {@link SturmPolynomial}.
 *
 * <p>A point (radius 0) hits at the first moment at which the distance is 0 and its derivative from
 * the left is negative: the square of the distance then bends just before.
 */
final class ParabolaOracle {
  /** Bits of the time for a normal: of a point, whose velocity may nearly vanish, many more. */
  private static final int BITS = 140;

  private static final int BITS_OF_A_POINT = 260;

  /** A region, and the square of the distance less that of the radius, times a positive number. */
  private record Region(Part part, SturmPolynomial gap) {}

  final SturmPolynomial x;
  final SturmPolynomial y;
  final Dyadic r;
  final SturmPolynomial alongStart;
  final SturmPolynomial alongEnd;
  private final List<Region> regions = new ArrayList<>();
  final Dyadic wx;
  final Dyadic wy;

  private ParabolaOracle(SturmPolynomial x, SturmPolynomial y, Dyadic r) {
    this(x, y, r, Dyadic.ZERO, Dyadic.ZERO, Part.CIRCLE);
  }

  private ParabolaOracle(
      SturmPolynomial x, SturmPolynomial y, Dyadic r, Dyadic wx, Dyadic wy, Part first) {
    this.x = x;
    this.y = y;
    this.r = r;
    this.wx = wx;
    this.wy = wy;
    Dyadic ww = wx.square().plus(wy.square());
    regions.add(new Region(first, squared(x, y).plus(constant(r.square().negate()))));
    alongStart = x.times(wx).plus(y.times(wy));
    alongEnd = alongStart.plus(constant(ww.negate()));
    if (ww.signum() > 0) {
      SturmPolynomial height = y.times(wx).plus(x.times(wy).negate());
      Dyadic limit = r.square().times(ww).negate();
      regions.add(new Region(Part.SIDE, height.times(height).plus(constant(limit))));
      SturmPolynomial ex = x.plus(constant(wx.negate()));
      SturmPolynomial ey = y.plus(constant(wy.negate()));
      regions.add(new Region(Part.END, squared(ex, ey).plus(constant(r.square().negate()))));
    }
  }

  static ParabolaContact answer(ParabolaQuery query) {
    return query.straight() instanceof WallQuery q
        ? bounds(q, query.gx(), query.gy())
        : within(of(query).first(), query.end());
  }

  /**
   * The first contact with a rounded time above s that comes from outside: before it the distance
   * is above the radius, after it below. A point comes from outside whenever it arrives.
   */
  static ParabolaContact after(ParabolaQuery query, double s) {
    ParabolaOracle oracle = of(query);
    boolean isPoint = oracle.r.signum() == 0;
    return within(
        oracle.first(
            event ->
                (isPoint ? oracle.arrives(event) : oracle.enters(event)) && event.nearest() > s),
        query.end());
  }

  /** A disk against a disk or a line. */
  static ParabolaOracle of(ParabolaQuery query) {
    if (query.straight() instanceof PairQuery q) {
      SturmPolynomial x = motion(q.x1(), q.x2(), q.vx1(), q.vx2(), query.gx());
      SturmPolynomial y = motion(q.y1(), q.y2(), q.vy1(), q.vy2(), query.gy());
      return new ParabolaOracle(x, y, Dyadic.of(q.r1()).plus(Dyadic.of(q.r2())));
    }
    MovingLineQuery q = line(query.straight());
    SturmPolynomial x = motion(q.px(), q.ax(), q.vx(), q.ux(), query.gx());
    SturmPolynomial y = motion(q.py(), q.ay(), q.vy(), q.uy(), query.gy());
    Dyadic wx = Dyadic.of(q.bx()).minus(Dyadic.of(q.ax()));
    Dyadic wy = Dyadic.of(q.by()).minus(Dyadic.of(q.ay()));
    return new ParabolaOracle(x, y, Dyadic.of(q.r()), wx, wy, Part.START);
  }

  /** A line at rest moves with velocity 0. */
  private static MovingLineQuery line(Query straight) {
    return straight instanceof SegmentQuery q
        ? new MovingLineQuery(
            q.ax(), q.ay(), q.bx(), q.by(), q.px(), q.py(), q.r(), q.vx(), q.vy(), 0, 0, q.end())
        : (MovingLineQuery) straight;
  }

  static ParabolaContact within(ParabolaContact contact, double end) {
    return contact.hit() && !contact.within(end) ? ParabolaContact.MISS : contact;
  }

  private static SturmPolynomial motion(double p, double q, double v, double u, double g) {
    return new SturmPolynomial(
        Dyadic.of(p).minus(Dyadic.of(q)), Dyadic.of(v).minus(Dyadic.of(u)), Dyadic.of(g).shift(-1));
  }

  static SturmPolynomial constant(Dyadic value) {
    return new SturmPolynomial(value);
  }

  static SturmPolynomial squared(SturmPolynomial x, SturmPolynomial y) {
    return x.times(x).plus(y.times(y));
  }

  ParabolaContact first() {
    return r.signum() > 0 ? firstOfDisk() : first(this::arrives);
  }

  /** The first moment after which a gap is not above 0 and falls. */
  ParabolaContact firstOfDisk() {
    return falls(null) ? contact(null) : first(this::falls);
  }

  /** The first moment at which a point arrives at another part than a given one. */
  ParabolaContact firstOfPoint(Part except) {
    return first(event -> arrives(event) && part(event) != except);
  }

  /**
   * The first of all moments for which a condition holds. Those that are too late need not be
   * asked.
   */
  private ParabolaContact first(Predicate<SturmRoot> condition) {
    SturmRoot first = null;
    for (SturmRoot event : events()) {
      boolean isLate = (first != null && event.isClearlyAfter(first));
      if (!isLate && condition.test(event) && (first == null || event.isBefore(first))) {
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
      events.addAll(region.gap().derivative().positiveRoots());
    }
    events.addAll(alongStart.positiveRoots());
    events.addAll(alongEnd.positiveRoots());
    events.sort(Comparator.comparing(event -> event.narrow(3).low()));
    return events;
  }

  /** Whether the distance is above the radius just before a moment, and below it just after. */
  private boolean enters(SturmRoot moment) {
    SturmPolynomial last = region(before(alongStart, moment), before(alongEnd, moment)).gap();
    SturmPolynomial next = region(after(alongStart, moment), after(alongEnd, moment)).gap();
    return before(last, moment) > 0 && after(next, moment) < 0;
  }

  /** Whether the distance is below the radius and falls just after a moment; null is 0. */
  private boolean falls(SturmRoot moment) {
    SturmPolynomial gap = region(after(alongStart, moment), after(alongEnd, moment)).gap();
    return after(gap, moment) < 0 && after(gap.derivative(), moment) < 0;
  }

  /** Whether a point comes to distance 0, with a slope. */
  private boolean arrives(SturmRoot moment) {
    SturmPolynomial gap = region(before(alongStart, moment), before(alongEnd, moment)).gap();
    return sign(gap, moment) == 0 && sign(gap.derivative().derivative(), moment) != 0;
  }

  private ParabolaContact contact(SturmRoot moment) {
    Part part = part(moment);
    return new ParabolaContact(part, moment, normal(part, moment));
  }

  /** The part of a line in whose region the centre is; the disk itself if there is no line. */
  Part part(SturmRoot moment) {
    return region(sign(alongStart, moment), sign(alongEnd, moment)).part();
  }

  /** The gap in the region of a part. */
  SturmPolynomial gap(Part part) {
    return regions.stream().filter(region -> region.part() == part).findFirst().orElseThrow().gap();
  }

  /** Replaces the gap in the region of a part. */
  void setGap(Part part, SturmPolynomial gap) {
    regions.replaceAll(region -> region.part() == part ? new Region(part, gap) : region);
  }

  /** The region, by the signs of the projections beyond the two ends. */
  private Region region(int start, int end) {
    return regions.size() == 1 || start <= 0 ? regions.get(0) : regions.get(end >= 0 ? 2 : 1);
  }

  static int sign(SturmPolynomial q, SturmRoot moment) {
    return moment == null ? q.value(Dyadic.ZERO).signum() : moment.sign(q);
  }

  /** The sign just after a moment: of the first derivative that does not vanish. */
  static int after(SturmPolynomial q, SturmRoot moment) {
    SturmPolynomial derivative = q;
    int sign = 0;
    while (sign == 0 && !derivative.isZero()) {
      sign = sign(derivative, moment);
      derivative = derivative.derivative();
    }
    return sign;
  }

  /** The sign just before a moment. */
  static int before(SturmPolynomial q, SturmRoot moment) {
    SturmPolynomial derivative = q;
    int sign = 0;
    int turn = -1;
    while (sign == 0 && !derivative.isZero()) {
      sign = sign(derivative, moment);
      derivative = derivative.derivative();
      turn = -turn;
    }
    return sign * turn;
  }

  /** To so many digits that what cancels does not count. */
  private Normal normal(Part part, SturmRoot moment) {
    Dyadic t = moment == null ? Dyadic.ZERO : moment.narrow(bits(moment)).low();
    if (part == Part.SIDE) {
      SturmPolynomial height = y.times(wx).plus(x.times(wy).negate());
      Dyadic side = Dyadic.of(moment == null ? after(height, null) : before(height, moment));
      return Normal.along(new Vector(wy.negate(), wx).times(side));
    }
    if (r.signum() == 0) {
      SturmPolynomial vx = x.derivative();
      SturmPolynomial vy = y.derivative();
      return slidesIn(part, moment)
          ? Normal.along(new Vector(wy.negate(), wx).times(Dyadic.of(sideBefore(moment))))
          : Normal.along(new Vector(vx.value(t), vy.value(t)).negate());
    }
    boolean end = part == Part.END;
    Dyadic nx = x.value(t).minus(end ? wx : Dyadic.ZERO);
    Dyadic ny = y.value(t).minus(end ? wy : Dyadic.ZERO);
    return Normal.along(new Vector(nx, ny));
  }

  /** As many digits as cancel between the terms of an offset and the radius, and some more. */
  private int bits(SturmRoot moment) {
    Dyadic terms = x.terms(moment.high()).plus(y.terms(moment.high()));
    return r.signum() == 0
        ? BITS_OF_A_POINT
        : BITS + Math.max(0, terms.magnitude() - r.magnitude());
  }

  private int sideBefore(SturmRoot moment) {
    return before(y.times(wx).plus(x.times(wy).negate()), moment);
  }

  /** Whether a point comes to an end of the line from beside the line. */
  private boolean slidesIn(Part part, SturmRoot moment) {
    if (part == Part.CIRCLE || (wx.signum() == 0 && wy.signum() == 0)) {
      return false;
    }
    return region(before(alongStart, moment), before(alongEnd, moment)).part() == Part.SIDE;
  }

  private static ParabolaContact bounds(WallQuery q, double gx, double gy) {
    ParabolaContact[] walls = {
      wall(motion(q.px(), q.xmin(), q.vx(), 0, gx), q, new Vector(Dyadic.ONE, Dyadic.ZERO)),
      wall(
          motion(q.px(), q.xmax(), q.vx(), 0, gx).negate(),
          q,
          new Vector(Dyadic.ONE.negate(), Dyadic.ZERO)),
      wall(motion(q.py(), q.ymin(), q.vy(), 0, gy), q, new Vector(Dyadic.ZERO, Dyadic.ONE)),
      wall(
          motion(q.py(), q.ymax(), q.vy(), 0, gy).negate(),
          q,
          new Vector(Dyadic.ZERO, Dyadic.ONE.negate()))
    };
    ParabolaContact first = ParabolaContact.MISS;
    for (ParabolaContact wall : walls) {
      first = isSooner(wall, first) ? wall : first;
    }
    return first;
  }

  static boolean isSooner(ParabolaContact one, ParabolaContact other) {
    if (!one.hit() || !other.hit()) {
      return one.hit();
    }
    if (one.moment() == null || other.moment() == null) {
      return one.moment() == null && other.moment() != null;
    }
    return one.moment().isBefore(other.moment());
  }

  private static ParabolaContact wall(SturmPolynomial distance, WallQuery q, Vector normal) {
    SturmPolynomial gap = distance.plus(constant(Dyadic.of(q.r()).negate()));
    return within(firstFall(gap, Part.SIDE, Normal.along(normal)), q.end());
  }

  /** The first moment just after which a gap is not above 0 and falls. */
  static ParabolaContact firstFall(SturmPolynomial gap, Part part, Normal normal) {
    return firstFall(gap, gap.derivative(), part, normal);
  }

  /** The same of a gap with a rate of its own. */
  static ParabolaContact firstFall(
      SturmPolynomial gap, SturmPolynomial rate, Part part, Normal normal) {
    List<SturmRoot> events = new ArrayList<>();
    events.add(null);
    events.addAll(gap.positiveRoots());
    events.addAll(rate.positiveRoots());
    SturmRoot first = null;
    boolean found = false;
    for (SturmRoot event : events) {
      boolean sooner = !found || (first != null && event.isBefore(first));
      if (sooner && after(gap, event) < 0 && after(rate, event) < 0) {
        first = event;
        found = true;
      }
    }
    return found ? new ParabolaContact(part, first, normal) : ParabolaContact.MISS;
  }
}
