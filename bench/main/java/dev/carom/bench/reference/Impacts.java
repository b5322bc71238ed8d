// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;

/** The effect of an impact on the two that meet. */
final class Impacts {

  private Impacts() {}

  static void bounce(Event event) {
    Body a = event.a();
    Target target = event.target();
    Feature feature = event.contact().feature();
    a.fly(event.contact().after());
    Vec n = target.normal(a.p, feature);
    Ball bounce = Ball.of(1, a.bits).plus(a.restitution.times(target.restitution));
    Impulse impulse = impulse(n, a, bounce, target.isRound(feature), event.contact().overlapping());
    a.v = target.reflect(a.v, n, bounce);
    a.last = target;
    a.lastFeature = feature;
    Tangents.impact(impulse, a.tangents, 1, a.tangents.still(), 0);
  }

  /** {@code v1 -= m2 / (m1 + m2) J n} and {@code v2 += m1 / (m1 + m2) J n}, n = p1 - p2. */
  static void collide(Event event) {
    Body a = event.a();
    Body b = event.b();
    meet(event);
    Vec n = a.p.minus(b.p);
    Vec u = a.v.minus(b.v);
    Ball bounce = Ball.of(1, a.bits).plus(a.restitution.times(b.restitution));
    Vec push = n.times(bounce.times(u.dot(n)).over(n.dot(n)));
    Ball shareA = share(a, b);
    Ball shareB = share(b, a);
    Impulse impulse = impulse(n, u, bounce, true, event.contact().overlapping());
    a.v = a.v.minus(push.times(shareA));
    b.v = b.v.plus(push.times(shareB));
    a.last = b;
    b.last = a;
    Tangents.impact(impulse, a.tangents, shareA.head(), b.tangents, shareB.head());
  }

  /** Both fly to the contact; the one whose flight is older, to the start of the other's first. */
  private static void meet(Event event) {
    Body a = event.a();
    Body b = event.b();
    Ball after = event.contact().after();
    Ball later = b.t.minus(a.t);
    boolean second = later.head() > 0;
    a.fly(second ? later.plus(after) : after);
    b.fly(second ? after : after.minus(later));
  }

  /** The share of the velocity change that a circle takes: 0 for infinite mass. */
  private static Ball share(Body own, Body other) {
    if (own.mass == Double.POSITIVE_INFINITY || other.mass == Double.POSITIVE_INFINITY) {
      return Ball.of(own.mass == Double.POSITIVE_INFINITY ? 0 : 1, own.bits);
    }
    Ball mass = Ball.of(other.mass, own.bits);
    return mass.over(Ball.of(own.mass, own.bits).plus(mass));
  }

  /** With an obstacle. */
  private static Impulse impulse(Vec n, Body a, Ball bounce, boolean round, boolean overlapping) {
    Impulse impulse = impulse(n, a.v, bounce, round, overlapping);
    return a.gravity == null ? impulse : impulse.fallingBy(n.dot(a.gravity).head());
  }

  /** With two circles that fly straight. */
  private static Impulse impulse(Vec n, Vec u, Ball bounce, boolean round, boolean overlapping) {
    return new Impulse(
        n.x().head(),
        n.y().head(),
        u.x().head(),
        u.y().head(),
        0,
        bounce.head(),
        round,
        overlapping);
  }
}
