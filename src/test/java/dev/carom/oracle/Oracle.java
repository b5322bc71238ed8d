// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.List;

/**
 * The contract of contact, taken literally: the smallest t in [0, T] with distance <= radius and
 * the distance falling. All the moments at which a distance can become the radius are written down
 * as exact algebraic numbers, one for each feature, and each is asked whether the centre is then in
 * the region where that feature is the nearest. No cleverness: because the distance to a convex
 * obstacle is convex in time, at most one of them can pass, and that is asserted.
 */
public final class Oracle {
  private Oracle() {}

  /** A circle against a line a-b. */
  public static Contact line(SegmentQuery q) {
    Vector p = Vector.of(q.px(), q.py());
    Vector a = Vector.of(q.ax(), q.ay());
    Vector w = Vector.of(q.bx(), q.by()).minus(a);
    Vector v = Vector.of(q.vx(), q.vy());
    return new LineContact(p.minus(a), w, v, Dyadic.of(q.r())).first().within(q.end());
  }

  /** A circle against a line a-b, both moving. */
  public static Contact movingLine(MovingLineQuery q) {
    Vector p = Vector.of(q.px(), q.py());
    Vector a = Vector.of(q.ax(), q.ay());
    Vector w = Vector.of(q.bx(), q.by()).minus(a);
    Vector v = Vector.of(q.vx(), q.vy()).minus(Vector.of(q.ux(), q.uy()));
    return new LineContact(p.minus(a), w, v, Dyadic.of(q.r())).first().within(q.end());
  }

  /** Two moving circles; the second may rest, then it is a peg. */
  public static Contact pair(PairQuery q) {
    Vector e = Vector.of(q.x1(), q.y1()).minus(Vector.of(q.x2(), q.y2()));
    Vector v = Vector.of(q.vx1(), q.vy1()).minus(Vector.of(q.vx2(), q.vy2()));
    Dyadic radius = Dyadic.of(q.r1()).plus(Dyadic.of(q.r2()));
    return circle(Part.CIRCLE, e, v, radius).within(q.end());
  }

  /** A circle within four walls: the first of them that is hit. */
  public static Contact bounds(WallQuery q) {
    Dyadic r = Dyadic.of(q.r());
    Vector v = Vector.of(q.vx(), q.vy());
    Vector low = Vector.of(q.px(), q.py()).minus(Vector.of(q.xmin(), q.ymin()));
    Vector high = Vector.of(q.xmax(), q.ymax()).minus(Vector.of(q.px(), q.py()));
    Dyadic one = Dyadic.ONE;
    Dyadic zero = Dyadic.ZERO;
    List<Contact> walls =
        List.of(
            wall(low.x(), v.x(), r, new Vector(one, zero)).within(q.end()),
            wall(high.x(), v.x().negate(), r, new Vector(one.negate(), zero)).within(q.end()),
            wall(low.y(), v.y(), r, new Vector(zero, one)).within(q.end()),
            wall(high.y(), v.y().negate(), r, new Vector(zero, one.negate())).within(q.end()));
    return earliest(walls);
  }

  /** The wall that is hit first; of those that are hit at once, the first one of the list. */
  private static Contact earliest(List<Contact> walls) {
    return walls.stream()
        .filter(Contact::hit)
        .min((first, second) -> first.moment().compareTo(second.moment()))
        .orElse(Contact.MISS);
  }

  /** A half-plane at signed distance s of the centre, which changes by u per unit of time. */
  private static Contact wall(Dyadic s, Dyadic u, Dyadic r, Vector normal) {
    if (u.signum() >= 0) {
      return Contact.MISS;
    }
    // s + u t = r
    Dyadic gap = s.minus(r);
    Moment t = gap.signum() <= 0 ? Moment.ZERO : new Moment(Surd.of(gap), u.negate());
    return new Contact(Part.SIDE, t, Normal.along(normal));
  }

  /** A point at offset e from a static circle of radius r around the origin, moving with v. */
  static Contact circle(Part part, Vector e, Vector v, Dyadic r) {
    if (e.squared().compareTo(r.square()) <= 0) {
      // d|e|/dt = e.v / |e|, and at the centre itself the distance cannot fall
      boolean falling = e.dot(v).signum() < 0;
      return falling ? new Contact(part, Moment.ZERO, Normal.along(e)) : Contact.MISS;
    }
    Moment t = firstRoot(e, v, r);
    return t == null ? Contact.MISS : circleAt(part, t, e, v, r);
  }

  /** The contact at a root that is greater than 0. */
  static Contact circleAt(Part part, Moment t, Vector e, Vector v, Dyadic r) {
    // At the end of the path of a point into a point the offset is 0: its limit from before is -v.
    Normal normal = r.signum() == 0 ? Normal.along(v.negate()) : Normal.at(t, e, v, r);
    return new Contact(part, t, normal);
  }

  /**
   * The time at which {@code |e + v t|} comes down to r; null if it never does, or only touches r.
   */
  static Moment firstRoot(Vector e, Vector v, Dyadic r) {
    // |e + v t|^2 = r^2  <=>  a t^2 - 2 b t + c = 0,  t = (b - sqrt(b^2 - a c)) / a
    Dyadic a = v.squared();
    Dyadic b = e.dot(v).negate();
    Dyadic c = e.squared().minus(r.square());
    Dyadic discriminant = b.square().minus(a.times(c));
    boolean reached = r.signum() == 0 ? discriminant.signum() >= 0 : discriminant.signum() > 0;
    if (b.signum() <= 0 || !reached) {
      return null;
    }
    return new Moment(new Surd(b, Dyadic.ONE.negate(), discriminant), a);
  }
}
