// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;
import dev.carom.oracle.Draw.Triple;

/**
 * Circles and lines on lattices, where ties are exact: a Pythagorean triple (x, y, z) gives a
 * direction of exact length z, so that contacts, grazes and times are doubles. Then one number is
 * moved by an ulp or by 1e-300, and the tie has a side.
 */
final class SegmentTies {
  private SegmentTies() {}

  private static SegmentQuery query(
      Point a, Point b, Point p, double r, Point v, double end, double scale) {
    double[] n = {a.x(), a.y(), b.x(), b.y(), p.x(), p.y(), r, v.x(), v.y(), end};
    for (int i = 0; i < 9; i++) {
      n[i] *= scale;
    }
    return SegmentQuery.of(n);
  }

  private static SegmentQuery nudged(Draw d, SegmentQuery q, double probability) {
    double[] n = q.numbers();
    d.nudgeOne(n, probability);
    n[6] = Math.abs(n[6]);
    return SegmentQuery.of(n);
  }

  /** Small whole numbers everywhere: every kind of tie, by chance. */
  static SegmentQuery lattice(Draw d) {
    int range = d.whole(1, 6);
    Point v = d.node(range);
    double r = d.chance(0.7) ? d.whole(0, range) : d.triple().z();
    double end = d.pick(0.5, 1, 2, 4, 1e9);
    Point p = d.node(2 * range);
    SegmentQuery q = query(d.node(range), d.node(range), p, r, v, end, d.binaryScale());
    return nudged(d, q, 0.15);
  }

  /** A centre whose path is tangent to the circle of radius r around the start. */
  static SegmentQuery exactGraze(Draw d) {
    Triple t = d.triple();
    double k = d.multiple();
    Point a = d.node(100);
    Point normal = t.direction();
    Point v = normal.turned().times(d.sign() * d.whole(1, 9));
    Point b = a.plus(d.node(60));
    Point p = a.plus(normal.times(k)).minus(v.times(d.pick(0, 0.25, 0.5, 1)));
    return nudged(d, query(a, b, p, k * t.z(), v, 1, d.binaryScale()), 0.6);
  }

  /** A contact straight above an end of the line: the projection is the end itself. */
  static SegmentQuery exactVoronoi(Draw d) {
    Triple t = d.triple();
    Point a = d.node(100);
    Point b = a.plus(t.direction().times(d.whole(1, 9)));
    Point normal = t.direction().turned().times(d.sign());
    double k = d.chance(0.1) ? 0 : d.multiple();
    Point v = normal.times(-d.whole(1, 9));
    v = d.chance(0.5) ? v : v.plus(t.direction().times(d.whole(-9, 9)));
    Point foot = d.chance(0.5) ? a : b;
    Point p = foot.plus(normal.times(k)).minus(v.times(d.pick(0, 0.25, 0.5, 1)));
    return nudged(d, query(a, b, p, k * t.z(), v, 1, d.binaryScale()), 0.6);
  }

  /** A start at exactly the radius from the line or an end of it. */
  static SegmentQuery exactTouch(Draw d) {
    Triple t = d.triple();
    Point a = d.node(100);
    double k = d.multiple();
    Point p = a.plus(t.direction().times(k));
    Point w = d.chance(0.5) ? t.direction().turned() : d.node(60);
    Point from = d.chance(0.3) ? a.minus(w.times(d.whole(0, 3))) : a;
    Point any = d.node(9);
    Point tangent = t.direction().turned().times(d.whole(-9, 9));
    Point v = d.chance(0.6) ? any : tangent;
    return nudged(d, query(from, a.plus(w), p, k * t.z(), v, 1, d.binaryScale()), 0.4);
  }

  /** A point that meets an end of the line exactly. */
  static SegmentQuery pointIntoEnd(Draw d) {
    Point a = d.node(100);
    Point v = d.node(99);
    Point p = a.minus(v.times(d.pick(0.25, 0.5, 1)));
    return nudged(d, query(a, a.plus(d.node(60)), p, 0, v, 1, d.binaryScale()), 0.3);
  }

  /** Along the line into its end, from beyond it or from within. */
  static SegmentQuery collinear(Draw d) {
    Triple t = d.triple();
    Point step = d.chance(0.5) ? d.node(60) : t.direction();
    Point a = d.node(100);
    Point b = a.plus(step.times(d.whole(-4, 4)));
    Point p = a.plus(step.times(d.whole(-16, 16) / 2.0));
    Point v = step.times(d.whole(-8, 8) / 4.0);
    double r = d.pick(0, 0, t.z() * d.whole(1, 4), d.log(1e-3, 200));
    return nudged(d, query(a, b, p, r, v, d.pick(1, 2, 8), d.binaryScale()), 0.3);
  }

  /** A centre on the line at time 0: on an end, on the start of all halvings, or nearly. */
  static SegmentQuery startOnLine(Draw d) {
    Point w = d.chance(0.1) ? new Point(0, 0) : d.node(60).times(8);
    Point a = d.node(100);
    Point p = a.plus(w.times(d.pick(0, 1, 0.5, 0.25, d.whole(-1, 9) / 8.0)));
    Point any = d.direction().times(d.log(0.1, 60));
    Point v = d.chance(0.5) ? any : w.times(d.whole(-3, 3));
    double r = d.pick(0, d.log(1e-3, 10), d.whole(0, 5));
    return nudged(d, query(a, a.plus(w), p, r, v, 1, d.binaryScale()), 0.2);
  }

  /** Beside the line at a distance of exactly the radius, or an ulp off, moving along it. */
  static SegmentQuery parallelAtRadius(Draw d) {
    Triple t = d.triple();
    Point along = t.direction();
    double k = d.multiple();
    Point a = d.node(100);
    Point b = a.plus(along.times(d.whole(-9, 9)));
    Point p = a.plus(along.times(d.whole(-16, 16) / 2.0)).plus(along.turned().times(k));
    Point v = along.times(d.whole(-16, 16) / 2.0);
    double[] n = query(a, b, p, k * t.z(), v, 1, d.binaryScale()).numbers();
    n[6] = Draw.ulps(n[6], d.whole(-1, 1));
    if (d.chance(0.3)) {
      d.tiny(n, 0, 1, 2, 3, 7, 8);
    }
    return SegmentQuery.of(n);
  }

  /** Lines on the axes, ties of every kind there, and one coordinate moved by 1e-16..1e-323. */
  static SegmentQuery tiePlusTiny(Draw d) {
    double length = d.chance(0.2) ? 0 : d.whole(1, 60);
    double r = d.chance(0.2) ? 0 : d.whole(1, 60);
    Point b = new Point(length, 0);
    Point foot = d.chance(0.5) ? b : new Point(0, 0);
    Point straight = new Point(0, -d.whole(1, 80));
    Point flat = new Point(d.sign() * d.whole(1, 80), 0);
    Point v = d.chance(0.5) ? straight : flat;
    Point touch = d.chance(0.8) ? new Point(0, r) : new Point(-d.sign() * r, 0);
    Point p = foot.plus(touch).minus(v.times(d.pick(0, 0.25, 0.5, 1 / 3.0)));
    double[] n = query(new Point(0, 0), b, p, r, v, 1, d.binaryScale()).numbers();
    d.tiny(n, 0, 1, 2, 3, 4, 5, 7, 8);
    return SegmentQuery.of(n);
  }
}
