// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.query;

import dev.carom.internal.exact.RealRoot;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.sweep.Contact;
import dev.carom.internal.sweep.Coordinates;
import dev.carom.internal.sweep.DiskSweep;
import dev.carom.internal.sweep.Fall;
import dev.carom.internal.sweep.FallSweep;
import dev.carom.internal.sweep.Hit;

/** One circle of a world as it moves from now on, and when a cast hits it. */
final class CastTarget {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  double x;
  double y;
  double r;
  double vx;
  double vy;
  double gx;
  double gy;

  private int contact;

  /** Loads a circle as it is at a given time. */
  CastTarget load(CircleTable circles, int slot, double now) {
    x = circles.x(slot, now);
    y = circles.y(slot, now);
    r = circles.radius(slot);
    vx = circles.flightX(slot, now);
    vy = circles.flightY(slot, now);
    gx = circles.gx(slot);
    gy = circles.gy(slot);
    return this;
  }

  boolean isFalling() {
    return gx != 0 || gy != 0;
  }

  /** Whether a cast falls unlike this circle. */
  private boolean falls(MovingCircle m) {
    return m.gx != gx || m.gy != gy;
  }

  /**
   * The correctly rounded time of a cast's first contact with this circle; infinite for none up to
   * a given end. It sets {@link #contact}.
   */
  double time(MovingCircle m, double end) {
    if (m.radius + r == 0) {
      contact = Contact.MISS;
      return NEVER; // two points do not meet
    }
    if (falls(m)) {
      double t = FallSweep.time(fall(m), end);
      contact = t == 0 ? Contact.NOW : t < NEVER ? Contact.LATER : Contact.MISS;
      return t;
    }
    contact = DiskSweep.contact(m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy);
    return DiskSweep.time(contact, m.x, m.y, m.radius, m.vx, m.vy, x, y, r, vx, vy, end);
  }

  /** The contact of a cast whose time was asked for last: NOW or LATER, MISS if there is none. */
  int contact() {
    return contact;
  }

  /** The exact time of a contact. */
  RealRoot exactTime(MovingCircle m, int itsContact) {
    return falls(m)
        ? FallSweep.exact(fall(m)).first(NEVER)
        : FallSweep.exactTime(fall(m), itsContact);
  }

  /**
   * The hit at a cast's first contact.
   *
   * @param hit what is set and returned
   */
  Hit hit(MovingCircle m, Hit hit) {
    double t = m.cleared;
    hit.of(fall(m), m.contact, t);
    return isFalling()
        ? hit.moved(MovingCircle.place(0, 0, gx, t), MovingCircle.place(0, 0, gy, t))
        : hit;
  }

  /** The cast as seen from this circle, whose acceleration is taken off. */
  private Fall fall(MovingCircle m) {
    return Fall.ofThread()
        .flight(
            m.x,
            m.y,
            m.radius,
            m.vx,
            m.vy,
            Coordinates.within(m.gx - gx),
            Coordinates.within(m.gy - gy))
        .disk(x, y, r, vx, vy);
  }
}
