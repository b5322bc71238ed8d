// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import dev.carom.oracle.Draw.Point;
import java.util.List;
import java.util.stream.Stream;

/**
 * Kinds of queries about what follows a contact of a circle with a constant acceleration: the
 * return to what it has just hit, and its second way into the same thing.
 */
public final class ParabolaNextFamilies {
  private ParabolaNextFamilies() {}

  /** From every family with a circle or a line: the moment after the impact. */
  public static List<Family<ParabolaQuery>> ofReturns() {
    Stream<Family<ParabolaQuery>> after =
        still().map(base -> new Family<>("return_" + base.name(), d -> after(d, base.next(d))));
    return Stream.concat(after, Stream.of(halfwayToASide())).toList();
  }

  /**
   * Back at the side of a line halfway between two doubles, up to about 2^-106 of the terms: the
   * velocity of the disk less that of the line has so many bits.
   */
  public static Family<ParabolaQuery> halfwayToASide() {
    return new Family<>("return_halfway_side", ParabolaNextFamilies::halfwayToASide);
  }

  private static ParabolaQuery halfwayToASide(Draw d) {
    Point w = d.direction().times(d.log(1, 10));
    Point n = w.turned().times(1 / Math.hypot(w.x(), w.y()));
    double t = d.in(0.5, 1);
    Point g = n.turned(d.in(-1, 1)).times(-d.log(1, 10));
    double sx = d.in(-1, 1);
    // 2 cross(w, s) = t cross(g, w)
    Dyadic middle = Dyadic.of(t).plus(Dyadic.of(Math.ulp(t)).shift(-1));
    Dyadic fall = Vector.of(g.x(), g.y()).cross(Vector.of(w.x(), w.y()));
    Dyadic rest = middle.times(fall).shift(-1).plus(Dyadic.of(w.y()).times(Dyadic.of(sx)));
    Dyadic sy = rest.over(Dyadic.of(w.x()), 160);
    double vy = sy.near();
    double uy = Dyadic.of(vy).minus(sy).near();
    double r = d.in(0.5, 2);
    Point p = w.times(0.5).plus(n.times(r));
    Query q =
        new MovingLineQuery(
            0, 0, w.x(), w.y(), p.x(), p.y(), r, sx, vy, 0, uy, Double.POSITIVE_INFINITY);
    return new ParabolaQuery(q, g.x(), g.y());
  }

  /** From every family with a circle or a line: through it, and back again. */
  public static List<Family<ParabolaQuery>> ofEntries() {
    return still()
        .map(base -> new Family<>("entry_" + base.name(), d -> through(d, base.next(d))))
        .toList();
  }

  private static Stream<Family<ParabolaQuery>> still() {
    return Stream.concat(ParabolaFamilies.all().stream(), ParabolaFamilies.ofMovingLines().stream())
        .filter(family -> !family.name().matches("(wall|halfway_wall|ceiling|no_gravity).*"))
        .map(family -> new Family<>(family.name(), d -> withoutWalls(d, family)));
  }

  private static ParabolaQuery withoutWalls(Draw d, Family<ParabolaQuery> family) {
    ParabolaQuery query = family.next(d);
    while (query.straight() instanceof WallQuery) {
      query = family.next(d);
    }
    return query;
  }

  /**
   * The numbers of a query in which the first circle is at a place with a velocity, and the other
   * thing where it is at a time.
   */
  private static double[] moved(ParabolaQuery query, double t, Point velocity) {
    double[] n = query.straight().numbers();
    boolean isLine = !(query.straight() instanceof PairQuery);
    int p = isLine ? 4 : 0;
    int v = isLine ? 7 : 3;
    for (int axis = 0; axis < 2; axis++) {
      double g = axis == 0 ? query.gx() : query.gy();
      n[p + axis] += n[v + axis] * t + g * t * t / 2;
      n[v + axis] = axis == 0 ? velocity.x() : velocity.y();
      if (query.straight() instanceof PairQuery) {
        n[5 + axis] += n[8 + axis] * t;
      } else if (query.straight() instanceof MovingLineQuery) {
        n[axis] += n[9 + axis] * t;
        n[2 + axis] += n[9 + axis] * t;
      }
    }
    return n;
  }

  private static Point velocity(ParabolaQuery query, double t) {
    double[] n = query.straight().numbers();
    int v = query.straight() instanceof PairQuery ? 3 : 7;
    return new Point(n[v] + query.gx() * t, n[v + 1] + query.gy() * t);
  }

  private static Point velocityOfOther(ParabolaQuery query) {
    double[] n = query.straight().numbers();
    return query.straight() instanceof PairQuery
        ? new Point(n[8], n[9])
        : query.straight() instanceof MovingLineQuery ? new Point(n[9], n[10]) : new Point(0, 0);
  }

  private static ParabolaQuery endless(ParabolaQuery query) {
    double[] n = query.straight().numbers();
    n[n.length - 1] = Double.POSITIVE_INFINITY;
    return new ParabolaQuery(query.straight().with(n), query.gx(), query.gy());
  }

  /** Right after the impact, with a restitution of 0 to 1; in a tenth the query itself. */
  private static ParabolaQuery after(Draw d, ParabolaQuery query) {
    ParabolaContact contact = endless(query).truth();
    double t = contact.time();
    if (!(t < Double.POSITIVE_INFINITY) || d.chance(0.1)) {
      return query;
    }
    Point normal = new Point(contact.normal().x().near(), contact.normal().y().near());
    Point v = velocity(query, t);
    Point u = v.minus(velocityOfOther(query));
    double speed = -(u.x() * normal.x() + u.y() * normal.y());
    double e = d.pick(0, 1, d.in(0, 1), d.log(1e-18, 1), d.log(1e-3, 1));
    double[] n = moved(query, t, v.plus(normal.times((1 + e) * speed)));
    n[n.length - 1] = d.pick(n[n.length - 1], t, Double.POSITIVE_INFINITY);
    d.nudgeOne(n, 0.2);
    int r = query.straight() instanceof PairQuery ? 2 : 6;
    n[r] = Math.abs(n[r]);
    if (query.straight() instanceof PairQuery) {
      n[7] = Math.abs(n[7]);
    }
    return new ParabolaQuery(query.straight().with(n), query.gx(), query.gy());
  }

  /**
   * The acceleration is against the velocity at the impact, so that the circle comes back to it; in
   * a tenth the query itself.
   */
  private static ParabolaQuery through(Draw d, ParabolaQuery query) {
    ParabolaContact contact = endless(query).truth();
    double t = contact.time();
    if (!(t < Double.POSITIVE_INFINITY) || d.chance(0.1)) {
      return query;
    }
    Point u = velocity(query, t).minus(velocityOfOther(query));
    double[] n = query.straight().numbers();
    int size = query.straight() instanceof PairQuery ? 2 : 6;
    double speed = Math.hypot(u.x(), u.y());
    double crossing = n[size] / speed * d.log(0.3, 30);
    Point g = u.times(-1 / crossing).turned(d.chance(0.3) ? 0 : d.in(-0.3, 0.3));
    Point v = velocity(query, t);
    double before = d.chance(0.2) ? 0 : crossing * d.in(0, 1);
    double[] at = moved(query, t, v);
    int p = query.straight() instanceof PairQuery ? 0 : 4;
    Point start =
        new Point(at[p], at[p + 1]).minus(u.times(before)).plus(g.times(before * before / 2));
    at[p] = start.x();
    at[p + 1] = start.y();
    at[p + 3] = v.x() - g.x() * before;
    at[p + 4] = v.y() - g.y() * before;
    at[at.length - 1] = d.pick(Double.POSITIVE_INFINITY, 4 * crossing);
    return new ParabolaQuery(query.straight().with(at), g.x(), g.y());
  }
}
