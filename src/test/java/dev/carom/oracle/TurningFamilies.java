// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;
import dev.carom.oracle.Draw.Triple;
import dev.carom.oracle.TurningQuery.Kind;
import java.util.ArrayList;
import java.util.List;

/**
 * Kinds of queries about a thing that turns. Most are made from a contact: the place, the velocity
 * and the time of one are chosen, nearly a tie in some way, and the flight comes from there.
 */
public final class TurningFamilies {
  private static final double FOREVER = Double.POSITIVE_INFINITY;

  private TurningFamilies() {}

  public static List<Family<TurningQuery>> all() {
    List<Family<TurningQuery>> first = new ArrayList<>();
    first.add(new Family<>("uniform", TurningFamilies::uniform));
    first.add(new Family<>("side", d -> query(d, new Contact(d).side(d))));
    first.add(new Family<>("end", d -> query(d, new Contact(d).end(d))));
    first.add(new Family<>("peg", d -> query(d, new Contact(d).peg(d))));
    first.add(new Family<>("graze_side", d -> query(d, new Contact(d).side(d).graze(d))));
    first.add(new Family<>("graze_end", d -> query(d, new Contact(d).end(d).graze(d))));
    first.add(new Family<>("graze_peg", d -> query(d, new Contact(d).peg(d).graze(d))));
    first.add(new Family<>("touching", d -> query(d, any(d).now(d))));
    first.add(new Family<>("overlapping", d -> query(d, any(d).now(d).inside(d))));
    first.add(new Family<>("corner", d -> query(d, new Contact(d).corner(d))));
    first.add(new Family<>("extension", d -> query(d, new Contact(d).extension(d))));
    first.add(new Family<>("fast", d -> query(d, any(d).fast(d))));
    first.add(new Family<>("slow_turn", d -> query(d, any(d).slowTurn(d))));
    first.add(new Family<>("at_rest", d -> query(d, any(d).atRest())));
    first.add(new Family<>("riding", d -> query(d, any(d).riding(d))));
    first.add(new Family<>("ray", d -> query(d, any(d).ray())));
    first.add(new Family<>("ray_now", d -> query(d, any(d).now(d).ray())));
    first.add(new Family<>("far_pivot", TurningFamilies::farPivot));
    first.add(new Family<>("supported", TurningFamilies::supported));
    first.add(new Family<>("lattice", TurningFamilies::lattice));
    first.add(new Family<>("zero_gap", TurningFamilies::zeroGap));
    first.add(new Family<>("window_end", TurningFamilies::windowEnd));
    List<Family<TurningQuery>> all = new ArrayList<>(first);
    for (Family<TurningQuery> base : first) {
      all.add(new Family<>("return_" + base.name(), d -> after(d, base.next(d))));
    }
    for (Family<TurningQuery> base : first) {
      all.add(new Family<>("entry_" + base.name(), d -> entry(d, base.next(d))));
    }
    return all;
  }

  /** A contact, from which a query is made. */
  private static final class Contact {
    Point pivot;
    double q1;
    double q2;
    Point a;
    Point b;
    double radius;
    double r;
    double end;
    double t;
    double apart;
    Point place;
    Point normal;
    double speed;
    double slip;
    Point g;
    boolean isAtRest;

    Contact(Draw d) {
      pivot = new Point(d.in(-10, 10), d.in(-10, 10));
      turn(d.sign() * d.log(1e-3, Math.PI / 2), d.log(1e-2, 10), d);
      Point along = d.direction();
      a = pivot.plus(d.chance(0.3) ? new Point(0, 0) : d.direction().times(d.log(0.01, 5)));
      b = a.plus(along.times(d.log(0.05, 10)));
      r = d.log(0.02, 2);
      t = end * d.in(0, 1);
      speed = d.log(1e-3, 100) / end;
      slip = d.sign() * d.log(1e-3, 100) / end;
      g = d.chance(0.5) ? new Point(0, 0) : d.direction().times(d.log(0.1, 30) / (end * end));
    }

    /** A turn by an angle, seen from its start or from a moment in it. */
    private void turn(double angle, double duration, Draw d) {
      double s = StrictMath.sin(angle / 4);
      q1 = -2 * s * s / duration;
      q2 = StrictMath.sin(angle / 2) / duration;
      end = duration;
      if (d.chance(0.5)) {
        double since = duration * d.in(0, 1);
        Point later = rebased(q1, q2, since);
        q1 = later.x();
        q2 = later.y();
        end -= since;
      }
    }

    private Point at(Point p) {
      return turned(p, pivot, q1, q2, t);
    }

    private double rate() {
      double x = 1 + q1 * t;
      double y = q2 * t;
      return 2 * q2 / (x * x + y * y);
    }

    Contact side(Draw d) {
      return side(d, d.in(0, 1));
    }

    private Contact side(Draw d, double part) {
      Point from = at(a);
      Point w = at(b).minus(from);
      place = from.plus(w.times(part));
      normal = w.turned().times(d.sign() / Math.hypot(w.x(), w.y()));
      return this;
    }

    Contact end(Draw d) {
      boolean isEnd = d.chance(0.5);
      place = at(isEnd ? b : a);
      Point w = place.minus(at(isEnd ? a : b));
      normal = w.times(1 / Math.hypot(w.x(), w.y())).turned(d.in(-1.57, 1.57));
      return this;
    }

    Contact peg(Draw d) {
      b = a;
      radius = d.chance(0.2) ? 0 : d.log(0.01, 1);
      place = at(a);
      normal = d.direction();
      return this;
    }

    /** As near as it gets. */
    Contact graze(Draw d) {
      speed = 0;
      apart = d.chance(0.4) ? 0 : d.sign() * d.log(1e-16, 1e-4);
      return this;
    }

    Contact now(Draw d) {
      Point from = pivot;
      double before = t;
      t = 0;
      // The place turns back with the thing.
      place = turned(place, from, q1, q2, before, true);
      normal = turned(normal, new Point(0, 0), q1, q2, before, true);
      speed = d.pick(0, 1, -1, d.sign() * d.log(1e-18, 1)) * speed;
      apart = d.pick(0, d.sign() * d.log(1e-17, 1e-12), d.log(1e-9, 1e-2));
      return this;
    }

    Contact inside(Draw d) {
      apart = -d.in(0, 1);
      return this;
    }

    /** Over an end of the line exactly, but for rounding. */
    Contact corner(Draw d) {
      side(d, d.pick(0, 1));
      place = place.plus(normal.turned().times(d.pick(0, 1e-16, -1e-16, 1e-12, -1e-12)));
      speed *= d.pick(1, 1, 0.01);
      return this;
    }

    /** At an end, nearly over it. */
    Contact extension(Draw d) {
      end(d);
      Point w = at(b).minus(at(a));
      Point across = w.turned().times(d.sign() / Math.hypot(w.x(), w.y()));
      normal = across.turned(d.sign() * d.log(1e-16, 1e-1));
      speed *= d.pick(1, 1e-3, 1e-6);
      return this;
    }

    Contact fast(Draw d) {
      speed = 1e4 * r / end * d.log(0.1, 10);
      slip = d.sign() * speed * d.log(1e-3, 10);
      return this;
    }

    Contact slowTurn(Draw d) {
      double slower = d.log(1e-14, 1e-6);
      q1 *= slower * slower;
      q2 *= slower;
      return this;
    }

    Contact atRest() {
      isAtRest = true;
      return this;
    }

    /** With the thing, or nearly. */
    Contact riding(Draw d) {
      speed *= d.pick(0, d.log(1e-16, 1e-2));
      slip *= d.pick(0, d.log(1e-16, 1e-2));
      return this;
    }

    Contact ray() {
      r = 0;
      radius = 0;
      return this;
    }
  }

  private static Contact any(Draw d) {
    Contact contact = new Contact(d);
    return d.chance(0.5) ? contact.side(d) : d.chance(0.7) ? contact.end(d) : contact.peg(d);
  }

  private static Point rebased(double q1, double q2, double t) {
    double x = 1 + q1 * t;
    double y = q2 * t;
    double n = x * x + y * y;
    return new Point((q1 + (q1 * q1 + q2 * q2) * t) / n, q2 / n);
  }

  private static Point turned(Point p, Point pivot, double q1, double q2, double t) {
    return turned(p, pivot, q1, q2, t, false);
  }

  private static Point turned(
      Point p, Point pivot, double q1, double q2, double t, boolean isBack) {
    double x = 1 + q1 * t;
    double y = isBack ? -q2 * t : q2 * t;
    double n = x * x + y * y;
    double re = (x * x - y * y) / n;
    double im = 2 * x * y / n;
    Point w = p.minus(pivot);
    return pivot.plus(new Point(w.x() * re - w.y() * im, w.x() * im + w.y() * re));
  }

  private static TurningQuery query(Draw d, Contact c) {
    Point at = c.place.plus(c.normal.times((c.r + c.radius) * (1 + c.apart)));
    Point ofThing = c.place.minus(c.pivot).turned().times(c.rate());
    Point v = ofThing.plus(c.normal.times(-c.speed)).plus(c.normal.turned().times(c.slip));
    Point g = c.g;
    if (c.isAtRest) {
      v = new Point(0, 0);
      g = v;
    }
    Point from = at.minus(v.times(c.t)).plus(g.times(c.t * c.t / 2));
    Point start = v.minus(g.times(c.t));
    double end = d.chance(0.05) ? FOREVER : c.end;
    return TurningQuery.of(
        Kind.FIRST,
        c.a.x(),
        c.a.y(),
        c.b.x(),
        c.b.y(),
        c.radius,
        from.x(),
        from.y(),
        c.r,
        start.x(),
        start.y(),
        g.x(),
        g.y(),
        c.pivot.x(),
        c.pivot.y(),
        c.q1,
        c.q2,
        -1,
        end);
  }

  private static TurningQuery uniform(Draw d) {
    Contact c = any(d);
    c.place = c.pivot.plus(d.direction().times(d.in(0, 12)));
    c.normal = d.direction();
    return query(d, c);
  }

  /**
   * A line that the circle touches exactly, or but for ulps, and a pivot so far away that nearly
   * all digits cancel.
   */
  private static TurningQuery farPivot(Draw d) {
    Triple w = d.triple();
    double scale = d.binaryScale();
    Point along = w.direction().times(scale);
    double k = d.whole(1, 3);
    boolean isSide = d.chance(0.3);
    Triple beyond = d.triple();
    Point p =
        isSide
            ? along.times(k * d.pick(0.5, 0.25, 0.75)).plus(along.turned().times(d.sign() * k))
            : beyond.direction().times(scale);
    double r = isSide ? k * w.z() * scale : beyond.z() * scale;
    Point pivot = d.direction().times(r * d.log(1e3, 1e12));
    double q2 = d.sign() * d.log(1e-12, 1e-3);
    Point material = p.minus(pivot).turned().times(2 * q2);
    Point v = material.plus(d.direction().times(d.pick(0, r * d.log(1e-9, 10))));
    double end = d.log(0.1, 10);
    double[] n = {
      0,
      0,
      along.x() * k,
      along.y() * k,
      0,
      p.x(),
      p.y(),
      r,
      v.x(),
      v.y(),
      0,
      0,
      pivot.x(),
      pivot.y(),
      -q2 * q2 * d.in(0, 1),
      q2,
      -1,
      end
    };
    n[7] = Draw.ulps(r, d.whole(-2, 2));
    return TurningQuery.of(Kind.FIRST, n);
  }

  /**
   * A line on the x axis, which the circle touches exactly. The speed is exactly that of the line;
   * in half of the queries the acceleration off it is exactly 0, too.
   */
  private static TurningQuery supported(Draw d) {
    double q1 = d.pick(0, 0, d.whole(-4, 4) / 16.0);
    double q2 = d.sign() * d.whole(1, 8) / 8.0;
    double x = d.whole(-16, 16) / 4.0;
    double r = d.whole(0, 8) / 4.0;
    double y = d.sign() * r;
    double vy = 2 * q2 * x;
    double gy = d.whole(-8, 8) / 2.0 * d.pick(0, 1);
    double vx = d.whole(-8, 8) / 4.0;
    switch (d.whole(0, 3)) {
      case 0 -> vx = q2 * y - q1 * x + gy / (4 * q2);
      case 1 -> gy = 4 * (q2 * q2 * y + q2 * vx - q1 * q2 * x);
      default -> {}
    }
    double gx = d.pick(0, d.whole(-8, 8) / 2.0);
    double from = d.whole(-24, 8) / 4.0;
    double to = from + d.whole(1, 32) / 4.0;
    double[] n = {from, 0, to, 0, 0, x, y, r, vx, vy, gx, gy, 0, 0, q1, q2, -1, d.in(0, 2)};
    d.nudgeOne(n, 0.1);
    return possible(Kind.FIRST, true, n);
  }

  private static TurningQuery lattice(Draw d) {
    Point a = d.node(4);
    Point b = d.chance(0.2) ? a : d.node(4);
    Point p = d.node(6);
    Point v = d.node(6);
    Point g = d.chance(0.5) ? new Point(0, 0) : d.node(8);
    Point pivot = d.chance(0.3) ? a : d.node(3);
    double q1 = d.pick(0, 0, d.whole(-2, 2) / 4.0);
    double q2 = d.sign() * d.pick(1, 0.5, 0.25, 2);
    return TurningQuery.of(
        Kind.FIRST,
        a.x(),
        a.y(),
        b.x(),
        b.y(),
        a.equals(b) ? d.whole(0, 2) : 0,
        p.x(),
        p.y(),
        d.whole(0, 4),
        v.x(),
        v.y(),
        g.x(),
        g.y(),
        pivot.x(),
        pivot.y(),
        q1,
        q2,
        -1,
        d.pick(1, 2, 0.5, 0, FOREVER));
  }

  /** A circle around the pivot, exactly as far from the line, or the peg, as it is large. */
  private static TurningQuery zeroGap(Draw d) {
    Triple triple = d.triple();
    boolean isPeg = d.chance(0.4);
    double scale = d.binaryScale();
    double low = isPeg ? triple.x() : -d.whole(0, 8);
    double high = isPeg ? triple.x() : low + d.whole(1, 16);
    double y = isPeg ? triple.y() : d.sign() * d.whole(0, 9);
    double r = isPeg ? triple.z() : Math.abs(y);
    double q1 = d.pick(0, -d.log(1e-3, 1));
    double q2 = d.sign() * d.log(1e-3, 1);
    double[] n = {
      low * scale,
      y * scale,
      high * scale,
      y * scale,
      0,
      0,
      0,
      r * scale,
      0,
      0,
      0,
      0,
      0,
      0,
      q1,
      q2,
      -1,
      d.pick(1, FOREVER)
    };
    d.nudgeOne(n, 0.5);
    return possible(Kind.FIRST, !isPeg, n);
  }

  /** The query of nudged numbers: no radius is below 0, a line has none, and a peg one centre. */
  private static TurningQuery possible(Kind kind, boolean isLine, double... n) {
    n[2] = isLine ? n[2] : n[0];
    n[3] = isLine ? n[3] : n[1];
    n[4] = isLine ? 0 : Math.abs(n[4]);
    n[7] = Math.abs(n[7]);
    return TurningQuery.of(kind, n);
  }

  private static TurningQuery windowEnd(Draw d) {
    TurningQuery query = query(d, any(d)).with(TurningQuery.END, FOREVER);
    double time = query.truth().time();
    return time < FOREVER
        ? query.with(TurningQuery.END, Math.max(0, Draw.ulps(time, d.whole(-2, 2))))
        : query;
  }

  /** Right after the impact, with a restitution of 0 to 1; in a tenth the query itself. */
  private static TurningQuery after(Draw d, TurningQuery query) {
    ParabolaContact contact = query.truth();
    double t = contact.time();
    if (!(t < FOREVER) || d.chance(0.1)) {
      return query.as(Kind.RETURN);
    }
    double[] n = query.numbers();
    Point pivot = new Point(query.pivotX(), query.pivotY());
    Point a = turned(new Point(n[0], n[1]), pivot, query.q1(), query.q2(), t);
    Point b = turned(new Point(n[2], n[3]), pivot, query.q1(), query.q2(), t);
    Point q = rebased(query.q1(), query.q2(), t);
    n[0] = a.x();
    n[1] = a.y();
    n[2] = query.isLine() ? b.x() : a.x();
    n[3] = query.isLine() ? b.y() : a.y();
    n[14] = q.x();
    n[15] = q.y();
    Point normal = new Point(contact.normal().x().near(), contact.normal().y().near());
    Point p =
        new Point(n[5], n[6])
            .plus(new Point(n[8], n[9]).times(t))
            .plus(new Point(n[10], n[11]).times(t * t / 2));
    Point v = new Point(n[8], n[9]).plus(new Point(n[10], n[11]).times(t));
    Point at = p.minus(normal.times(query.r())).minus(pivot);
    Point u = at.turned().times(2 * q.y());
    Point relative = v.minus(u);
    double speed = -(relative.x() * normal.x() + relative.y() * normal.y());
    double e = d.pick(0, 1, d.in(0, 1), d.log(1e-18, 1), d.log(1e-3, 1));
    Point next = v.plus(normal.times((1 + e) * speed));
    n[5] = p.x();
    n[6] = p.y();
    n[8] = next.x();
    n[9] = next.y();
    n[17] = d.chance(0.1) ? FOREVER : Math.max(0, query.end() - t);
    d.nudgeOne(n, 0.2);
    return possible(Kind.RETURN, query.isLine(), n);
  }

  /** After one of the times around the entries; in half of the queries it comes back. */
  private static TurningQuery entry(Draw d, TurningQuery query) {
    TurningQuery all = query.with(TurningQuery.END, 4 * Math.min(query.end(), 2));
    double first = all.as(Kind.ENTRY).truth().time();
    if (first < FOREVER && d.chance(0.5)) {
      // Turned round just after the impact.
      double[] n = all.numbers();
      double size = Math.hypot(n[8] + n[10] * first, n[9] + n[11] * first);
      double crossing = (query.r() + query.radius() + 1e-3) / size * d.log(0.3, 10);
      if (size > 0 && crossing < FOREVER) {
        double gx = -(n[8] + n[10] * first) / crossing;
        double gy = -(n[9] + n[11] * first) / crossing;
        n[5] += (gx - n[10]) * first * first / 2;
        n[6] += (gy - n[11]) * first * first / 2;
        n[8] -= (gx - n[10]) * first;
        n[9] -= (gy - n[11]) * first;
        n[10] = gx;
        n[11] = gy;
        all = TurningQuery.of(Kind.FIRST, n);
        if (!all.isFair()) {
          all = query;
        }
        first = all.as(Kind.ENTRY).truth().time();
      }
    }
    double after =
        switch (d.whole(0, 6)) {
          case 0 -> -1;
          case 1 -> 0;
          case 2 -> Math.nextDown(first);
          case 3 -> Math.nextUp(first);
          default -> first;
        };
    return all.with(TurningQuery.AFTER, after < FOREVER ? after : -1).as(Kind.ENTRY);
  }
}
