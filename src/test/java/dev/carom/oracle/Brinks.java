// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;
import java.util.List;

/**
 * Queries on the brink of one single decision or rounding, for those that the other families seldom
 * come near.
 */
public final class Brinks {
  private Brinks() {}

  public static List<Family<Query>> all() {
    return List.of(
        Family.mirrored("brink_along_line", Brinks::alongLine),
        Family.mirrored("brink_beyond_end", Brinks::beyondEnd),
        Family.mirrored("brink_across", Brinks::across),
        Family.mirrored("brink_wall", Brinks::wall),
        Family.mirrored("brink_short_graze", Brinks::shortGraze),
        Family.mirrored("brink_seg_units", Brinks::segmentUnits),
        Family.mirrored("brink_seg_units_window_end", Brinks::segmentWindow),
        Family.mirrored("brink_seg_squares", Brinks::squares),
        Family.mirrored("brink_circ_units", Brinks::pairUnits),
        Family.mirrored("brink_circ_window_end", Brinks::pairWindow));
  }

  /** Coordinates of different magnitudes, whose differences are rounded. */
  private static Point uneven(Draw d) {
    return new Point(d.sign() * d.log(1e-6, 1e3), d.sign() * d.log(1e-6, 1e3));
  }

  /** Overlaps the side, and moves along it as far as doubles can. */
  private static SegmentQuery alongLine(Draw d) {
    Point a = uneven(d);
    Point b = uneven(d);
    Point w = b.minus(a);
    Point v = w.times(d.sign() * d.log(0.1, 10));
    Point p = a.plus(w.times(d.in(0.1, 0.9))).plus(w.turned().times(d.in(-1, 1)));
    return segment(a, b, p, v, 2 * size(w));
  }

  /** Overlaps an end of the line, straight above it as far as doubles can. */
  private static SegmentQuery beyondEnd(Draw d) {
    Point a = uneven(d);
    Point b = uneven(d);
    Point w = b.minus(a);
    Point e = w.turned().times(d.sign() * d.log(0.1, 10));
    return segment(a, b, a.plus(e), e.times(-1), 2 * size(e));
  }

  private static SegmentQuery segment(Point a, Point b, Point p, Point v, double r) {
    return new SegmentQuery(a.x(), a.y(), b.x(), b.y(), p.x(), p.y(), r, v.x(), v.y(), 1);
  }

  private static double size(Point v) {
    return Math.abs(v.x()) + Math.abs(v.y());
  }

  /** The side, by a radius or to a line whose square underflows, and the other is as large. */
  private static SegmentQuery squares(Draw d) {
    double small = d.log(1e-163, 1e-155);
    double large = d.log(1e86, 1e95);
    boolean line = d.sign() > 0;
    double half = line ? large : small;
    double r = line ? small : large;
    Point p = new Point(half * d.in(-0.5, 0.5), r * d.in(1.5, 4));
    return segment(new Point(-half, 0), new Point(half, 0), p, new Point(0, -r), r);
  }

  /** Two overlapping circles that move across the line between them as far as doubles can. */
  private static PairQuery across(Draw d) {
    Point at = uneven(d);
    Point p = uneven(d);
    Point e = p.minus(at);
    Point u = uneven(d);
    Point v = u.plus(e.turned().times(d.sign() * d.log(0.1, 10)));
    double r = size(e);
    return new PairQuery(p.x(), p.y(), r, v.x(), v.y(), at.x(), at.y(), r, u.x(), u.y(), 1);
  }

  /**
   * A time halfway between two doubles, but for one part in 2^107 or less: at speed 1 the gap is
   * the time, the radius half an ulp of it, and the wall tiny. Seldom in units that make the time
   * denormal.
   */
  private static WallQuery wall(Draw d) {
    double px = d.in(1, 2);
    double r = d.whole(0, 3) * 0x1p-54;
    double xmin = d.sign() * Math.scalb(d.in(1, 2), -d.whole(54, 120));
    double[] n = {px, 0, r, -d.pick(1, 1, 2, 3, 5), 0, xmin, -9, 9, 9, 9};
    if (d.chance(0.2)) {
      Extremes.scale(n, -100);
      n[3] *= 0x1p1000;
    }
    return WallQuery.of(n);
  }

  /**
   * A graze so short that it lasts some ulps of the time: past a circle of 2^-28 of the way, nearer
   * than its radius by some ulps.
   */
  private static SegmentQuery shortGraze(Draw d) {
    double way = d.log(1, 1000);
    double r = way * d.log(0x1p-32, 0x1p-24);
    Point v = new Point(d.log(0.5, 400), 0);
    return segment(new Point(0, 0), d.node(20), new Point(-way, r), v, d.nudge(r));
  }

  /** Ties in units of length and of time so small or large that squares leave the range. */
  private static SegmentQuery segmentUnits(Draw d) {
    SegmentQuery q =
        switch (d.whole(0, 3)) {
          case 0 -> NearTies.end(d);
          case 1 -> NearTies.side(d);
          case 2 -> NearTies.corner(d);
          default -> SegmentFamilies.nearGraze(d);
        };
    double[] n = units(d, q, 7, 8);
    return SegmentQuery.of(n);
  }

  private static SegmentQuery segmentWindow(Draw d) {
    return SegmentQuery.of(units(d, SegmentFamilies.windowEnd(d), 7, 8));
  }

  private static PairQuery pairUnits(Draw d) {
    PairQuery q = d.chance(0.5) ? NearTies.pair(d) : PairFamilies.nearGraze(d);
    return PairQuery.of(units(d, q, 3, 4, 8, 9));
  }

  /** The window ends within ulps of the impact. */
  private static PairQuery pairWindow(Draw d) {
    double[] n = (d.chance(0.6) ? PairFamilies.uniform(d) : PairFamilies.lattice(d)).numbers();
    n[10] = Double.POSITIVE_INFINITY;
    double time = PairQuery.of(n).truth().time();
    n[10] = Math.max(0, d.chance(0.4) ? time : Draw.ulps(time, d.whole(-3, 3)));
    return PairQuery.of(n);
  }

  private static double[] units(Draw d, Query q, int... velocities) {
    double[] n = q.numbers();
    int length = (int) d.pick(-d.whole(250, 280), -d.whole(500, 560), d.whole(100, 900));
    int speed = d.chance(0.3) ? 0 : d.whole(-900, 900);
    Extremes.scale(n, length);
    for (int i : velocities) {
      n[i] = Math.scalb(n[i], speed);
    }
    n[n.length - 1] = Math.scalb(n[n.length - 1], -speed);
    return n;
  }
}
