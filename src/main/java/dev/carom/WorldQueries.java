// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.engine.Engine;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.ObstacleShape;

/** Tells of the things in a world. */
final class WorldQueries {

  /** The number of records of traits that are kept, a power of two. */
  private static final int KNOWN = 64;

  private static final int KNOWN_SHIFT = Long.SIZE - 6;

  /** So many places are tried. */
  private static final int PROBES = 8;

  /** 2^64 over the golden ratio, which spreads the bits. */
  private static final long HASH = 0x9E3779B97F4A7C15L;

  private final Traits[] known = new Traits[KNOWN];

  private final ObstacleTable obstacles;
  private final CircleTable circles;
  private final CircleRegistry registry;

  WorldQueries(Engine engine, CircleRegistry registry) {
    this.registry = registry;
    obstacles = engine.staticScene.obstacles;
    circles = engine.circles;
  }

  /** Returns a circle or an obstacle as it is now. */
  Obstacle shape(int code, double now) {
    int slot = Codes.slot(code);
    return Codes.isCircle(code)
        ? new Circle(Vec2.within(circles.x(slot, now), circles.y(slot, now)), circles.radius(slot))
        : PublicRecords.of(obstacles, code, now);
  }

  Traits traits(int code) {
    if (!Codes.isCircle(code)) {
      double restitution = obstacles.givenRestitution(code);
      return traits(restitution, 1, obstacles.traits(code), obstacles.filter(code));
    }
    int slot = Codes.slot(code);
    double restitution = circles.restitution(slot);
    return traits(restitution, registry.mass(slot), registry.traits(slot), registry.filter(slot));
  }

  /** Returns a record of given traits, the same one again as long as it is known. */
  private Traits traits(double restitution, double mass, int flags, long filter) {
    long bits = Double.doubleToLongBits(restitution) + 31 * Double.doubleToLongBits(mass);
    long mixed = (((bits + flags) * HASH) ^ filter) * HASH;
    int first = (int) (mixed >>> KNOWN_SHIFT);
    for (int k = first; k < first + PROBES; k++) {
      Traits some = known[k & (KNOWN - 1)];
      if (some == null) {
        known[k & (KNOWN - 1)] = Traits.of(restitution, mass, flags, filter);
        return known[k & (KNOWN - 1)];
      }
      if (some.are(restitution, mass, flags, filter)) {
        return some;
      }
    }
    known[first] = Traits.of(restitution, mass, flags, filter);
    return known[first];
  }

  Vec2 velocity(int code, double now) {
    if (Codes.isCircle(code)) {
      return new Vec2(circles.vx(Codes.slot(code), now), circles.vy(Codes.slot(code), now));
    }
    if (obstacles.arrival(code) <= now) {
      return Vec2.ZERO;
    }
    if (!obstacles.turns(code)) {
      return new Vec2(obstacles.ux(code), obstacles.uy(code));
    }
    double[] row = obstacles.rowAt(code, now, 0);
    return Vec2.within(
        obstacles.velocityX(code, row[ObstacleShape.Y], now, 0),
        obstacles.velocityY(code, row[ObstacleShape.X], now, 0));
  }

  /** Tells whether a circle is carried, and moves as what carries it. */
  boolean isResting(int slot, double now) {
    if (circles.isMember(slot)) {
      return !circles.isAwake(slot);
    }
    if (!circles.isSupported(slot) || circles.gx(slot) != 0 || circles.gy(slot) != 0) {
      return false;
    }
    int support = circles.support(slot);
    double ux = obstacles.ux(support);
    double uy = obstacles.uy(support);
    return circles.vx(slot, now) == ux && circles.vy(slot, now) == uy;
  }

  int[] ids(Kind kind) {
    return kind == Kind.CIRCLE ? registry.ids() : obstacles.ids(kind.ordinal());
  }

  /** Returns a circle with its motion now. */
  SweptCircle flight(int slot, double now) {
    return new SweptCircle(
        circles.x(slot, now),
        circles.y(slot, now),
        circles.radius(slot),
        circles.flightX(slot, now),
        circles.flightY(slot, now),
        circles.gx(slot),
        circles.gy(slot));
  }
}
