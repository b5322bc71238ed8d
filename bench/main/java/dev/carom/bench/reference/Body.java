// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Circle;
import dev.carom.Feature;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Vec2;

/** One circle in flight: where it was at a time, and how it moves since. */
final class Body {

  /** A place must be known to this part of the scene, or plain doubles could not look ahead. */
  private static final double TIGHT = 0x1p-45;

  final int id;
  final int bits;
  final double mass;
  final Ball radius;
  final Ball restitution;

  Vec p;
  Vec v;
  Ball t;

  /** The gravity of the scene; null if circles fly straight. */
  final Vec gravity;

  /** The target or the body that was hit last: it is not there for this flight. */
  Object last;

  /** The part of it that was hit: a circle that falls can come back to it. */
  Feature lastFeature;

  Tangents tangents;
  CircleFrames course;

  private boolean inDoubles;

  /** Puts a circle of the scene at its start; its start values are those from the first one on. */
  Body(Scene scene, int id, int bits, int frames, int values, int first) {
    this.id = id;
    this.bits = bits;
    Circle circle = (Circle) scene.shape(Kind.CIRCLE, id);
    Vec2 velocity = scene.velocity(Kind.CIRCLE, id);
    mass = scene.traits(Kind.CIRCLE, id).mass();
    radius = Ball.of(circle.radius(), bits);
    restitution = Ball.of(scene.traits(Kind.CIRCLE, id).restitution(), bits);
    p = Vec.of(circle.x(), circle.y(), bits);
    v = Vec.of(velocity.x(), velocity.y(), bits);
    t = Ball.of(0, bits);
    Vec2 g = scene.gravity();
    gravity = g.equals(Vec2.ZERO) ? null : Vec.of(g.x(), g.y(), bits);
    tangents = new Tangents(values, first, circle.x(), circle.y(), velocity.x(), velocity.y());
    course = new CircleFrames(frames);
  }

  /** From now on each flight starts at the doubles that are nearest to its place. */
  void keepPlacesInDoubles() {
    inDoubles = true;
  }

  Vec at(Ball dt) {
    return gravity == null ? p.plus(v.times(dt)) : fall().at(dt);
  }

  Vec velocityAt(Ball dt) {
    return gravity == null ? v : v.plus(gravity.times(dt));
  }

  /** The path of a circle under gravity. */
  Fall fall() {
    return new Fall(p, v, gravity);
  }

  /** Goes to a new start of a flight. */
  void fly(Ball dt) {
    Vec place = at(dt);
    p = inDoubles ? Vec.of(place.x().rounded(), place.y().rounded(), bits) : place;
    v = velocityAt(dt);
    t = t.plus(dt);
    tangents.fly(dt.head());
  }

  /** Turns round at a given time and goes back, from the clock's start. */
  void turnBack(double time, int frames) {
    fly(Ball.of(time, bits).minus(t));
    v = v.negate();
    t = Ball.of(0, bits);
    last = null;
    lastFeature = null;
    course = new CircleFrames(frames);
  }

  boolean isAtRest() {
    return v.dot(v).sign() == 0;
  }

  /** Refuses a place or a velocity too little known for doubles to look ahead from it. */
  void checkTight() {
    if (!isTight(p, p.size() + radius.head()) || !isTight(v, v.size())) {
      throw new DoubtException();
    }
  }

  /** Whether the errors of a vector are negligible beside a size. */
  static boolean isTight(Vec v, double size) {
    return v.x().error() + v.y().error() <= size * TIGHT;
  }
}
