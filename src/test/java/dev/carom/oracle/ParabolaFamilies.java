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

  public static List<ParabolaFamily> all() {
    List<ParabolaFamily> all = new ArrayList<>();
    for (Family straight : Families.all()) {
      all.add(new ParabolaFamily(straight.name(), d -> bent(d, straight.next(d))));
    }
    all.add(new ParabolaFamily("lattice", ParabolaFamilies::lattice));
    all.add(new ParabolaFamily("graze", ParabolaFamilies::graze));
    all.add(new ParabolaFamily("near_graze", ParabolaFamilies::nearGraze));
    all.add(new ParabolaFamily("osculating", ParabolaFamilies::osculating));
    all.add(new ParabolaFamily("apex", ParabolaFamilies::apex));
    all.add(new ParabolaFamily("supported", ParabolaFamilies::supported));
    all.add(new ParabolaFamily("turning_inside", ParabolaFamilies::turningInside));
    all.add(new ParabolaFamily("bounce", ParabolaFamilies::bounce));
    all.add(new ParabolaFamily("tiny_gravity", d -> gravity(d, 1e-300, 1e-12)));
    all.add(new ParabolaFamily("huge_gravity", d -> gravity(d, 1e6, 1e15)));
    all.add(new ParabolaFamily("along", ParabolaFamilies::along));
    all.add(new ParabolaFamily("no_gravity", d -> new ParabolaQuery(any(d), 0, 0)));
    all.add(new ParabolaFamily("resting", ParabolaFamilies::resting));
    all.add(new ParabolaFamily("scaled", ParabolaFamilies::scaled));
    all.add(new ParabolaFamily("window_end", ParabolaFamilies::windowEnd));
    return all;
  }

  /** The places of x and of vx in the numbers of a query. */
  private static int place(Query q) {
    return q instanceof SegmentQuery ? 4 : 0;
  }

  private static int velocity(Query q) {
    return q instanceof SegmentQuery ? 7 : 3;
  }

  private static Query any(Draw d) {
    List<Family> families = Families.all();
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
      return new ParabolaQuery(
          bent.straight().with(n), Math.scalb(bent.gx(), k), Math.scalb(bent.gy(), k));
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
    double[] n = q.straight().numbers();
    n[n.length - 1] = Double.POSITIVE_INFINITY;
    double time = new ParabolaQuery(q.straight().with(n), q.gx(), q.gy()).truth().time();
    n[n.length - 1] = Math.max(0, d.chance(0.4) ? time : Draw.ulps(time, d.whole(-3, 3)));
    return new ParabolaQuery(q.straight().with(n), q.gx(), q.gy());
  }
}
