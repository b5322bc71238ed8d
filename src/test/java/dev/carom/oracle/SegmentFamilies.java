// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;

/**
 * Circles and lines at random places. Most are aimed: the contact is chosen first (a place on the
 * line, a normal, an angle of approach, a time) and the circle moved back along its velocity, so
 * that the answer is near the choice, and as near to another one as the rounding makes it.
 */
final class SegmentFamilies {
  private SegmentFamilies() {}

  /** A line and where on it the circle is to touch. */
  private record Target(Point a, Point b, Point foot, Point normal) {}

  private static Target target(Draw d, Point a, Point b) {
    Point w = b.minus(a);
    Point along = w.times(1 / Math.max(Math.hypot(w.x(), w.y()), Double.MIN_NORMAL));
    double where = d.in(0, 1);
    if (where < 0.4) {
      return new Target(a, b, a.plus(w.times(d.in(0, 1))), along.turned().times(d.sign()));
    }
    // Outwards at an end: up to 90 degrees from the line's direction.
    double angle = d.in(-Math.PI / 2, Math.PI / 2);
    return where < 0.7
        ? new Target(a, b, a, along.times(-1).turned(angle))
        : new Target(a, b, b, along.turned(angle));
  }

  private static Target target(Draw d) {
    Point a = d.place();
    return target(d, a, a.plus(d.direction().times(d.log(0.1, 150))));
  }

  /** Moves the circle from its contact back by the velocity times t. */
  private static SegmentQuery aim(Target g, double r, Point v, double t, double end) {
    Point p = g.foot().plus(g.normal().times(r)).minus(v.times(t));
    Point a = g.a();
    Point b = g.b();
    return new SegmentQuery(a.x(), a.y(), b.x(), b.y(), p.x(), p.y(), r, v.x(), v.y(), end);
  }

  /** A velocity against the normal, up to nearly 90 degrees from it. */
  private static Point against(Draw d, Target g, double speed) {
    return g.normal().turned(d.in(-1.5, 1.5)).times(-speed);
  }

  private static SegmentQuery aimed(Draw d, Target g, double r, double speed) {
    return aim(g, r, against(d, g, speed), d.in(0.01, 0.99), 1);
  }

  static SegmentQuery uniform(Draw d) {
    Target g = target(d);
    double r = d.chance(0.5) ? d.in(0, 20) : d.log(0.01, 20);
    if (d.chance(0.5)) {
      return aimed(d, g, r, d.log(0.5, 400));
    }
    Point p = d.place();
    Point v = d.direction().times(d.log(0.5, 400));
    return aim(new Target(g.a(), g.b(), p, g.normal()), r, v, 0, 1);
  }

  static SegmentQuery posterCases(Draw d) {
    Point a = d.place();
    Point b = a.plus(d.direction().times(d.in(5, 100)));
    return aimed(d, target(d, a, b), d.in(5, 20), d.log(5, 400));
  }

  static SegmentQuery fast(Draw d) {
    double r = d.in(5, 20);
    return aimed(d, target(d), r, r * d.log(1e3, 1e11));
  }

  /** As slow as 1e-14; seldom as slow as a denormal, or at rest. */
  static SegmentQuery slow(Draw d) {
    Target g = target(d);
    double t = d.in(0.01, 1.2) * d.pick(1, 1, 1e6, 1e13);
    double r = d.log(0.01, 20);
    if (d.chance(0.9)) {
      return aim(g, r, against(d, g, d.log(1e-14, 1e-11)), t, d.pick(1, 1e6, 1e13, 1e308));
    }
    Point v = d.node(3).times(Double.MIN_VALUE);
    return aim(g, r, v, 0, d.pick(1, 1e15, 1e308));
  }

  /** Nearly along the line: at an angle of 1e-15..0.01. */
  static SegmentQuery shallow(Draw d) {
    Target g = target(d);
    double angle = Math.PI / 2 - d.log(1e-15, 1e-2);
    Point v = g.normal().turned(d.sign() * angle).times(-d.log(0.5, 400));
    return aim(g, d.log(0.1, 20), v, d.in(0.01, 0.99), 1);
  }

  static SegmentQuery far(Draw d) {
    Point origin = d.direction().times(d.log(1e6, 1e13));
    Point a = origin.plus(d.place());
    Point b = a.plus(d.direction().times(d.log(1, 100)));
    return aimed(d, target(d, a, b), 10, d.log(1, 200));
  }

  /** The same scene in another unit of length. */
  static SegmentQuery scaled(Draw d, double low, double high) {
    double[] n = aimed(d, target(d), d.in(0, 20), d.log(0.5, 400)).numbers();
    double scale = d.log(low, high);
    for (int i = 0; i < n.length - 1; i++) {
      n[i] *= scale;
    }
    return SegmentQuery.of(n);
  }

  static SegmentQuery radius(Draw d, double low, double high) {
    double r = d.log(low, high);
    return aimed(d, target(d), r, d.log(0.5, 400) * (d.chance(0.5) ? 1 : Math.max(r, 1)));
  }

  static SegmentQuery radiusZero(Draw d) {
    return d.chance(0.3) ? SegmentTies.pointIntoEnd(d) : aimed(d, target(d), 0, d.log(0.5, 400));
  }

  /** From zero length over a few ulps to 1e-3. */
  static SegmentQuery segmentShort(Draw d) {
    Point a = d.chance(0.9) ? d.place() : new Point(0, 0);
    Point w = d.direction().times(d.pick(0, d.log(1e-15, 1e-3), d.log(1e-320, 1e-15)));
    Point b = new Point(d.nudge(a.x() + w.x()), d.nudge(a.y() + w.y()));
    return aimed(d, target(d, a, b), d.log(0.1, 20), d.log(0.5, 400));
  }

  /** Past an end at a distance of exactly the radius, as far as doubles can; then some ulps off. */
  static SegmentQuery nearGraze(Draw d) {
    if (d.chance(0.3)) {
      return SegmentTies.exactGraze(d);
    }
    Target g = target(d);
    Point v = g.normal().turned().times(d.sign() * d.log(0.5, 400));
    double[] n = aim(g, d.log(0.1, 20), v, d.in(0.01, 0.99), 1).numbers();
    n[6] = d.nudge(n[6]);
    d.nudgeOne(n, 0.5);
    return SegmentQuery.of(n);
  }

  /** Touches where the centre stands on the perpendicular through an end. */
  static SegmentQuery voronoiEdge(Draw d) {
    if (d.chance(0.3)) {
      return SegmentTies.exactVoronoi(d);
    }
    Target g = target(d);
    Point w = g.b().minus(g.a());
    Point normal = w.turned().times(d.sign() / Math.hypot(w.x(), w.y()));
    Target edge = new Target(g.a(), g.b(), d.chance(0.5) ? g.a() : g.b(), normal);
    double[] n = aimed(d, edge, d.log(0.1, 20), d.log(0.5, 400)).numbers();
    d.nudgeOne(n, 0.5);
    return SegmentQuery.of(n);
  }

  /** The distance at 0 is the radius, as far as doubles can, and the velocity anything. */
  static SegmentQuery startTouching(Draw d) {
    if (d.chance(0.2)) {
      return SegmentTies.exactTouch(d);
    }
    Target g = target(d);
    Point any = d.direction().times(d.log(0.5, 400));
    Point tangent = g.normal().turned().times(d.sign() * d.log(0.5, 400));
    double[] n = aim(g, d.log(0.1, 20), d.chance(0.7) ? any : tangent, 0, 1).numbers();
    n[6] = d.nudge(n[6]);
    return SegmentQuery.of(n);
  }

  static SegmentQuery startOverlapping(Draw d) {
    Target g = target(d);
    double r = d.in(1, 20);
    Point any = d.direction().times(d.log(0.5, 400));
    Point tangent = g.normal().turned().times(d.sign() * d.log(0.5, 400));
    double[] n = aim(g, r * d.in(0, 1), d.chance(0.8) ? any : tangent, 0, 1).numbers();
    n[6] = r;
    return SegmentQuery.of(n);
  }

  /** The window ends at the rounded time of impact, or some ulps beside it. */
  static SegmentQuery windowEnd(Draw d) {
    SegmentQuery q =
        switch (d.whole(0, 7)) {
          case 0 -> SegmentTies.lattice(d);
          case 1 -> nearGraze(d);
          case 2 -> shallow(d);
          case 3 -> startTouching(d);
          case 4 -> radius(d, 1e3, 1e12);
          case 5 -> slow(d);
          default -> uniform(d);
        };
    double[] n = q.numbers();
    n[9] = Double.POSITIVE_INFINITY;
    double time = SegmentQuery.of(n).truth().time();
    n[9] = Math.max(0, d.chance(0.4) ? time : Draw.ulps(time, d.whole(-3, 3)));
    return SegmentQuery.of(n);
  }

  /** All magnitudes: of the whole scene, of the times, of single numbers, and denormal lattices. */
  static SegmentQuery extremeMagnitude(Draw d) {
    SegmentQuery q =
        switch (d.whole(0, 5)) {
          case 0 -> NearTies.end(d);
          case 1 -> NearTies.side(d);
          case 2 -> NearTies.corner(d);
          case 3 -> SegmentTies.tiePlusTiny(d);
          default -> uniform(d);
        };
    double[] n = q.numbers();
    switch (d.whole(0, 4)) {
      case 0 -> Extremes.scale(n, d.whole(-1060, 1018));
      case 1 -> Extremes.scaleTime(d, n, 7, 8);
      case 2 -> n[d.whole(0, 8)] = d.sign() * d.log(1e-320, 1e-200);
      case 3 -> Extremes.mix(d, n);
      default -> n = Extremes.denormal(SegmentTies.lattice(d).numbers());
    }
    n[6] = Math.abs(n[6]);
    return SegmentQuery.of(n);
  }
}
