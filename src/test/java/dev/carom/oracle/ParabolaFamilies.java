// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;
import dev.carom.oracle.Draw.Triple;
import java.util.ArrayList;
import java.util.List;

/**
 * Kinds of queries about a circle with a constant acceleration. Most come from the straight ones:
 * the flight is bent so that place and velocity at the straight contact stay. So what was nearly a
 * tie there is nearly one here.
 */
public final class ParabolaFamilies {
  private ParabolaFamilies() {}

  public static List<Family<ParabolaQuery>> all() {
    List<Family<ParabolaQuery>> all = new ArrayList<>();
    for (Family<Query> straight : Families.all()) {
      all.add(new Family<>(straight.name(), d -> bent(d, straight.next(d))));
    }
    all.add(new Family<>("lattice", ParabolaFamilies::lattice));
    all.add(new Family<>("graze", ParabolaFamilies::graze));
    all.add(new Family<>("near_graze", ParabolaFamilies::nearGraze));
    all.add(new Family<>("osculating", ParabolaFamilies::osculating));
    all.add(new Family<>("apex", ParabolaFamilies::apex));
    all.add(new Family<>("supported", ParabolaFamilies::supported));
    all.add(new Family<>("turning_inside", ParabolaFamilies::turningInside));
    all.add(new Family<>("bounce", ParabolaFamilies::bounce));
    all.add(new Family<>("tiny_gravity", d -> gravity(d, 1e-300, 1e-12)));
    all.add(new Family<>("huge_gravity", d -> gravity(d, 1e6, 1e15)));
    all.add(new Family<>("along", ParabolaFamilies::along));
    all.add(new Family<>("no_gravity", d -> new ParabolaQuery(any(d), 0, 0)));
    all.add(new Family<>("resting", ParabolaFamilies::resting));
    all.add(new Family<>("scaled", ParabolaFamilies::scaled));
    all.add(new Family<>("halfway", ParabolaFamilies::halfway));
    all.add(new Family<>("halfway_side", ParabolaFamilies::halfwayToASide));
    all.add(new Family<>("touching_side", ParabolaFamilies::touchingSide));
    all.add(new Family<>("touching_disk", ParabolaFamilies::touchingDisk));
    all.add(new Family<>("touching_short_line", ParabolaFamilies::touchingShortLine));
    all.add(new Family<>("halfway_wall", ParabolaFamilies::halfwayToAWall));
    all.add(new Family<>("ceiling", ParabolaFamilies::ceiling));
    all.add(new Family<>("underflow", ParabolaFamilies::underflow));
    all.add(new Family<>("voronoi", ParabolaFamilies::voronoi));
    all.add(new Family<>("shallow_end", ParabolaFamilies::shallowEnd));
    all.add(new Family<>("window_end", ParabolaFamilies::windowEnd));
    return all;
  }

  /** The families with a line in them; all goes with the velocity of the line besides. */
  public static List<Family<ParabolaQuery>> ofMovingLines() {
    return all().stream()
        .filter(family -> !family.name().matches("(circ|wall|halfway|ceiling|no_gravity).*"))
        .map(still -> new Family<>("moving_" + still.name(), d -> moving(d, still, still.next(d))))
        .toList();
  }

  private static ParabolaQuery moving(Draw d, Family<ParabolaQuery> family, ParabolaQuery first) {
    ParabolaQuery still = first;
    while (!(still.straight() instanceof SegmentQuery)) {
      still = family.next(d);
    }
    Query straight = MovingLineQuery.of(d, still.straight());
    ParabolaQuery moving = new ParabolaQuery(straight, still.gx(), still.gy());
    return family.name().endsWith("window_end") ? endingAtImpact(d, moving) : moving;
  }

  /** The places of x and of vx in the numbers of a query. */
  private static int place(Query q) {
    return q instanceof SegmentQuery ? 4 : 0;
  }

  private static int velocity(Query q) {
    return q instanceof SegmentQuery ? 7 : 3;
  }

  private static Query any(Draw d) {
    List<Family<Query>> families = Families.all();
    return families.get(d.whole(0, families.size() - 1)).next(d);
  }

  /** The same contact, reached on a parabola: p + g t^2 / 2 and v - g t at the start. */
  private static ParabolaQuery bent(Draw d, Query q) {
    double[] n = q.numbers();
    double time = q.truth().time();
    double t = time < Double.POSITIVE_INFINITY ? time : d.pick(0.5, 1, d.in(0, 1));
    int p = place(q);
    int v = velocity(q);
    double speed = Math.max(Math.abs(n[v]), Math.abs(n[v + 1]));
    double size = t > 0 ? speed / t * d.log(1e-3, 10) : d.log(0.01, 100);
    Point g = d.chance(0.2) ? new Point(0, -size) : d.direction().times(size);
    n[p] += g.x() * t * t / 2;
    n[p + 1] += g.y() * t * t / 2;
    n[v] -= g.x() * t;
    n[v + 1] -= g.y() * t;
    return new ParabolaQuery(q.with(n), g.x(), g.y());
  }

  /** Whole numbers all over: ties of every sort. */
  private static ParabolaQuery lattice(Draw d) {
    Query q =
        switch (d.whole(0, 2)) {
          case 0 -> SegmentTies.lattice(d);
          case 1 -> PairFamilies.lattice(d);
          default -> WallFamilies.lattice(d);
        };
    double[] n = q.numbers();
    n[n.length - 1] = d.pick(1, 4, Double.POSITIVE_INFINITY);
    int range = d.whole(1, 6);
    double scale = d.chance(0.7) ? 1 : d.binaryScale();
    Point g = d.node(range).times(scale);
    return new ParabolaQuery(Mirror.any(d, q.with(n)), g.x(), g.y());
  }

  /** A disk whose offset and velocity at a moment t are given, all of it exact. */
  private static ParabolaQuery disk(
      Draw d, Point e, Point v, Point g, double t, double radius, boolean nudge) {
    Point p = e.minus(v.times(t)).plus(g.times(t * t / 2));
    Point u = v.minus(g.times(t));
    Point at = d.node(5);
    double[] n = {
      p.x() + at.x(),
      p.y() + at.y(),
      radius,
      u.x(),
      u.y(),
      at.x(),
      at.y(),
      0,
      0,
      0,
      d.pick(t, 8, Double.POSITIVE_INFINITY)
    };
    if (nudge) {
      d.nudgeOne(n, 0.7);
      n[2] = Math.abs(n[2]);
      n[7] = Math.abs(n[7]);
    }
    boolean line = d.chance(0.5);
    return new ParabolaQuery(line ? withLine(d, n) : PairQuery.of(n), g.x(), g.y());
  }

  /**
   * The disk in the way as the end of a line, of any direction, so that the side may be hit too.
   */
  private static Query withLine(Draw d, double[] n) {
    Point w = d.node(9);
    double[] line = {n[5], n[6], n[5] + w.x(), n[6] + w.y(), n[0], n[1], n[2], n[3], n[4], n[10]};
    return SegmentQuery.of(line);
  }

  private static double moment(Draw d) {
    return d.pick(0.5, 1, 1, 2, 4);
  }

  /** The velocity at contact is along the tangent, exactly. */
  private static ParabolaQuery graze(Draw d) {
    Triple t = d.triple();
    double k = d.whole(1, 9);
    Point e = t.direction().times(k);
    Point v = t.direction().turned().times(d.whole(-3, 3));
    return disk(d, e, v, d.node(9).times(2), moment(d), k * t.z(), d.chance(0.3));
  }

  /** At a distance of 1e-3..1e-15 of the radius from a graze. */
  private static ParabolaQuery nearGraze(Draw d) {
    Point e = d.direction();
    double r = d.log(0.1, 40);
    Point v = e.turned().times(d.sign() * d.log(0.5, 400));
    double near = r * (1 + d.sign() * d.log(1e-15, 1e-3));
    Point g = d.direction().times(d.log(0.5, 400));
    return disk(d, e.times(near), v, g, d.in(0.01, 1), r, false);
  }

  /** Roots of multiplicity 3 and 4: the path osculates the circle. */
  private static ParabolaQuery osculating(Draw d) {
    Triple t = d.triple();
    double k = d.pick(1, 2, 4);
    double m = d.pick(1, 2, 4) * d.sign();
    Point e = t.direction().times(k);
    Point v = t.direction().turned().times(m);
    Point bend = t.direction().times(-m * m / k);
    Point g = bend.plus(t.direction().turned().times(d.whole(-3, 3)));
    return disk(d, e, v, g, moment(d), k * t.z(), d.chance(0.3));
  }

  /** At rest when it touches. */
  private static ParabolaQuery apex(Draw d) {
    Triple t = d.triple();
    double k = d.whole(1, 9);
    Point e = t.direction().times(k);
    return disk(d, e, new Point(0, 0), d.node(9), moment(d), k * t.z(), d.chance(0.4));
  }

  /** At a contact at the start without normal speed. */
  private static ParabolaQuery supported(Draw d) {
    Triple t = d.triple();
    double k = d.whole(1, 9);
    Point e = t.direction().times(k);
    Point v = t.direction().turned().times(d.whole(-3, 3));
    return disk(d, e, v, d.node(9), 0, k * t.z(), d.chance(0.4));
  }

  /** Overlapping at the start, leaving, and drawn back. */
  private static ParabolaQuery turningInside(Draw d) {
    Point e = d.direction().times(d.in(0, 1));
    double r = d.log(0.5, 2);
    Point v = e.times(d.log(0.1, 3)).plus(d.direction().times(d.in(0, 0.5)));
    Point g = e.times(-d.log(0.1, 10)).plus(d.direction().times(d.in(0, 0.5)));
    return disk(d, e, v, g, 0, r, false);
  }

  /** Leaves a contact at the start and comes back. */
  private static ParabolaQuery bounce(Draw d) {
    Query q = any(d);
    double[] n = q.numbers();
    n[n.length - 1] = Double.POSITIVE_INFINITY;
    Contact contact = q.with(n).truth();
    double t = contact.hit() && contact.time() < 1e100 ? contact.time() : 0;
    int p = place(q);
    int v = velocity(q);
    n[p] += n[v] * t;
    n[p + 1] += n[v + 1] * t;
    n[v] = -n[v];
    n[v + 1] = -n[v + 1];
    double fall = -d.log(0.01, 3);
    n[n.length - 1] = d.pick(10, Double.POSITIVE_INFINITY);
    return new ParabolaQuery(q.with(n), n[v] * fall, n[v + 1] * fall * d.pick(1, 1, 0.9));
  }

  private static ParabolaQuery gravity(Draw d, double low, double high) {
    Query q = any(d);
    double[] n = q.numbers();
    int v = velocity(q);
    double speed = Math.max(Math.abs(n[v]), Math.abs(n[v + 1]));
    Point g = d.direction().times(d.log(low, high) * (d.chance(0.5) ? speed : 1));
    n[n.length - 1] = d.pick(n[n.length - 1], 1, Double.POSITIVE_INFINITY);
    return new ParabolaQuery(q.with(n), g.x(), g.y());
  }

  /** The acceleration along the velocity, or along an axis. */
  private static ParabolaQuery along(Draw d) {
    Query q = any(d);
    double[] n = q.numbers();
    int v = velocity(q);
    if (d.chance(0.5)) {
      double factor = d.pick(-1, 1, -2, 0.5, -0.25);
      return new ParabolaQuery(q, n[v] * factor, n[v + 1] * factor);
    }
    return d.chance(0.5)
        ? new ParabolaQuery(q, 0, d.whole(-9, 9))
        : new ParabolaQuery(q, d.whole(-9, 9), 0);
  }

  /** From rest. */
  private static ParabolaQuery resting(Draw d) {
    Query q = any(d);
    double[] n = q.numbers();
    int v = velocity(q);
    Point g = new Point(n[v] * d.log(0.1, 9), n[v + 1] * d.log(0.1, 9));
    n[v] = 0;
    n[v + 1] = 0;
    n[n.length - 1] = d.pick(1, 4, Double.POSITIVE_INFINITY);
    return new ParabolaQuery(q.with(n), g.x(), g.y());
  }

  /** Lengths in another unit, or times. */
  private static ParabolaQuery scaled(Draw d) {
    ParabolaQuery bent = d.chance(0.5) ? lattice(d) : bent(d, any(d));
    double[] n = bent.straight().numbers();
    double end = n[n.length - 1];
    int k = d.whole(-900, 900);
    if (d.chance(0.5)) {
      Extremes.scale(n, k);
      ParabolaQuery scaled =
          new ParabolaQuery(
              bent.straight().with(n), Math.scalb(bent.gx(), k), Math.scalb(bent.gy(), k));
      return isFlat(scaled.straight()) ? bent : scaled;
    }
    int half = k / 2;
    int v = velocity(bent.straight());
    boolean isPair = bent.straight() instanceof PairQuery;
    for (int i : isPair ? new int[] {3, 4, 8, 9} : new int[] {v, v + 1}) {
      n[i] = Math.scalb(n[i], half);
    }
    n[n.length - 1] = Math.scalb(end, -half);
    return new ParabolaQuery(
        bent.straight().with(n), Math.scalb(bent.gx(), 2 * half), Math.scalb(bent.gy(), 2 * half));
  }

  /** Whether walls have fallen together by underflow. */
  private static boolean isFlat(Query query) {
    return query instanceof WallQuery q && !(q.xmin() < q.xmax() && q.ymin() < q.ymax());
  }

  /** A number of 26 bits in 1..2: products of two are exact. */
  private static double short26(Draw d) {
    return 1 + Math.scalb(Math.rint(d.in(0, 0x1p25)), -25);
  }

  /**
   * The time is halfway between two doubles, up to about 2^-106 of the terms: the other disk's
   * place is corrected by Newton's method in exact numbers.
   */
  private static ParabolaQuery halfway(Draw d) {
    Point e = d.direction();
    Point v = e.turned(d.in(-1, 1)).times(-d.log(1, 10));
    double t = d.in(0.5, 1);
    double r = d.log(0.1, 2);
    Point g = d.direction().times(d.log(0.1, 10));
    Point p = e.times(r).minus(v.times(t)).plus(g.times(t * t / 2));
    Point u = v.minus(g.times(t));
    double y = 0;
    Dyadic middle = Dyadic.of(t).plus(Dyadic.of(Math.ulp(t)).shift(-1));
    for (int i = 0; i < 3; i++) {
      Dyadic dx = at(p.x(), u.x(), g.x(), middle);
      Dyadic dy = at(p.y(), u.y(), g.y(), middle).minus(Dyadic.of(y));
      Dyadic gap = dx.square().plus(dy.square()).minus(Dyadic.of(r).square());
      y += gap.near() / (2 * dy.near());
    }
    double[] n = {p.x(), p.y(), r, u.x(), u.y(), 0, y, 0, 0, 0, Double.POSITIVE_INFINITY};
    return new ParabolaQuery(PairQuery.of(n), g.x(), g.y());
  }

  /** The same with the side of a level line, whose height is corrected. */
  private static ParabolaQuery halfwayToASide(Draw d) {
    Point v = new Point(0, -d.log(1, 10)).turned(d.in(-1, 1));
    double t = d.in(0.5, 1);
    double r = d.log(0.1, 2);
    Point g = d.direction().times(d.log(0.1, 10));
    Point p = new Point(0, r).minus(v.times(t)).plus(g.times(t * t / 2));
    Point u = v.minus(g.times(t));
    Dyadic middle = Dyadic.of(t).plus(Dyadic.of(Math.ulp(t)).shift(-1));
    double y = at(p.y(), u.y(), g.y(), middle).minus(Dyadic.of(r)).near();
    double end = Double.POSITIVE_INFINITY;
    double[] n = {-d.log(20, 99), y, d.log(20, 99), y, p.x(), p.y(), r, u.x(), u.y(), end};
    return new ParabolaQuery(SegmentQuery.of(n), g.x(), g.y());
  }

  /** A gap, or a speed, at a contact: none, rounding, small, or plain. */
  private static double slight(Draw d, double most) {
    return switch (d.whole(0, 4)) {
      case 0, 1 -> 0;
      case 2 -> d.in(-2e-16, 2e-16);
      case 3 -> d.sign() * d.log(1e-17, 1) * most;
      default -> d.in(-most, most);
    };
  }

  private static double window(Draw d) {
    return d.pick(0, d.in(0, 1), d.log(1e-17, 1), Double.POSITIVE_INFINITY);
  }

  /** The acceleration of a disk at a contact: any, or along the normal or the tangent. */
  private static Point pull(Draw d, Point normal) {
    return switch (d.whole(0, 4)) {
      case 0 -> new Point(0, -10);
      case 1 -> normal.times(d.in(-10, 10));
      case 2 -> normal.turned().times(d.in(-10, 10));
      default -> d.direction().times(d.log(0.1, 10));
    };
  }

  /** Starts at the side of a line, up to rounding: slides, leaves it, presses against it. */
  private static ParabolaQuery touchingSide(Draw d) {
    Point a = d.chance(0.3) ? d.node(9) : d.place();
    Point w = d.chance(0.3) ? d.node(40) : d.direction().times(d.log(0.1, 100));
    if (d.chance(0.2)) {
      w = new Point(0, w.y()); // so that it may move along the line exactly
    }
    double length = Math.hypot(w.x(), w.y());
    Point along = length > 0 ? w.times(1 / length) : new Point(1, 0);
    Point normal = along.turned().times(d.sign());
    double r = d.chance(0.3) ? 1 : d.log(0.1, 10);
    double part = d.pick(d.in(0, 1), d.in(0, 1), d.in(-1, 2), d.whole(0, 1) + slight(d, 1e-9));
    Point p = a.plus(w.times(part)).plus(normal.times(r + slight(d, r)));
    double slide = d.chance(0.3) ? 0 : d.in(-10, 10);
    Point v = along.times(slide).plus(normal.times(slight(d, 10)));
    Point g = pull(d, normal);
    double[] n = {
      a.x(), a.y(), a.x() + w.x(), a.y() + w.y(), p.x(), p.y(), r, v.x(), v.y(), window(d)
    };
    return new ParabolaQuery(SegmentQuery.of(n), g.x(), g.y());
  }

  /** The same at another disk, or at the end of a line. */
  private static ParabolaQuery touchingDisk(Draw d) {
    Point normal = d.direction();
    Point at = d.chance(0.3) ? d.node(9) : d.place();
    double r1 = d.chance(0.3) ? 1 : d.log(0.1, 10);
    double r2 = d.pick(0, 1, d.log(0.1, 10));
    Point p = at.plus(normal.times(r1 + r2 + slight(d, r1)));
    double slide = d.chance(0.3) ? 0 : d.in(-10, 10);
    Point v = normal.turned().times(slide).plus(normal.times(slight(d, 10)));
    Point g = pull(d, normal);
    double[] n = {p.x(), p.y(), r1, v.x(), v.y(), at.x(), at.y(), r2, 0, 0, window(d)};
    boolean line = r2 == 0 && d.chance(0.5);
    return new ParabolaQuery(line ? withLine(d, n) : PairQuery.of(n), g.x(), g.y());
  }

  /** In contact with both ends of a line to within rounding, and moves nearly along it or round. */
  private static ParabolaQuery touchingShortLine(Draw d) {
    double length = Math.scalb(d.in(1, 2), d.whole(-40, -8));
    Point along = d.direction();
    Point normal = along.turned();
    Point a = d.chance(0.5) ? new Point(0, 0) : d.place();
    Point b = a.plus(along.times(length));
    double aside = Math.max(length, 0x1p-22) * d.in(-4, 4);
    Point p = a.plus(along.times(aside)).plus(normal.times(1 + d.whole(-700, 700) * 0x1p-53));
    double slide = d.pick(0, 1, d.in(-10, 10));
    double rise = d.chance(0.3) ? faint(d) : slide * (length * d.in(-2, 2) - aside);
    Point v = along.times(slide).plus(normal.times(rise));
    Point g = normal.times(faint(d)).plus(along.times(d.chance(0.7) ? 0 : faint(d)));
    double[] n = {a.x(), a.y(), b.x(), b.y(), p.x(), p.y(), 1, v.x(), v.y(), window(d)};
    return new ParabolaQuery(SegmentQuery.of(n), g.x(), g.y());
  }

  private static double faint(Draw d) {
    return d.chance(0.1) ? 0 : d.sign() * Math.scalb(d.in(1, 2), d.whole(-45, 0));
  }

  private static Dyadic at(double p, double v, double g, Dyadic t) {
    return Dyadic.of(p).plus(Dyadic.of(v).times(t)).plus(Dyadic.of(g).times(t.square()).shift(-1));
  }

  /** Halfway, exactly but for an acceleration of 2^-96..2^-120. */
  private static ParabolaQuery halfwayToAWall(Draw d) {
    double v = short26(d);
    double r = short26(d);
    double t = short26(d);
    double rest = v * Math.ulp(t) / 2;
    double g = d.sign() * Math.scalb(1 + d.in(0, 1), d.whole(-120, -96));
    double x = r + v * t;
    WallQuery q = new WallQuery(x, 5, r, -v, 0, -rest, -9, 99, 99, Double.POSITIVE_INFINITY);
    return new ParabolaQuery(q, g, 0);
  }

  /** Thrown up so that it just reaches the ceiling, or just does not. */
  private static ParabolaQuery ceiling(Draw d) {
    double v = d.chance(0.3) ? d.whole(1, 9) : d.log(0.1, 100);
    double g = d.chance(0.3) ? d.whole(1, 9) : d.log(0.1, 100);
    double y = d.chance(0.5) ? 0 : d.in(-10, 10);
    double r = d.chance(0.5) ? 0 : d.whole(0, 4);
    double top = d.nudge(y + v * v / (2 * g) + r);
    double end = d.pick(v / g, 2 * v / g, Double.POSITIVE_INFINITY);
    WallQuery q = new WallQuery(3, y, r, 0, v, -50, -50, 50, Math.max(top, -49), end);
    return new ParabolaQuery(q, 0, -g);
  }

  /** So small that squares underflow, in part or all. */
  private static ParabolaQuery underflow(Draw d) {
    ParabolaQuery q = d.chance(0.5) ? touching(d) : d.chance(0.5) ? graze(d) : bent(d, any(d));
    double[] n = q.straight().numbers();
    int k = d.chance(0.8) ? d.whole(-536, -515) : d.whole(-560, -220);
    Extremes.scale(n, k);
    Query scaled = q.straight().with(n);
    return isFlat(scaled)
        ? q
        : new ParabolaQuery(scaled, Math.scalb(q.gx(), k), Math.scalb(q.gy(), k));
  }

  private static ParabolaQuery touching(Draw d) {
    double r = d.log(0.5, 2);
    Point e = d.direction();
    Point v = e.turned(d.in(-2, 2)).times(-1);
    return disk(d, e.times(r), v, d.direction(), 0, r, false);
  }

  /** Comes to the side where it meets an end: the centre is on the perpendicular, up to ulps. */
  private static ParabolaQuery voronoi(Draw d) {
    Point w = d.chance(0.5) ? d.node(9) : d.direction().times(d.log(0.1, 100));
    double length = Math.hypot(w.x(), w.y());
    double r = d.chance(0.5) ? length * d.whole(1, 3) : d.log(0.1, 20);
    Point normal = length > 0 ? w.turned().times(1 / length) : new Point(0, 1);
    Point a = d.node(9);
    Point foot = d.chance(0.5) ? a : a.plus(w);
    Point v = normal.turned(d.in(-1.5, 1.5)).times(-d.log(0.5, 100));
    double t = d.in(0.01, 1);
    Point g = d.direction().times(d.log(0.1, 100));
    Point p = foot.plus(normal.times(r)).minus(v.times(t)).plus(g.times(t * t / 2));
    Point u = v.minus(g.times(t));
    double[] n = {
      a.x(), a.y(), a.x() + w.x(), a.y() + w.y(), p.x(), p.y(), r, u.x(), u.y(), d.pick(1, 2)
    };
    d.nudgeOne(n, 0.5);
    n[6] = Math.abs(n[6]);
    return new ParabolaQuery(SegmentQuery.of(n), g.x(), g.y());
  }

  /**
   * Comes to the strip along a line near one of its ends, at an angle of 1e-8..1e-4, or starts
   * there: while rounding leaves open when it enters the strip, it passes the end.
   */
  private static ParabolaQuery shallowEnd(Draw d) {
    Point along = d.direction();
    double length = d.log(0.1, 100);
    double r = d.log(0.1, 20);
    Point a = d.node(9);
    Point b = a.plus(along.times(length));
    double beside = d.sign() * length * d.log(1e-14, 1e-8);
    Point touch = (d.chance(0.5) ? a : b).plus(along.times(beside)).plus(along.turned().times(r));
    Point v = along.times(d.sign() * d.log(0.5, 100)).turned(d.sign() * d.log(1e-8, 1e-4));
    Point g = d.direction().times(d.log(1e-3, 100));
    double t = d.chance(0.3) ? 0 : d.in(0.01, 1);
    Point p = touch.minus(v.times(t)).plus(g.times(t * t / 2));
    Point u = v.minus(g.times(t));
    double end = d.pick(2, Double.POSITIVE_INFINITY);
    Query q = new SegmentQuery(a.x(), a.y(), b.x(), b.y(), p.x(), p.y(), r, u.x(), u.y(), end);
    return new ParabolaQuery(q, g.x(), g.y());
  }

  /** The window ends at the rounded time of impact, or some ulps beside it. */
  private static ParabolaQuery windowEnd(Draw d) {
    ParabolaQuery q =
        switch (d.whole(0, 4)) {
          case 0 -> lattice(d);
          case 1 -> graze(d);
          case 2 -> turningInside(d);
          case 3 -> osculating(d);
          default -> bent(d, any(d));
        };
    return endingAtImpact(d, q);
  }

  private static ParabolaQuery endingAtImpact(Draw d, ParabolaQuery q) {
    if (!q.isFair()) {
      return q;
    }
    double[] n = q.straight().numbers();
    n[n.length - 1] = Double.POSITIVE_INFINITY;
    double time = new ParabolaQuery(q.straight().with(n), q.gx(), q.gy()).truth().time();
    n[n.length - 1] = Math.max(0, d.chance(0.4) ? time : Draw.ulps(time, d.whole(-3, 3)));
    return new ParabolaQuery(q.straight().with(n), q.gx(), q.gy());
  }
}
