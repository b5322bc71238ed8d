// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.ArrayList;
import java.util.List;

/**
 * The contact of a circle with the segment from the origin to w: centre e + v t, radius r. The
 * projection of the centre on the line divides the plane: at or before the start, at or beyond the
 * end, strictly between them. In each division the distance has its own formula, and each moment
 * lies in exactly one.
 */
final class LineContact {
  private final Vector e;
  private final Vector w;
  private final Vector v;
  private final Dyadic r;
  private final Dyadic ww;

  LineContact(Vector e, Vector w, Vector v, Dyadic r) {
    this.e = e;
    this.w = w;
    this.v = v;
    this.r = r;
    this.ww = w.squared();
  }

  /** The first contact at any time. */
  Contact first() {
    Part part = partAt(Moment.ZERO);
    return touches(part) ? now(part) : later();
  }

  /** The nearest feature at a moment: where the projection w.(e + v t) lies in 0..w.w. */
  private Part partAt(Moment t) {
    Dyadic along = w.dot(e);
    Dyadic speed = w.dot(v);
    if (t.linear(along, speed).sign() <= 0) {
      return Part.START;
    }
    return t.linear(along.minus(ww), speed).sign() >= 0 ? Part.END : Part.SIDE;
  }

  /** Whether the distance at time 0, to the feature that is then the nearest, is at most r. */
  private boolean touches(Part part) {
    if (part == Part.SIDE) {
      return w.cross(e).square().compareTo(r.square().times(ww)) <= 0;
    }
    return offset(part).squared().compareTo(r.square()) <= 0;
  }

  /** A touching or overlapping start: an impact at 0 if the distance falls, else none. */
  private Contact now(Part part) {
    if (part != Part.SIDE) {
      return Oracle.circle(part, offset(part), v, r);
    }
    // The distance is |w x (e + v t)| / |w|; it falls if w x e and w x v have opposite signs.
    boolean falling = w.cross(e).signum() * w.cross(v).signum() < 0;
    return falling ? contact(Part.SIDE, Moment.ZERO) : Contact.MISS;
  }

  /**
   * A start without touch: of the moments of all three features the one that is in its division.
   */
  private Contact later() {
    List<Contact> valid = new ArrayList<>();
    for (Part part : List.of(Part.SIDE, Part.START, Part.END)) {
      Moment t = part == Part.SIDE ? sideMoment() : Oracle.firstRoot(offset(part), v, r);
      if (t != null && t.sign() > 0 && partAt(t) == part && falling(part)) {
        valid.add(contact(part, t));
      }
    }
    if (valid.size() > 1) {
      throw new IllegalStateException("a convex distance fell to the radius twice: " + valid);
    }
    return valid.isEmpty() ? Contact.MISS : valid.get(0);
  }

  /** When the centre comes down to the distance r from the infinite line; null if never. */
  private Moment sideMoment() {
    Dyadic c = w.cross(e);
    Dyadic speed = w.cross(v);
    if (c.signum() * speed.signum() >= 0) {
      return null;
    }
    // |c| - |speed| t = r |w|
    return new Moment(new Surd(c.abs(), r.negate(), ww), speed.abs());
  }

  /**
   * Whether the distance falls into a root of that feature. Only a point that runs along the line
   * has roots into which it does not: there the distance was 0 before.
   */
  private boolean falling(Part part) {
    return w.cross(e).signum() != 0 || partBefore(part) == part;
  }

  /**
   * The nearest feature just before a contact of radius 0 with the given one. At an end of the line
   * the projection is then 0 or w.w itself, and the velocity says from which side it came.
   */
  private Part partBefore(Part part) {
    int along = w.dot(v).signum();
    boolean fromSide = (part == Part.START && along < 0) || (part == Part.END && along > 0);
    return fromSide ? Part.SIDE : part;
  }

  /** The contact at a moment; the normal of a point is that of the feature it came from. */
  private Contact contact(Part part, Moment t) {
    Part source = r.signum() == 0 && t.sign() > 0 ? partBefore(part) : part;
    if (source != Part.SIDE) {
      return Oracle.circleAt(part, t, offset(part), v, r);
    }
    Vector left = w.turned();
    Vector normal = w.cross(e).signum() > 0 ? left : left.negate();
    return new Contact(part, t, Normal.along(normal));
  }

  /** From an end of the line to the centre, at time 0. */
  private Vector offset(Part part) {
    return part == Part.END ? e.minus(w) : e;
  }
}
