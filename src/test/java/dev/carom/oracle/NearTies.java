// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;

/**
 * Ties missed by one part in 2^80: the hardest decisions that 53-bit numbers can pose, because two
 * different values of x^2 and n y^2 with whole x, y cannot be nearer to each other than 1. They
 * come from Pell's equation: convergents p / q of the continued fraction of sqrt(n) have {@code
 * |p^2 - n q^2| < 1 + 2 sqrt(n)} (Hardy and Wright, An Introduction to the Theory of Numbers, X).
 */
final class NearTies {
  private NearTies() {}

  /** Whole numbers with p^2 nearly n q^2. */
  private record Convergent(double p, double q) {}

  /** A convergent of sqrt(n), in one half of the cases the last with p below 2^bits. */
  private static Convergent convergent(Draw d, int n, int bits) {
    long limit = 1L << (d.chance(0.5) ? bits : d.whole(4, bits));
    int root = (int) Math.sqrt(n);
    long p0 = 1;
    long p1 = root;
    long q0 = 0;
    long q1 = 1;
    int m = 0;
    int denominator = 1;
    int digit = root;
    while (p1 < limit && root * root != n) {
      m = denominator * digit - m;
      denominator = (n - m * m) / denominator;
      digit = (root + m) / denominator;
      long p2 = digit * p1 + p0;
      long q2 = digit * q1 + q0;
      p0 = p1;
      q0 = q1;
      p1 = p2;
      q1 = q2;
    }
    return p0 > 1 ? new Convergent(p0, q0) : new Convergent(p1, q1);
  }

  /** A direction of coprime whole numbers. */
  private static Point primitive(Draw d) {
    Point v = d.node(9);
    while (gcd((int) v.x(), (int) v.y()) != 1) {
      v = d.node(9);
    }
    return v;
  }

  private static int gcd(int a, int b) {
    return b == 0 ? Math.abs(a) : gcd(b, a % b);
  }

  private static double dot(Point v, Point w) {
    return v.x() * w.x() + v.y() * w.y();
  }

  private static int square(Point v) {
    return (int) dot(v, v);
  }

  /** A whole e with v x e = k, before the origin on its way with v: {@code e.v < -way |v|}. */
  private static Point before(Draw d, Point v, double k, double way) {
    // v x unit = 1; then e = k unit + j v for every j.
    Point unit = unit(v);
    double along = k * dot(unit, v) + way * Math.sqrt(square(v));
    double j = -Math.ceil(along / square(v)) - d.whole(1, 3) * d.pick(1, 1000);
    return unit.times(k).plus(v.times(j));
  }

  /** A small whole vector u with v x u = 1, by trial. */
  private static Point unit(Point v) {
    for (int x = -9; x <= 9; x++) {
      for (int y = -9; y <= 9; y++) {
        if (v.x() * y - v.y() * x == 1) {
          return new Point(x, y);
        }
      }
    }
    throw new IllegalStateException("not coprime: " + v);
  }

  /** An offset and a velocity for which the least distance is nearly r: |v x e| nearly r |v|. */
  private record Graze(Point e, Point v, double r) {}

  private static Graze graze(Draw d) {
    Point v = primitive(d);
    Convergent c = convergent(d, square(v), 48);
    return new Graze(before(d, v, d.sign() * c.p(), 0), v, c.q());
  }

  /** An offset of length nearly r: (y^2/2, y) and y^2/2 + 1, or (r, 1) and r. */
  private static Graze touch(Draw d) {
    double y = 2.0 * d.whole(1, 1 << d.whole(1, 24));
    double half = y * y / 2;
    Point e = d.chance(0.5) ? new Point(half, y) : new Point(half + 1, 1);
    return new Graze(e, primitive(d).times(d.sign()), half + 1);
  }

  /** The circle past, or starting at, or at the end of the window at, an end of a line. */
  static SegmentQuery end(Draw d) {
    boolean grazes = d.chance(0.5);
    Graze g = grazes ? graze(d) : touch(d);
    double t = grazes ? 0 : d.whole(0, 2);
    Point p = g.e().minus(g.v().times(t));
    Point b = d.node(20).times(d.pick(0, 1, -1, 1e6));
    return query(b, p, g.r(), g.v(), grazes ? 1e30 : t);
  }

  /** The side, starting or with the window ending when |w x e| is nearly r |w|. */
  static SegmentQuery side(Draw d) {
    Point w = primitive(d);
    Convergent c = convergent(d, square(w), 46);
    Point e = before(d, w, d.sign() * c.p(), 0);
    double j = -Math.floor(dot(e, w) / square(w));
    Point over = e.plus(w.times(j + d.whole(0, 4)));
    double t = d.whole(0, 2);
    Point v = primitive(d).times(d.whole(1, 5));
    return query(w.times(5), over.minus(v.times(t)), c.q(), v, t);
  }

  /**
   * A path that passes nearly through the corner of the side moved by r: the point r w' / |w| above
   * the start, w' = w turned left. It lies on the path v x x = k if r (v.w) = k |w|.
   */
  static SegmentQuery corner(Draw d) {
    Point w = primitive(d);
    Point any = primitive(d);
    Point v = any.times(dot(any, w.turned()) > 0 ? -1 : 1);
    Convergent c = convergent(d, square(w), 42);
    Point p = before(d, v, dot(v, w) * c.q(), c.p());
    return query(w.times(d.pick(1, 3, 1e6)), p, c.p(), v, 1e30);
  }

  private static SegmentQuery query(Point b, Point p, double r, Point v, double end) {
    return new SegmentQuery(0, 0, b.x(), b.y(), p.x(), p.y(), r, v.x(), v.y(), end);
  }

  /** Two circles past, or starting at, or at the end of the window at, each other. */
  static PairQuery pair(Draw d) {
    boolean grazes = d.chance(0.5);
    Graze g = grazes ? graze(d) : touch(d);
    double t = grazes ? 0 : d.whole(0, 2);
    Point at = d.node(1000);
    Point common = d.chance(0.5) ? new Point(0, 0) : d.node(100);
    Point p = at.plus(g.e()).minus(g.v().times(t));
    Point v = common.plus(g.v());
    double r1 = Math.rint(g.r() * d.pick(0, 1, d.in(0, 1)));
    return new PairQuery(
        p.x(),
        p.y(),
        r1,
        v.x(),
        v.y(),
        at.x(),
        at.y(),
        g.r() - r1,
        common.x(),
        common.y(),
        grazes ? 1e30 : t);
  }
}
