// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;
import dev.carom.oracle.Draw.Triple;

/**
 * Two moving circles, of which the second rests in nearly half of the queries. As for lines, the
 * contact is chosen first; then both are moved back, and both get a common velocity.
 */
final class PairFamilies {
  private PairFamilies() {}

  /** Two circles with given offset, relative velocity and sum of the radii. */
  private static PairQuery pair(Draw d, Point e, Point v, double radius, Point at, Point common) {
    double r1 = radius * d.pick(0, 0.5, 1, d.in(0, 1), d.in(0, 1), d.in(0, 1));
    Point p = at.plus(e);
    Point u = common.plus(v);
    double r2 = Math.max(0, radius - r1);
    return new PairQuery(
        p.x(), p.y(), r1, u.x(), u.y(), at.x(), at.y(), r2, common.x(), common.y(), 1);
  }

  private static PairQuery pair(Draw d, Point e, Point v, double radius) {
    Point common = d.chance(0.45) ? new Point(0, 0) : d.place();
    return pair(d, e, v, radius, d.place(), common);
  }

  private static PairQuery aimed(Draw d, double angle, double speed, double radius) {
    Point normal = d.direction();
    Point v = normal.turned(angle).times(-speed);
    return pair(d, normal.times(radius).minus(v.times(d.in(0.01, 0.99))), v, radius);
  }

  private static PairQuery nudged(Draw d, PairQuery q, double probability) {
    double[] n = q.numbers();
    d.nudgeOne(n, probability);
    n[2] = Math.abs(n[2]);
    n[7] = Math.abs(n[7]);
    return PairQuery.of(n);
  }

  static PairQuery uniform(Draw d) {
    return d.chance(0.5)
        ? aimed(d, d.in(-1.5, 1.5), d.log(0.5, 400), d.in(0, 40))
        : pair(d, d.place(), d.direction().times(d.log(0.5, 400)), d.in(0, 40));
  }

  static PairQuery fast(Draw d) {
    return aimed(d, d.in(-1.5, 1.5), d.log(1e4, 1e11), d.in(5, 40));
  }

  static PairQuery far(Draw d) {
    PairQuery q = aimed(d, d.in(-1.5, 1.5), d.log(0.5, 200), d.in(2, 40));
    Point origin = d.direction().times(d.log(1e6, 1e13));
    double[] n = q.numbers();
    for (int i : new int[] {0, 5}) {
      n[i] += origin.x();
      n[i + 1] += origin.y();
    }
    return PairQuery.of(n);
  }

  /** Centre upon centre: exactly, on lattices, or at an angle of 1e-16..1e-3. */
  static PairQuery headOn(Draw d) {
    if (d.chance(0.5)) {
      return aimed(d, d.sign() * d.log(1e-16, 1e-3), d.log(0.5, 400), d.in(0, 40));
    }
    Point step = d.node(60);
    double radius = d.in(0, 1.2) * Math.hypot(step.x(), step.y());
    PairQuery q = pair(d, step, step.times(-d.whole(1, 8)), radius, d.node(100), d.node(99));
    return nudged(d, q, 0.3);
  }

  static PairQuery nearGraze(Draw d) {
    if (d.chance(0.4)) {
      return exactGraze(d);
    }
    double angle = d.chance(0.7) ? Math.PI / 2 : Math.PI / 2 - d.log(1e-16, 1e-2);
    return nudged(d, aimed(d, d.sign() * angle, d.log(0.5, 400), d.in(0.1, 40)), 0.8);
  }

  /** The path of one centre is tangent to the circle around the other: a triple's z is a radius. */
  private static PairQuery exactGraze(Draw d) {
    Triple t = d.triple();
    Point v = t.direction().turned().times(d.sign() * d.whole(1, 9));
    double k = d.multiple();
    Point e = t.direction().times(k).minus(v.times(d.pick(0, 0.25, 0.5, 1)));
    return nudged(d, pair(d, e, v, k * t.z(), d.node(100), d.node(9)), 0.5);
  }

  static PairQuery touching(Draw d) {
    double radius = d.in(0.1, 40);
    Point normal = d.direction();
    Point v = normal.turned(d.chance(0.7) ? d.in(-Math.PI, Math.PI) : d.sign() * Math.PI / 2);
    if (d.chance(0.6)) {
      return nudged(d, pair(d, normal.times(radius), v.times(d.log(0.5, 400)), radius), 0.7);
    }
    Triple t = d.triple();
    double k = d.multiple();
    Point u = d.chance(0.5) ? d.node(9) : t.direction().turned().times(d.whole(-9, 9));
    Point e = t.direction().times(k);
    return nudged(d, pair(d, e, u, k * t.z(), d.node(100), d.node(9)), 0.4);
  }

  static PairQuery overlapping(Draw d) {
    double radius = d.in(1, 40);
    Point e = d.direction().times(radius * d.in(0, 1));
    Point any = d.direction().times(d.log(0.5, 400));
    return pair(d, e, d.chance(0.8) ? any : e.turned(), radius);
  }

  /** One centre on the other, or a few ulps beside it. */
  static PairQuery concentric(Draw d) {
    Point v = d.chance(0.3) ? new Point(0, 0) : d.place();
    return nudged(d, pair(d, new Point(0, 0), v, d.in(0, 40)), 0.5);
  }

  /** Equal velocities, up to some ulps or denormals. */
  static PairQuery sameVelocity(Draw d) {
    PairQuery q = pair(d, d.direction().times(d.in(0, 60)), new Point(0, 0), d.in(0, 40));
    double[] n = q.numbers();
    n[10] = d.pick(1, 1e15, 1e308);
    for (int i : new int[] {3, 4}) {
      n[i] = Draw.ulps(n[i], d.whole(-3, 3));
    }
    return PairQuery.of(n);
  }

  /** One circle up to 1e12 times the other. */
  static PairQuery sizeRatio(Draw d) {
    double radius = d.log(1e3, 1e13);
    double[] n = aimed(d, d.in(-1.5, 1.5), d.log(0.5, 400), radius).numbers();
    double small = d.in(0, 20);
    boolean first = d.chance(0.5);
    n[2] = first ? small : radius - small;
    n[7] = first ? radius - small : small;
    return PairQuery.of(n);
  }

  static PairQuery lattice(Draw d) {
    int range = d.whole(1, 6);
    double radius = d.chance(0.7) ? d.whole(0, range) : d.triple().z();
    PairQuery q = pair(d, d.node(2 * range), d.node(range), radius, d.node(range), d.node(range));
    return nudged(d, q, 0.15);
  }

  static PairQuery extremeMagnitude(Draw d) {
    double[] n = (d.chance(0.5) ? uniform(d) : NearTies.pair(d)).numbers();
    switch (d.whole(0, 4)) {
      case 0 -> Extremes.scale(n, d.whole(-1060, 1018));
      case 1 -> Extremes.scaleTime(d, n, 3, 4, 8, 9);
      case 2 -> n[d.whole(0, 9)] = d.sign() * d.log(1e-320, 1e-200);
      case 3 -> Extremes.mix(d, n);
      default -> n = Extremes.denormal(lattice(d).numbers());
    }
    n[2] = Math.abs(n[2]);
    n[7] = Math.abs(n[7]);
    return PairQuery.of(n);
  }
}
